// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "hidwa_local_planner/core/parameters.hpp"

namespace hidwa_local_planner {

/// With `admissibility: braking` the robot can be steered into nothing. Values with which that cannot be kept are
/// replaced by safe ones; a robot does not stop driving because of an update. Returns for each a sentence that names
/// the parameter, the value that is in force instead, and why.
std::vector<std::string> make_safe(Parameters& parameters);

}  // namespace hidwa_local_planner
