// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <vector>

#include "core/distance/cell_index.hpp"
#include "core/distance/distance_sweep.hpp"
#include "hidwa_local_planner/core/grid_view.hpp"

namespace hidwa_local_planner {

enum class MapGridDistance { geodesic, l1 };

/// Distances of every cell to the nearest of a set of cells, for a few sets at once and in whole units, so that
/// symmetric scenes give equal values.
///   l1        cost-blind Manhattan distance, one unit a cell: Nav2's map grid.
///   geodesic  around obstacles: 8 neighbours, 5 units straight and 7 diagonally (at most 8 % from Euclidean). Lethal
///             and inscribed cells block; a source counts even where it is blocked. Blocked cells get values, too, from
///             the reached cells beside them inwards, so a robot in one still knows its way. No way leads through them.
/// Computed when first asked for, and first around the cells of interest alone. A way that leaves that region has a
/// known least length; the whole map is swept only where a distance exceeds it. Kept while map and sources stay the
/// same.
class DistanceGrids {
 public:
  static constexpr std::int32_t kUnreached = -1;
  static constexpr int kSets = DistanceSweep::kLanes;

  /// Room is kept for so many sources of a set.
  static constexpr std::size_t kUsualSources = 1024;

  DistanceGrids();
  /// `grid` must outlive the questions. All sets are empty then, and the whole map is of interest.
  void prepare(const GridView& grid, MapGridDistance distance);
  /// The cells that will be asked about, mostly.
  void set_interest(const kernel::CellBox& box);
  /// The sources of a set, all of which must lie in the grid.
  void set_sources(int set, const std::vector<Cell>& cells);

  /// In units; kUnreached where there is no way. The cell must lie in the grid.
  std::int32_t units(int set, Cell cell);
  double metres_per_unit() const { return metres_per_unit_; }
  MapGridDistance measures() const { return distance_; }

  /// The cells of interest at once, for loops over many.
  struct Table {
    kernel::CellBox box;                  // of the cells of interest; the look-up counts from its lowest cell
    const std::int16_t* units = nullptr;  // of that cell
    const std::int16_t* mask = nullptr;
    std::size_t stride = 0;  // values a row
    std::int16_t open = 0;   // mask of a free cell
    std::int32_t sure = 0;   // distances up to it, and the one without obstacles more, are exact
    bool single = false;     // one source only
    Cell source;             // it, counted from the box's lowest cell

    /// Of cells counted from the box's lowest one, whose i is negative outside it, times `factor`. Negative for those,
    /// and for cells that are blocked, not reached, or whose distance takes a closer look: units(). At most
    /// kMostPoints. True when none is negative.
    bool free_distances(const std::int32_t* i, const std::int32_t* j, std::size_t count, double factor,
                        double* found) const;
  };
  Table table(int set) {
    if (!settled_) settle();
    return tables_[static_cast<std::size_t>(set)];
  }

 private:
  // What the sweep holds the distances of.
  struct Content {
    MapGridDistance distance = MapGridDistance::geodesic;
    int size_x = 0, size_y = 0;
    kernel::CellBox interest;
    std::vector<std::uint8_t> costs;
    std::array<std::vector<Cell>, kSets> sources;
  };
  bool same_content() const;
  void settle();
  void settle_blocked();
  kernel::CellBox region() const;
  void sweep_region(const kernel::CellBox& box);
  void make_table(int set);
  bool whole() const { return region_.width == grid_.size_x && region_.height == grid_.size_y; }
  Cell in_region(Cell cell) const { return {cell.i - region_.i, cell.j - region_.j}; }

  GridView grid_;
  MapGridDistance distance_ = MapGridDistance::geodesic;
  double metres_per_unit_ = 0.05;
  kernel::CellBox interest_, region_;
  std::array<std::vector<Cell>, kSets> sources_;
  std::array<Table, kSets> tables_;
  DistanceSweep sweep_;
  Content swept_;
  bool settled_ = false;
  bool blocked_settled_ = false;
};

/// One of the sets.
class DistanceGrid {
 public:
  static constexpr std::int32_t kUnreached = DistanceGrids::kUnreached;

  DistanceGrid() = default;
  DistanceGrid(DistanceGrids& grids, int set) : grids_(&grids), set_(set) {}
  std::int32_t units(Cell cell) const { return grids_->units(set_, cell); }
  double metres_per_unit() const { return grids_->metres_per_unit(); }
  DistanceGrids::Table table() const { return grids_->table(set_); }

 private:
  DistanceGrids* grids_ = nullptr;
  int set_ = 0;
};

}  // namespace hidwa_local_planner
