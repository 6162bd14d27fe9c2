// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cstdlib>

#include "hidwa_local_planner/core/distance_grid.hpp"
#include "hidwa_local_planner/core/vector_clones.hpp"

namespace hidwa_local_planner {
namespace {

constexpr std::int32_t kLanes = DistanceSweep::kLanes;

struct Trust {
  std::int32_t open, sure;
  Cell source;  // of the only way there is, where that adds to what is sure
};

// Keeps the distances that are exact, see DistanceGrids::make_table.
HIDWA_VECTOR_CLONES
void keep_sure(const Trust& trust, const std::int32_t* __restrict i, const std::int32_t* __restrict mask,
               std::size_t count, std::int32_t* __restrict units) {
  const std::int32_t open = trust.open, most = trust.sure;
  for (std::size_t c = 0; c < count; ++c) {
    const bool exact = (units[c] <= most) & (i[c] >= 0) & (mask[c] == open);
    units[c] = exact ? units[c] : DistanceGrids::kUnreached;
  }
}

// Likewise from a single source: without obstacles a diagonal step costs 2 more than a straight one.
HIDWA_VECTOR_CLONES
void keep_sure_of_one(const Trust& trust, const std::int32_t* __restrict i, const std::int32_t* __restrict j,
                      const std::int32_t* __restrict mask, std::size_t count, std::int32_t* __restrict units) {
  const std::int32_t open = trust.open, sure = trust.sure, to_i = trust.source.i, to_j = trust.source.j;
  for (std::size_t c = 0; c < count; ++c) {
    const std::int32_t di = std::abs(i[c] - to_i), dj = std::abs(j[c] - to_j);
    const std::int32_t unhindered = 3 * (di > dj ? di : dj) + 2 * (di + dj);
    const bool exact = (units[c] <= sure + unhindered) & (i[c] >= 0) & (mask[c] == open);
    const bool reached = units[c] < DistanceSweep::kFar;
    units[c] = (exact & reached) ? units[c] : DistanceGrids::kUnreached;
  }
}

}  // namespace

void DistanceGrids::Table::free_units(const std::int32_t* i, const std::int32_t* j, std::size_t count,
                                      std::int32_t* found) const {
  std::int32_t masks[kernel::kMostPoints];
  const auto row = static_cast<std::int32_t>(stride);
  for (std::size_t c = 0; c < count; ++c) {
    const std::int32_t at = i[c] >= 0 ? j[c] * row + i[c] * kLanes : 0;  // outside: any, it is not used
    found[c] = units[at];
    masks[c] = mask[at];
  }
  if (single) {
    keep_sure_of_one({open, sure, source}, i, j, masks, count, found);
  } else {
    keep_sure({open, std::min<std::int32_t>(sure, DistanceSweep::kFar - 1), {}}, i, masks, count, found);
  }
}

}  // namespace hidwa_local_planner
