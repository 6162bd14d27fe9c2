// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "hidwa_local_planner/core/grid_view.hpp"

namespace hidwa_local_planner::test {

/// True for what a way cannot lead through.
inline bool naive_grid_blocks(std::uint8_t value) { return value == cost::kLethal || value == cost::kInscribed; }

/// Distances around obstacles in fifths of a cell by Dijkstra's algorithm with a binary heap; -1 where there
/// is no way. Blocked cells get theirs from the free ones beside them.
std::vector<int> naive_grid(const GridView& grid, const std::vector<Cell>& sources);

}  // namespace hidwa_local_planner::test
