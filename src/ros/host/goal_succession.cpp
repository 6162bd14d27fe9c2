// SPDX-License-Identifier: BSD-3-Clause
#include "ros/host/goal_succession.hpp"

#include <algorithm>
#include <cmath>

namespace hidwa_local_planner {
namespace {

// A plan may end at the cell of its goal rather than at the goal.
constexpr double kSamePlace = 0.1;     // [m]
constexpr double kSameHeading = 1e-3;  // [rad]

// A plan is followed to a goal that was given up no longer ago than this, and lies within this of the present one.
constexpr double kLately = 2.0;  // [s]
constexpr double kNear = 1.0;    // [m]

// A heading that is not a number is any heading.
bool same_place(const FramedGoal& a, const FramedGoal& b) {
  return a.frame == b.frame && distance(a.pose, b.pose) <= kSamePlace &&
         !(std::abs(wrap_angle(a.pose.theta - b.pose.theta)) > kSameHeading);
}

}  // namespace

void GoalSuccession::take(const FramedGoal& goal, double now) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (present_) {
    earlier_[next_] = Earlier{*present_, now};
    next_ = (next_ + 1) % kKept;
  }
  present_ = goal;
}

bool GoalSuccession::leads_to_earlier_goal(const FramedGoal& end) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!present_ || same_place(*present_, end)) return false;
  return std::any_of(earlier_.begin(), earlier_.end(),
                     [&end](const auto& earlier) { return earlier && same_place(earlier->goal, end); });
}

bool GoalSuccession::leads_on(const FramedGoal& end, double now) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!present_ || present_->frame != end.frame || distance(present_->pose, end.pose) > kNear) return false;
  return std::any_of(earlier_.begin(), earlier_.end(), [&](const auto& earlier) {
    return earlier && same_place(earlier->goal, end) && std::abs(now - earlier->until) <= kLately;
  });
}

}  // namespace hidwa_local_planner
