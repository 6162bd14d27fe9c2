// SPDX-License-Identifier: BSD-3-Clause
#include "core/distance/distance_grid.hpp"

#include <algorithm>
#include <cstring>

namespace hidwa_local_planner {
namespace {

constexpr DistanceSweep::Steps kGeodesic{5, 7};
constexpr DistanceSweep::Steps kL1{1, 2};

bool same_cells(const std::vector<Cell>& a, const std::vector<Cell>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const Cell& p, const Cell& q) { return p.i == q.i && p.j == q.j; });
}

}  // namespace

DistanceGrids::DistanceGrids() {
  for (std::vector<Cell>& cells : sources_) cells.reserve(kUsualSources);
  for (std::vector<Cell>& cells : swept_.sources) cells.reserve(kUsualSources);
}

void DistanceGrids::prepare(const GridView& grid, MapGridDistance distance) {
  grid_ = grid;
  distance_ = distance;
  metres_per_unit_ = grid.resolution / (distance == MapGridDistance::l1 ? kL1.straight : kGeodesic.straight);
  for (std::vector<Cell>& cells : sources_) cells.clear();
  settled_ = false;
}

void DistanceGrids::set_sources(int set, const std::vector<Cell>& cells) {
  sources_[static_cast<std::size_t>(set)] = cells;
  settled_ = false;
}

void DistanceGrids::free_metres(int set, const std::int32_t* i, const std::int32_t* j, std::size_t count,
                                double* found) {
  if (!settled_) settle();
  for (std::size_t c = 0; c < count; ++c) {
    const std::int16_t units = i[c] < 0 ? DistanceSweep::kFar : sweep_.free_units(set, {i[c], j[c]});
    found[c] = units == DistanceSweep::kFar ? -1.0 : units * metres_per_unit_;
  }
}

// Manhattan distance does not look at the costs.
bool DistanceGrids::same_content() const {
  if (swept_.size_x != grid_.size_x || swept_.size_y != grid_.size_y || swept_.distance != distance_) return false;
  if (!std::equal(sources_.begin(), sources_.end(), swept_.sources.begin(), same_cells)) return false;
  return distance_ == MapGridDistance::l1 || std::memcmp(swept_.costs.data(), grid_.costs, grid_.cell_count()) == 0;
}

void DistanceGrids::settle() {
  settled_ = true;
  if (same_content()) return;
  const bool blind = distance_ == MapGridDistance::l1;
  swept_.distance = distance_;
  swept_.size_x = grid_.size_x;
  swept_.size_y = grid_.size_y;
  swept_.sources = sources_;
  if (!blind) swept_.costs.assign(grid_.costs, grid_.costs + grid_.cell_count());
  sweep_.reset(grid_.size_x, grid_.size_y, blind ? kL1 : kGeodesic);
  for (int j = 0; !blind && j < grid_.size_y; ++j) {
    sweep_.block_lethal_and_inscribed(j, grid_.costs + grid_.index({0, j}));
  }
  for (int set = 0; set < kSets; ++set) {
    for (const Cell cell : sources_[static_cast<std::size_t>(set)]) sweep_.seed(set, cell);
  }
  sweep_.settle();
  blocked_settled_ = blind;
}

void DistanceGrids::settle_blocked() {
  blocked_settled_ = true;
  sweep_.settle_blocked();
}

}  // namespace hidwa_local_planner
