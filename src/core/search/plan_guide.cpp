// SPDX-License-Identifier: BSD-3-Clause
#include "core/search/plan_guide.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/util/nearest_pose.hpp"

namespace hidwa_local_planner {
namespace {

constexpr double kRejoin = 2.0;      // R [m]
constexpr double kTurnsFirst = 0.3;  // share of the time of a turn that counts, from 1 m on

// A plan that ends so near to the goal ends there [m].
constexpr double kAtGoal = 0.1;

// Slower robots count as so fast [m/s], [rad/s].
constexpr double kSlowest = 0.05;

}  // namespace

void PlanGuide::prepare(const std::vector<Pose2>& plan, const Pose2& goal, const Pose2& here,
                        const VelocityLimits& limits, double ahead) {
  points_.clear();
  if (plan.empty()) return;
  inverse_speed_ = 1.0 / std::max(kSlowest, limits.x.fastest());
  turn_weight_ = 0.5 * M_PI * kTurnsFirst / std::max(kSlowest, limits.theta.fastest());
  const auto nearest = static_cast<std::size_t>(nearest_pose(plan, here) - plan.begin());
  // All but the last, for a plan that goes on straight.
  const double apart = ahead / static_cast<double>(kMost - 3);
  double way = 0.0;
  points_.push_back({plan[nearest].x, plan[nearest].y, 0.0, 1.0, 0.0});
  std::size_t i = nearest;
  for (double since = 0.0; i + 1 < plan.size() && way < ahead && points_.size() + 2 < kMost; ++i) {
    const double step = distance(plan[i], plan[i + 1]);
    way += step;
    since += step;
    if (since <= 0.0 || (since < apart && i + 2 < plan.size())) continue;  // a repeated pose leads nowhere
    points_.push_back({plan[i + 1].x, plan[i + 1].y, way, 1.0, 0.0});
    since = 0.0;
  }
  ends_ = i + 1 >= plan.size() && distance(plan.back(), goal) < kAtGoal;
  direct();
  if (!ends_ && points_.size() > 1) {
    const Station& last = points_.back();
    const double on = std::max(0.0, ahead - way) + apart;
    points_.push_back(
        {last.x + on * last.forward_x, last.y + on * last.forward_y, way + on, last.forward_x, last.forward_y});
  }
  const double whole = points_.back().left;
  for (Station& point : points_) point.left = whole - point.left;
}

// Each goes on towards the next one, the last one as the one before.
void PlanGuide::direct() {
  for (std::size_t k = 0; k + 1 < points_.size(); ++k) {
    const double dx = points_[k + 1].x - points_[k].x, dy = points_[k + 1].y - points_[k].y;
    const double length = std::hypot(dx, dy);
    if (length > 0.0) {
      points_[k].forward_x = dx / length;
      points_[k].forward_y = dy / length;
    }
  }
  if (points_.size() > 1) {
    points_.back().forward_x = points_[points_.size() - 2].forward_x;
    points_.back().forward_y = points_[points_.size() - 2].forward_y;
  }
}

double PlanGuide::time_left(double x, double y, const Rotation& heading) const {
  const Projection at = project(x, y);
  const double direct = std::sqrt(at.join_x * at.join_x + at.join_y * at.join_y);
  const double cosine = direct > 0.0 ? (heading.c * at.join_x + heading.s * at.join_y) / direct : 1.0;
  return at.way * inverse_speed_ + turn_weight_ * std::min(at.left, 1.0) * (1.0 - cosine);
}

double PlanGuide::least_left(double x, double y, double way) const {
  return std::max(0.0, project(x, y).way - way) * inverse_speed_;
}

// On the nearest stretch between two stations, or beyond its ends.
PlanGuide::Projection PlanGuide::project(double x, double y) const {
  double least = std::numeric_limits<double>::infinity(), along = 0.0, left = 0.0;
  const Station* at = &points_.front();
  for (std::size_t k = 0; k + 1 < points_.size(); ++k) {
    const Station& from = points_[k];
    const double dx = x - from.x, dy = y - from.y, length = from.left - points_[k + 1].left;
    const double on = std::clamp(dx * from.forward_x + dy * from.forward_y, 0.0, length);
    const double ox = dx - on * from.forward_x, oy = dy - on * from.forward_y;
    const double off = ox * ox + oy * oy;
    if (off < least) {
      least = off;
      at = &from;
      along = on;
      left = from.left - on;
    }
  }
  const double join = std::min(kRejoin, std::max(left, 0.25 * kRejoin));
  return {left, left + std::sqrt(least + join * join) - join, at->x + (along + join) * at->forward_x - x,
          at->y + (along + join) * at->forward_y - y};
}

}  // namespace hidwa_local_planner
