// SPDX-License-Identifier: BSD-3-Clause
#include "hidwa_local_planner/ros/goal_succession.hpp"

#include <algorithm>
#include <cmath>

namespace hidwa_local_planner {
namespace {

// A plan may end at the cell of its goal rather than at the goal.
constexpr double kSamePlace = 0.1;     // [m]
constexpr double kSameHeading = 1e-3;  // [rad]

bool same_place(const FramedGoal& a, const FramedGoal& b) {
  return a.frame == b.frame && distance(a.pose, b.pose) <= kSamePlace &&
         std::abs(wrap_angle(a.pose.theta - b.pose.theta)) <= kSameHeading;
}

}  // namespace

void GoalSuccession::take(const FramedGoal& goal) {
  if (present_) {
    earlier_[next_] = present_;
    next_ = (next_ + 1) % kKept;
  }
  present_ = goal;
}

bool GoalSuccession::is_over(const FramedGoal& end) const {
  if (!present_ || same_place(*present_, end)) return false;
  return std::any_of(earlier_.begin(), earlier_.end(),
                     [&end](const auto& goal) { return goal && same_place(*goal, end); });
}

}  // namespace hidwa_local_planner
