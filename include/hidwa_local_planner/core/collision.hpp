// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "hidwa_local_planner/core/bit_grid.hpp"
#include "hidwa_local_planner/core/footprint.hpp"
#include "hidwa_local_planner/core/grid_view.hpp"
#include "hidwa_local_planner/core/types.hpp"

namespace hidwa_local_planner {

/// Tells whether the robot at a pose overlaps an obstacle. Lethal cells, unknown ones by policy, and everything beyond
/// the map's edge are obstacles. A polygon is tested exactly: it collides when it shares area with an obstacle's cell.
/// A circle collides when its centre's cell is inscribed or worse, or when the disc itself overlaps an obstacle's cell:
/// the inscribed cost is quantised to cells and alone would let it overlap by up to a cell's diagonal.
class CollisionChecker {
 public:
  /// Once a cycle. `reach` [m] is how far from `centre` the robot's centre will be asked about; farther poses are
  /// answered too, only slower. `grid` and `footprint` must outlive the questions.
  void prepare(const GridView& grid, const Footprint& footprint, bool unknown_is_obstacle, const Pose2& centre,
               double reach);

  bool collides(const Pose2& pose) const;
  /// As collides(), for an outline that differs from the prepared one by less than a cell's side.
  bool collides(const Pose2& pose, const Footprint& outline) const;
  /// True when the robot is free at any heading, at this position and everywhere within one cell's side of it.
  bool clear(double x, double y) const;

  /// Obstacle cells that the robot overlaps at a pose.
  int penetration(const Pose2& pose) const;
  /// Distance from the robot's centre to the nearest obstacle cell within the window [m]; 0 inside one.
  double clearance(const Pose2& pose) const;

  /// Obstacle in the sense above; cells beyond the edge are.
  bool obstacle(Cell cell) const {
    if (!grid_.contains(cell)) return true;
    const std::uint8_t value = grid_.at(cell);
    return value == cost::kLethal || (value == cost::kUnknown && unknown_is_obstacle_);
  }

 private:
  bool centre_collides(Cell cell, const Footprint& outline) const;
  bool overlaps_any(const Pose2& pose, const Footprint& outline) const;
  bool in_window(Cell cell) const {
    return static_cast<unsigned>(cell.i - first_.i) < static_cast<unsigned>(obstacles_.width()) &&
           static_cast<unsigned>(cell.j - first_.j) < static_cast<unsigned>(obstacles_.height());
  }
  // Every obstacle that the robot may touch there lies in the window.
  bool in_reach(Cell cell) const {
    return static_cast<unsigned>(cell.i - first_.i - margin_) < static_cast<unsigned>(near_.width() - 2 * margin_) &&
           static_cast<unsigned>(cell.j - first_.j - margin_) < static_cast<unsigned>(near_.height() - 2 * margin_);
  }
  template <typename Visit>
  void visit_overlapped(const Pose2& pose, const Footprint& outline, Visit&& visit) const;

  GridView grid_;
  const Footprint* footprint_ = nullptr;
  bool unknown_is_obstacle_ = true;
  Cell first_;         // of the window, map cells
  int margin_ = 0;     // cells at the window's rim that near_ does not answer for
  BitGrid obstacles_;  // in the window
  BitGrid near_;       // centre cells where the robot may overlap an obstacle
  BitGrid hit_;        // centre cells where it surely does
  std::vector<int> reach_;
  mutable Polygon corners_;
};

/// True when a simple polygon shares area with the axis-parallel square [x, x + side] x [y, y + side].
bool overlaps_square(const Polygon& polygon, double x, double y, double side);

}  // namespace hidwa_local_planner
