// SPDX-License-Identifier: BSD-3-Clause
#include <cstdlib>

#include "hidwa_local_planner/core/distance_grid.hpp"
#include "hidwa_local_planner/core/vector_clones.hpp"

namespace hidwa_local_planner {
namespace {

constexpr std::int32_t kLanes = DistanceSweep::kLanes;

// Where the values of the cells lie; outside the box, those of its first cell are read and not used.
HIDWA_VECTOR_CLONES
void find_values(const std::int32_t* __restrict i, const std::int32_t* __restrict j, std::int32_t stride,
                 std::size_t count, std::int32_t* __restrict at) {
  for (std::size_t c = 0; c < count; ++c) at[c] = i[c] >= 0 ? j[c] * stride + i[c] * kLanes : 0;
}

struct Trust {
  std::int32_t open, sure;
  std::int32_t hindered;  // all bits where the way without obstacles adds to what is sure, else none
  Cell source;
};

// Keeps the distances that are exact, see DistanceGrids::make_table.
HIDWA_VECTOR_CLONES
void keep_exact(const Trust& trust, const std::int32_t* __restrict i, const std::int32_t* __restrict j,
                const std::int32_t* __restrict mask, std::size_t count, std::int32_t* __restrict units) {
  for (std::size_t c = 0; c < count; ++c) {
    // Without obstacles a diagonal step costs 2 more than a straight one.
    const std::int32_t di = std::abs(i[c] - trust.source.i), dj = std::abs(j[c] - trust.source.j);
    const std::int32_t unhindered = 5 * (di > dj ? di : dj) + 2 * (di > dj ? dj : di);
    const bool exact = units[c] <= trust.sure + (unhindered & trust.hindered);
    const bool free = (i[c] >= 0) & (mask[c] == trust.open) & (units[c] < DistanceSweep::kFar);
    units[c] = (exact & free) ? units[c] : DistanceGrids::kUnreached;
  }
}

}  // namespace

void DistanceGrids::Table::free_units(const std::int32_t* i, const std::int32_t* j, std::size_t count,
                                      std::int32_t* found) const {
  std::int32_t at[kernel::kMostPoints], masks[kernel::kMostPoints];
  find_values(i, j, static_cast<std::int32_t>(stride), count, at);
  for (std::size_t c = 0; c < count; ++c) {
    found[c] = units[at[c]];
    masks[c] = mask[at[c]];
  }
  keep_exact({open, sure, single ? -1 : 0, source}, i, j, masks, count, found);
}

}  // namespace hidwa_local_planner
