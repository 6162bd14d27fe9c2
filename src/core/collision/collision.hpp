// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "core/collision/cell_flags.hpp"
#include "core/collision/obstacle_lists.hpp"
#include "core/collision/outline_planes.hpp"
#include "core/util/rotation.hpp"
#include "hidwa_local_planner/core/footprint.hpp"
#include "hidwa_local_planner/core/grid_view.hpp"
#include "hidwa_local_planner/core/tile.hpp"
#include "hidwa_local_planner/core/types.hpp"

namespace hidwa_local_planner {

/// Tells whether the robot at a pose overlaps an obstacle. Lethal cells, unknown ones by policy, and everything beyond
/// the map's edge are obstacles. A polygon is tested exactly: it collides when it shares area with an obstacle's cell.
/// A circle collides when its centre's cell is inscribed or worse, or when the disc itself overlaps an obstacle's cell:
/// the inscribed cost is quantised to cells and alone would let it overlap by up to a cell's diagonal.
class CollisionChecker {
 public:
  /// Once a cycle. Poses up to `reach` [m] from `centre` are answered fast, farther ones slowly. `margin` [m]: a
  /// position is clear if the robot is free everywhere within it. `largest_clearance` [m]: clearance() answers up to
  /// this, two cells at least. `grid` and `footprint` must outlive the questions.
  void prepare(const GridView& grid, const Footprint& footprint, bool unknown_is_obstacle, const Pose2& centre,
               double reach, double margin, double largest_clearance = 0.0);

  bool collides(const Pose2& pose) const { return collides(pose, Rotation::direction(pose.theta)); }
  /// With the cosine and sine of the heading.
  bool collides(const Pose2& pose, const Rotation& heading) const { return clearance(pose, heading, 0.0) <= 0.0; }
  /// The robot overlaps obstacles there, and unknown cells are all of them. Slow: to say why.
  bool meets_unknown_only(const Pose2& pose, const Rotation& heading) const;
  /// The clearance [m], see docs/understand/design.md; 0 where the robot collides. A lower bound, at most `cap`, which
  /// counts up to largest_clearance().
  double clearance(const Pose2& pose, const Rotation& heading, double cap) const;
  /// True when the robot is free at any heading, at this position and everywhere within the margin around it.
  bool clear(double x, double y) const;
  double margin() const { return shape_.margin; }                        // of clear() [m]
  double largest_clearance() const { return shape_.largest_clearance; }  // the most that clearance() answers [m]
  /// True when all positions within `distance` [m] of a position are clear.
  bool clear_around(double x, double y, double distance) const;

  /// An obstacle in the sense above; cells beyond the map's edge are obstacles.
  bool obstacle(Cell cell) const { return grid_.obstacle(cell, unknown_is_obstacle_); }

  /// Whether the classes of the cell are known.
  bool in_reach(Cell cell) const {
    return static_cast<unsigned>(cell.i - first_.i - rim_) < static_cast<unsigned>(cells_.width() - 2 * rim_) &&
           static_cast<unsigned>(cell.j - first_.j - rim_) < static_cast<unsigned>(cells_.height() - 2 * rim_);
  }
  /// The robot collides at any heading, wherever in the cell its centre is. The cell must be in reach.
  bool surely_collides(Cell cell) const { return (flags_of(cell) & cell_class::kHit) != 0; }

  /// The cells of a window around the centre, with their classes (cell_class) among other flags.
  const CellFlags& cells() const { return cells_; }
  /// The window's lower left corner [m].
  Point corner() const {
    return {grid_.origin_x + first_.i * grid_.resolution, grid_.origin_y + first_.j * grid_.resolution};
  }
  double resolution() const { return grid_.resolution; }  // a cell's side [m]

 private:
  // What the marks depend on, besides the cells.
  struct Shape {
    int radius = 0;  // of the window [cells]
    double outer = 0.0, inscribed = 0.0, margin = 0.0, largest_clearance = 0.0, resolution = 0.0;  // [m]
    bool circle = false;
    bool operator==(const Shape& other) const {
      return radius == other.radius && outer == other.outer && inscribed == other.inscribed && margin == other.margin &&
             largest_clearance == other.largest_clearance && resolution == other.resolution && circle == other.circle;
    }
  };
  std::uint8_t flags_of(Cell cell) const { return cells_.at(cell.i - first_.i, cell.j - first_.j); }
  void mark_costs(CellFlags& cells) const;
  bool mark_obstacles(const Shape& shape);
  void spread_marks();
  void prepare_lists();
  bool centre_collides(Cell cell) const;
  // Where the robot is placed, and the box of its outline there.
  struct Placed {
    Pose2 pose;
    double lo_x = 0.0, lo_y = 0.0, hi_x = 0.0, hi_y = 0.0;
  };
  Placed place(const Pose2& pose, const Rotation& heading) const;
  double gap_to(const Pose2& pose, double x, double y) const;
  double smallest_gap(const Placed& placed, double cap) const;
  template <typename Visit>
  void visit_obstacles(const Placed& placed, double around, Visit&& visit) const;

  GridView grid_;
  const Footprint* footprint_ = nullptr;
  bool unknown_is_obstacle_ = true;
  Cell first_;  // of the window, map cells
  Shape shape_;
  int rim_ = 0;      // cells at the window's rim whose classes are not known
  CellFlags cells_;  // of the window
  CellFlags fresh_;  // this cycle's costs, before they are taken
  std::vector<int> reach_;
  mutable ObstacleLists lists_;
  mutable OutlinePlanes planes_;  // of the outline as it was placed last, from its position
  mutable Polygon corners_;       // likewise, where it is not convex
};

/// True when a simple polygon shares area with the axis-parallel square [x, x + side] x [y, y + side].
bool overlaps_square(const Polygon& polygon, double x, double y, double side);

/// The distance between a simple polygon and that square where they share no area [m].
double distance_to_square(const Polygon& polygon, double x, double y, double side);

}  // namespace hidwa_local_planner
