// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cstdlib>

#include "core/distance/distance_grid.hpp"
#include "hidwa_local_planner/core/util/vector_clones.hpp"

namespace hidwa_local_planner {
namespace {

constexpr std::int32_t kTableLanes = DistanceSweep::kLanes;
static_assert(DistanceGrids::kUnreached == -1);

struct Trust {
  std::int32_t open, sure;
  Cell source;  // of the only way there is, where that adds to what is sure
};

// What was read of some cells.
struct Values {
  const std::int32_t* i;
  const std::int32_t* j;
  const std::int32_t* units;
  const std::int32_t* mask;
  std::size_t count;
};

// The distances that are exact, see DistanceGrids::make_table; for the others all bits set, which is kUnreached. False
// where there are any of those.
HIDWA_VECTOR_CLONES
bool keep_sure(const Trust& trust, const Values& values, double factor, double* __restrict found) {
  const std::int32_t* __restrict i = values.i;
  const std::int32_t* __restrict read = values.units;
  const std::int32_t* __restrict mask = values.mask;
  const std::int32_t open = trust.open, most = trust.sure;
  const std::size_t count = values.count;
  std::int32_t any = 0;
  for (std::size_t c = 0; c < count; ++c) {
    const std::int32_t units = read[c];
    const std::int32_t unknown = -((units > most) | (i[c] < 0) | (mask[c] != open));
    any |= unknown;
    found[c] = (units | unknown) * factor;
  }
  return any == 0;
}

// Likewise from a single source: without obstacles a diagonal step costs 2 more than a straight one.
HIDWA_VECTOR_CLONES
bool keep_sure_of_one(const Trust& trust, const Values& values, double factor, double* __restrict found) {
  const std::int32_t* __restrict i = values.i;
  const std::int32_t* __restrict read = values.units;
  const std::int32_t* __restrict mask = values.mask;
  const std::int32_t* __restrict j = values.j;
  const std::int32_t open = trust.open, sure = trust.sure, to_i = trust.source.i, to_j = trust.source.j;
  const std::size_t count = values.count;
  std::int32_t any = 0;
  for (std::size_t c = 0; c < count; ++c) {
    const std::int32_t units = read[c];
    const std::int32_t di = std::abs(i[c] - to_i), dj = std::abs(j[c] - to_j);
    const std::int32_t unhindered = 3 * (di > dj ? di : dj) + 2 * (di + dj);
    const std::int32_t unknown =
        -((units > sure + unhindered) | (units >= DistanceSweep::kFar) | (i[c] < 0) | (mask[c] != open));
    any |= unknown;
    found[c] = (units | unknown) * factor;
  }
  return any == 0;
}

}  // namespace

bool DistanceGrids::Table::free_distances(const std::int32_t* i, const std::int32_t* j, std::size_t count,
                                          double factor, double* found) const {
  std::int32_t values[kernel::kMostPoints], masks[kernel::kMostPoints];
  const auto row = static_cast<std::int32_t>(stride);
  for (std::size_t c = 0; c < count; ++c) {
    const std::int32_t at = i[c] >= 0 ? j[c] * row + i[c] * kTableLanes : 0;  // outside: any, it is not used
    values[c] = units[at];
    masks[c] = mask[at];
  }
  const Values read{i, j, values, masks, count};
  if (single) return keep_sure_of_one({open, sure, source}, read, factor, found);
  return keep_sure({open, std::min<std::int32_t>(sure, DistanceSweep::kFar - 1), {}}, read, factor, found);
}

}  // namespace hidwa_local_planner
