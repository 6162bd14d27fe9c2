// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include <geometry_msgs/PoseStamped.h>

#include "hidwa_local_planner/core/types.hpp"

namespace hidwa_local_planner {

/// A global plan as the host gives it, read.
struct PlanMessage {
  std::string fault;  // what is wrong with it, in words; empty where it can be followed
  std::string frame;
  std::vector<Pose2> poses;  // in the frame; empty where there is a fault. A theta that is not a number is no heading
};

PlanMessage read_plan(const std::vector<geometry_msgs::PoseStamped>& plan);

}  // namespace hidwa_local_planner
