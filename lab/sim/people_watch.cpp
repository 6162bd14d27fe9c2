// SPDX-License-Identifier: BSD-3-Clause
#include "sim/people_watch.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace hidwa_local_planner {
namespace sim {
namespace {

// The point of a polygon's border that is nearest to `p`.
Eigen::Vector2d nearest_on_border(const Polygon& polygon, const Eigen::Vector2d& p) {
  Eigen::Vector2d best = polygon.front();
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const Eigen::Vector2d along = polygon[i] - polygon[j];
    const double squared = along.squaredNorm();
    const double t = squared > 0.0 ? std::clamp((p - polygon[j]).dot(along) / squared, 0.0, 1.0) : 0.0;
    const Eigen::Vector2d q = polygon[j] + t * along;
    if ((q - p).squaredNorm() < (best - p).squaredNorm()) best = q;
  }
  return best;
}

double gap_to(const Polygon& placed, const Mover& mover) {
  if (contains(placed, mover.position)) return 0.0;
  return std::max(0.0, (nearest_on_border(placed, mover.position) - mover.position).norm() - mover.radius);
}

double outermost_speed(const Velocity& velocity, double radius) {
  return std::abs(velocity.v) + std::abs(velocity.omega) * radius;
}

}  // namespace

PeopleWatch::PeopleWatch(Polygon outline) : outline_(std::move(outline)), radius_(circumscribed_radius(outline_)) {}

void PeopleWatch::add(double time, double dt, const Pose& pose, const Velocity& velocity,
                      const std::vector<Mover>& movers) {
  constexpr double kAway = 1.5;  // [m]; who was farther away begins a new stay
  const bool moves = outermost_speed(velocity, radius_) > kMoves;
  if (!moves) standing_ += dt;
  if (movers.empty()) return;
  past_.resize(movers.size());
  const Polygon placed = transformed(outline_, pose);
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < movers.size(); ++k) {
    Past& past = past_[k];
    const double centres = (movers[k].position - Eigen::Vector2d(pose.x, pose.y)).norm();
    const bool far = centres - radius_ - movers[k].radius > kAway;  // then the gap is larger still
    const double gap = far ? centres - radius_ - movers[k].radius : gap_to(placed, movers[k]);
    nearest = std::min(nearest, gap);
    if (gap > kAway) past.met = false;
    if (gap < kEncounter && moves && !past.met) {
      past.met = true;
      ++encounters_;
    }
    if (gap <= 0.0 && !past.touching) {
      touches_.push_back(touch(time, pose, velocity, movers[k]));
      if (touches_.back().robot_moved) ++moving_;
    }
    past.touching = gap <= 0.0;
  }
  closest_ = std::min(closest_, nearest);
  if (moves && nearest < kPersonalSpace) personal_space_ += dt;
}

Touch PeopleWatch::touch(double time, const Pose& pose, const Velocity& velocity, const Mover& mover) const {
  Touch touch;
  touch.time = time;
  touch.id = mover.id;
  touch.robot_speed = outermost_speed(velocity, radius_);
  touch.robot_moved = touch.robot_speed > kMoves;
  touch.speed = mover.velocity.norm();
  touch.since_leap = time - mover.leapt;
  // How fast each comes nearer to the other, at the robot's point that is nearest.
  const Eigen::Vector2d point = nearest_on_border(transformed(outline_, pose), mover.position);
  const Eigen::Vector2d arm = point - Eigen::Vector2d(pose.x, pose.y);
  const Eigen::Vector2d of_robot = velocity.v * Eigen::Vector2d(std::cos(pose.theta), std::sin(pose.theta)) +
                                   velocity.omega * Eigen::Vector2d(-arm.y(), arm.x());
  const Eigen::Vector2d to = (mover.position - point).normalized();
  const double robot_comes = of_robot.dot(to), mover_comes = -mover.velocity.dot(to);
  touch.by_robot = touch.robot_moved && robot_comes > 0.0 && robot_comes > mover_comes;
  return touch;
}

}  // namespace sim
}  // namespace hidwa_local_planner
