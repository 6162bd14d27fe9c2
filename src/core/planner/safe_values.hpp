// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "hidwa_local_planner/core/parameters.hpp"

namespace hidwa_local_planner {

/// With `admissibility: braking` nobody can steer the robot into an obstacle. Values that would break this promise are
/// replaced by safe ones, so that a robot does not stop because of an update. Returns a sentence for each: the
/// parameter, the value in force instead, and why.
std::vector<std::string> make_safe(Parameters& parameters);

}  // namespace hidwa_local_planner
