// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "hidwa_local_planner/core/types.hpp"
#include "robot/model.hpp"

namespace hidwa_local_planner::robot {

struct Outline {
  Polygon corners;                   // base frame, counter-clockwise [m]; empty where there are none
  std::vector<std::string> skipped;  // links whose collision geometry is a mesh or has no size: not covered
  std::string fault;                 // why there are no corners
};

/// The convex outline of all collision boxes, cylinders and spheres, whatever their height, at zero joint
/// positions. It contains them: round ones are taken 0.5 % larger.
Outline outline_of(const Model& model);

}  // namespace hidwa_local_planner::robot
