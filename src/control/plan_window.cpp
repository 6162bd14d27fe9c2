// SPDX-License-Identifier: BSD-3-Clause
#include "hidwa_local_planner/control/plan_window.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace hidwa_local_planner {
namespace {

// How far ahead of the progress a nearer stretch of the plan may be found [m]: more than a cycle's travel and a
// replan's offset, less than the way round a loop.
constexpr double kSearchAhead = 2.0;

struct Projection {
  double arc = 0.0;        // [m]
  double distance2 = 0.0;  // [m^2]
};

Projection project(const Pose2& a, const Pose2& b, double arc_a, double arc_b, const Pose2& q) {
  const double dx = b.x - a.x;
  const double dy = b.y - a.y;
  const double length2 = dx * dx + dy * dy;
  double t = 0.0;
  if (length2 > 0.0) t = std::clamp(((q.x - a.x) * dx + (q.y - a.y) * dy) / length2, 0.0, 1.0);
  const double ex = a.x + t * dx - q.x;
  const double ey = a.y + t * dy - q.y;
  return {arc_a + t * (arc_b - arc_a), ex * ex + ey * ey};
}

}  // namespace

void PlanWindow::set_plan(std::vector<Pose2> plan) {
  plan_ = std::move(plan);
  arc_.assign(plan_.size(), 0.0);
  for (std::size_t i = 1; i < plan_.size(); ++i) arc_[i] = arc_[i - 1] + distance(plan_[i - 1], plan_[i]);
  progress_ = -1.0;
}

PlanWindow::Range PlanWindow::around(const Pose2& robot, double behind, double ahead) {
  if (plan_.empty()) return {};
  // The first query searches the whole plan: a host may hand over a plan that starts behind the robot.
  const bool first = progress_ < 0.0;
  const double from = first ? 0.0 : progress_;
  const double to = first ? arc_.back() : progress_ + kSearchAhead;
  Projection best{from, std::numeric_limits<double>::infinity()};
  for (std::size_t i = 0; i + 1 < plan_.size() && arc_[i] <= to; ++i) {
    if (arc_[i + 1] < from) continue;
    const Projection p = project(plan_[i], plan_[i + 1], arc_[i], arc_[i + 1], robot);
    if (p.distance2 < best.distance2 - 1e-12) best = p;
  }
  progress_ = std::max(from, std::min(best.arc, to));

  Range range{plan_.size() - 1, plan_.size()};
  const auto begin = std::lower_bound(arc_.begin(), arc_.end(), progress_ - behind - 1e-9);
  const auto end = std::upper_bound(arc_.begin(), arc_.end(), progress_ + ahead + 1e-9);
  range.begin = std::min(static_cast<std::size_t>(begin - arc_.begin()), plan_.size() - 1);
  range.end = std::max(static_cast<std::size_t>(end - arc_.begin()), range.begin + 1);
  return range;
}

std::size_t PlanWindow::next_pose() const {
  return static_cast<std::size_t>(std::lower_bound(arc_.begin(), arc_.end(), progress_ - 1e-9) - arc_.begin());
}

}  // namespace hidwa_local_planner
