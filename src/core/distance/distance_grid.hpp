// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <vector>

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
/// Computed when first asked for, those of blocked cells when the first of these is. Kept while map and sources stay
/// the same.
class DistanceGrids {
 public:
  static constexpr std::int32_t kUnreached = -1;
  static constexpr int kSets = DistanceSweep::kLanes;

  /// Room is kept for so many sources of a set.
  static constexpr std::size_t kUsualSources = 1024;

  DistanceGrids();
  /// `grid` must outlive the questions. All sets are empty then.
  void prepare(const GridView& grid, MapGridDistance distance);
  /// The sources of a set, all of which must lie in the grid.
  void set_sources(int set, const std::vector<Cell>& cells);

  /// In units; kUnreached where there is no way. The cell must lie in the grid.
  std::int32_t units(int set, Cell cell) {
    if (!settled_) settle();
    if (!blocked_settled_ && sweep_.blocked(cell)) settle_blocked();
    const std::int16_t value = sweep_.units(set, cell);
    return value >= DistanceSweep::kFar ? kUnreached : value;
  }
  /// Of many cells (i, j) [m]. Negative where there is no way, for blocked cells, and where i is negative; a cell with
  /// another i must lie in the grid.
  void free_metres(int set, const std::int32_t* i, const std::int32_t* j, std::size_t count, double* found);
  double metres_per_unit() const { return metres_per_unit_; }
  MapGridDistance measures() const { return distance_; }

 private:
  // What the sweep holds the distances of.
  struct Content {
    MapGridDistance distance = MapGridDistance::geodesic;
    int size_x = 0, size_y = 0;
    std::vector<std::uint8_t> costs;
    std::array<std::vector<Cell>, kSets> sources;
  };
  bool same_content() const;
  void settle();
  void settle_blocked();

  GridView grid_;
  MapGridDistance distance_ = MapGridDistance::geodesic;
  double metres_per_unit_ = 0.05;
  std::array<std::vector<Cell>, kSets> sources_;
  DistanceSweep sweep_;
  Content swept_;
  bool settled_ = false;
  bool blocked_settled_ = false;
};

/// One of the sets.
class DistanceGrid {
 public:
  static constexpr std::int32_t kUnreached = DistanceGrids::kUnreached;

  DistanceGrid(DistanceGrids& grids, int set) : grids_(&grids), set_(set) {}
  std::int32_t units(Cell cell) const { return grids_->units(set_, cell); }
  double metres_per_unit() const { return grids_->metres_per_unit(); }
  /// Of a cell of the grid [m]; negative where there is no way.
  double metres(Cell cell) const {
    const std::int32_t found = units(cell);
    return found == kUnreached ? -1.0 : found * metres_per_unit();
  }
  void free_metres(const std::int32_t* i, const std::int32_t* j, std::size_t count, double* found) const {
    grids_->free_metres(set_, i, j, count, found);
  }

 private:
  DistanceGrids* grids_ = nullptr;
  int set_ = 0;
};

}  // namespace hidwa_local_planner
