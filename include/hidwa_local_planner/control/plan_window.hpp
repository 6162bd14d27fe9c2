// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "hidwa_local_planner/core/types.hpp"

namespace hidwa_local_planner {

/// The part of the plan that matters now, found by progress along its arc length that never goes back: a loop in the
/// plan cannot pull the robot to the wrong branch.
class PlanWindow {
 public:
  /// A new or replaced plan, any frame; progress starts anew at the plan's pose nearest to the robot's first query.
  void set_plan(std::vector<Pose2> plan);
  /// set_plan() with so many poses, or fewer, then takes no memory of its own.
  void reserve(std::size_t poses) { arc_.reserve(poses); }
  bool empty() const { return plan_.empty(); }
  const std::vector<Pose2>& plan() const { return plan_; }

  /// The poses from `behind` [m] behind the robot's progress to `ahead` [m] ahead of it, measured along the plan.
  /// `robot` is in the plan's frame. Moves the progress on. Empty only when the plan is empty.
  struct Range {
    std::size_t begin = 0, end = 0;  // [begin, end) into plan()
  };
  Range around(const Pose2& robot, double behind, double ahead);
  /// Arc length from the plan's start to the progress [m].
  double progress() const { return progress_; }
  /// The first pose from the progress on.
  std::size_t next_pose() const;
  /// The progress alone; the plan is the same before and after.
  template <typename Self, typename Archive>
  static void archive(Self& self, Archive& io) {
    io(self.progress_);
  }

 private:
  std::vector<Pose2> plan_;
  std::vector<double> arc_;  // arc length at each pose [m]
  double progress_ = -1.0;   // [m]; negative before the first query
};

}  // namespace hidwa_local_planner
