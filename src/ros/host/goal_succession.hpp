// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <mutex>
#include <optional>
#include <string>

#include "hidwa_local_planner/core/types.hpp"

namespace hidwa_local_planner {

/// A goal in its frame [m, rad].
struct FramedGoal {
  std::string frame;
  Pose2 pose;
};

/// The goals that a host was given one after the other, and whether a plan still leads to one of the earlier ones.
/// move_base makes plans on another thread: the one that it was making when a new goal came still goes to the local
/// planner, and where none to the new goal is found it stays there. Thread-safe.
class GoalSuccession {
 public:
  /// The host pursues `goal` from `now` on [s].
  void take(const FramedGoal& goal, double now);
  /// True where a plan that ends at `end` leads to an earlier goal and not to the present one.
  bool leads_to_earlier_goal(const FramedGoal& end) const;
  /// Such a plan leads the robot on until the next one comes, since its goal was given up lately, and the present one
  /// is near to it. So is the plan of a slow global planner for a robot that follows somebody.
  bool leads_on(const FramedGoal& end, double now) const;

 private:
  struct Earlier {
    FramedGoal goal;
    double until = 0.0;  // the host pursued it [s]
  };
  static constexpr std::size_t kKept = 4;  // a plan in the making is one goal old, seldom more
  mutable std::mutex mutex_;
  std::optional<FramedGoal> present_;
  std::array<std::optional<Earlier>, kKept> earlier_;
  std::size_t next_ = 0;
};

}  // namespace hidwa_local_planner
