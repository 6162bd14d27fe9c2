// SPDX-License-Identifier: BSD-3-Clause
#include "core/distance/distance_grid.hpp"

#include <algorithm>
#include <cstring>

namespace hidwa_local_planner {
namespace {

constexpr DistanceSweep::Steps kGeodesic{5, 7};
constexpr DistanceSweep::Steps kL1{1, 2};

// Cells around the interest and the sources that are swept too.
constexpr int kRoom = 10;

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
  interest_ = {0, 0, grid.size_x, grid.size_y};
  metres_per_unit_ = grid.resolution / (distance == MapGridDistance::l1 ? kL1.straight : kGeodesic.straight);
  for (std::vector<Cell>& cells : sources_) cells.clear();
  settled_ = false;
}

void DistanceGrids::set_interest(const kernel::CellBox& box) {
  const int lo_i = std::clamp(box.i, 0, grid_.size_x - 1), hi_i = std::clamp(box.i + box.width, lo_i + 1, grid_.size_x);
  const int lo_j = std::clamp(box.j, 0, grid_.size_y - 1),
            hi_j = std::clamp(box.j + box.height, lo_j + 1, grid_.size_y);
  interest_ = {lo_i, lo_j, hi_i - lo_i, hi_j - lo_j};
  settled_ = false;
}

void DistanceGrids::set_sources(int set, const std::vector<Cell>& cells) {
  sources_[static_cast<std::size_t>(set)] = cells;
  settled_ = false;
}

std::int32_t DistanceGrids::units(int set, Cell cell) {
  const Table& known = table(set);
  const Cell asked{cell.i - known.box.i, cell.j - known.box.j};
  const bool inside = asked.i >= 0 && asked.i < known.box.width && asked.j >= 0 && asked.j < known.box.height;
  double units = kUnreached;
  if (inside && known.free_distances(&asked.i, &asked.j, 1, 1.0, &units)) return static_cast<std::int32_t>(units);
  if (!whole()) sweep_region({0, 0, grid_.size_x, grid_.size_y});
  if (!blocked_settled_ && sweep_.blocked(cell)) settle_blocked();
  const std::int16_t value = sweep_.units(set, cell);
  return value >= DistanceSweep::kFar ? kUnreached : value;
}

// Manhattan distance does not look at the costs.
bool DistanceGrids::same_content() const {
  if (swept_.size_x != grid_.size_x || swept_.size_y != grid_.size_y || swept_.distance != distance_) return false;
  if (!(swept_.interest == interest_)) return false;
  if (!std::equal(sources_.begin(), sources_.end(), swept_.sources.begin(), same_cells)) return false;
  return distance_ == MapGridDistance::l1 || std::memcmp(swept_.costs.data(), grid_.costs, grid_.cell_count()) == 0;
}

void DistanceGrids::settle() {
  settled_ = true;
  if (same_content()) return;
  swept_.distance = distance_;
  swept_.size_x = grid_.size_x;
  swept_.size_y = grid_.size_y;
  swept_.interest = interest_;
  swept_.sources = sources_;
  if (distance_ == MapGridDistance::geodesic) swept_.costs.assign(grid_.costs, grid_.costs + grid_.cell_count());
  sweep_region(region());
}

// The interest and all sources, with room for ways round obstacles.
kernel::CellBox DistanceGrids::region() const {
  int lo_i = interest_.i, hi_i = interest_.i + interest_.width - 1;
  int lo_j = interest_.j, hi_j = interest_.j + interest_.height - 1;
  for (const std::vector<Cell>& cells : sources_) {
    for (const Cell& cell : cells) {
      lo_i = std::min(lo_i, cell.i);
      hi_i = std::max(hi_i, cell.i);
      lo_j = std::min(lo_j, cell.j);
      hi_j = std::max(hi_j, cell.j);
    }
  }
  lo_i = std::max(lo_i - kRoom, 0);
  lo_j = std::max(lo_j - kRoom, 0);
  hi_i = std::min(hi_i + kRoom, grid_.size_x - 1);
  hi_j = std::min(hi_j + kRoom, grid_.size_y - 1);
  return {lo_i, lo_j, hi_i - lo_i + 1, hi_j - lo_j + 1};
}

void DistanceGrids::sweep_region(const kernel::CellBox& box) {
  region_ = box;
  sweep_.reserve(grid_.size_x, grid_.size_y);  // regions differ from cycle to cycle
  sweep_.reset(box.width, box.height, distance_ == MapGridDistance::l1 ? kL1 : kGeodesic);
  blocked_settled_ = distance_ == MapGridDistance::l1;
  if (distance_ == MapGridDistance::geodesic) {
    for (int j = 0; j < box.height; ++j) {
      sweep_.block_lethal_and_inscribed(j, grid_.costs + grid_.index({box.i, box.j + j}));
    }
  }
  for (int set = 0; set < kSets; ++set) {
    for (const Cell cell : sources_[static_cast<std::size_t>(set)]) sweep_.seed(set, in_region(cell));
  }
  sweep_.settle();
  for (int set = 0; set < kSets; ++set) make_table(set);
}

// A way that leaves the region goes kRoom cells and one more beyond both its ends, twice. From a single source, which
// lies a known number of cells away, that makes it longer than the way without obstacles by 2 units at least for each
// of those cells; from the nearest of several, which may lie anywhere, it is 5 units for each of them long at least.
void DistanceGrids::make_table(int set) {
  const std::vector<Cell>& sources = sources_[static_cast<std::size_t>(set)];
  const Cell first = in_region({interest_.i, interest_.j});
  Table& table = tables_[static_cast<std::size_t>(set)];
  table.box = interest_;
  table.units = sweep_.table_from(first) + set;
  table.mask = sweep_.mask_from(first);
  table.stride = sweep_.values_a_row();
  table.open = sweep_.open();
  table.single = sources.size() == 1;
  if (table.single) table.source = {sources[0].i - interest_.i, sources[0].j - interest_.j};
  const bool exact = whole() || distance_ == MapGridDistance::l1;  // Manhattan ways need not leave the region
  table.sure = exact ? DistanceSweep::kFar : (table.single ? 2 : 5) * 2 * (kRoom + 1);
}

void DistanceGrids::settle_blocked() {
  blocked_settled_ = true;
  sweep_.settle_blocked();
  for (Table& table : tables_) table.open = sweep_.open();
}

}  // namespace hidwa_local_planner
