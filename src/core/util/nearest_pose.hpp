// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <vector>

#include "hidwa_local_planner/core/types.hpp"

namespace hidwa_local_planner {

/// The pose of a plan that is nearest to `here`, of equals the first; the plan's end where it is empty.
inline std::vector<Pose2>::const_iterator nearest_pose(const std::vector<Pose2>& plan, const Pose2& here) {
  return std::min_element(plan.begin(), plan.end(),
                          [&](const Pose2& a, const Pose2& b) { return distance(a, here) < distance(b, here); });
}

}  // namespace hidwa_local_planner
