// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "sim/barn_world.hpp"

namespace hidwa_local_planner::test {

using sim::BarnWorld;

/// $HIDWA_DATA/barn/worlds.txt, or the same beside the source tree.
std::string barn_worlds_file();

}  // namespace hidwa_local_planner::test
