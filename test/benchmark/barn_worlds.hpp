// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "hidwa_local_planner/core/types.hpp"

namespace hidwa_local_planner::test {

/// A dense field of cylinders of radius 0.075 m (Perille et al. 2020, "Benchmarking metric ground
/// navigation").
struct BarnWorld {
  std::vector<Point> cylinders;  // centres [m]
  std::vector<Point> path;       // the reference path through the field [m]
};

/// One world a line: index | cells a:b ... | path cells col:row ...; lines with # are comments. Throws
/// std::runtime_error where the file cannot be read or holds something else.
std::vector<BarnWorld> read_barn_worlds(const std::string& file);

/// $HIDWA_DATA/barn/worlds.txt, or the same beside the source tree.
std::string barn_worlds_file();

}  // namespace hidwa_local_planner::test
