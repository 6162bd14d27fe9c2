// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include <visualization_msgs/MarkerArray.h>

#include "hidwa_local_planner/OperatorState.h"

namespace hidwa_local_planner {

/// For rviz, in the robot's frame `base_frame`: the state in large letters, one fixed colour a state, with
/// what rejected the operator command below it; and two arrows along the path that the robot's nose would take
/// for a while, a thin one for the operator command and a thick one for what is executed.
visualization_msgs::MarkerArray to_operator_markers(const OperatorState& state, const std::string& base_frame);

}  // namespace hidwa_local_planner
