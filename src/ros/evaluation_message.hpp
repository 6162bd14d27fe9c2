// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include <ros/time.h>
#include <visualization_msgs/MarkerArray.h>

#include "hidwa_local_planner/Evaluation.h"
#include "hidwa_local_planner/core/planner.hpp"

namespace hidwa_local_planner {

/// All candidates of a cycle with their critics' scores. `frame`: the costmap's.
Evaluation to_evaluation(const std::vector<CandidateReport>& candidates, const Planner::Marked& marked,
                         const std::string& frame, const ros::Time& stamp);

/// The same as lines: legal candidates from green (cheapest) to red, rejected ones grey, the chosen one thick
/// and white, the operator's own thick and blue.
visualization_msgs::MarkerArray to_markers(const std::vector<CandidateReport>& candidates,
                                           const Planner::Marked& marked, const std::string& frame,
                                           const ros::Time& stamp);

}  // namespace hidwa_local_planner
