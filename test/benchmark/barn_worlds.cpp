// SPDX-License-Identifier: BSD-3-Clause
#include "benchmark/barn_worlds.hpp"

#include <cstdlib>

namespace hidwa_local_planner::test {

std::string barn_worlds_file() {
  const char* folder = std::getenv("HIDWA_DATA");
  return std::string(folder != nullptr ? folder : HIDWA_DATA_DEFAULT) + "/barn/worlds.txt";
}

}  // namespace hidwa_local_planner::test
