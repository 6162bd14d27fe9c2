// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>

#include "hidwa_local_planner/core/types.hpp"

namespace hidwa_local_planner {

/// The values of costmap_2d's cells.
namespace cost {
constexpr std::uint8_t kFree = 0;
constexpr std::uint8_t kInscribed = 253;
constexpr std::uint8_t kLethal = 254;
constexpr std::uint8_t kUnknown = 255;

/// A robot whose centre is in a cell of this cost touches something.
constexpr bool blocks(std::uint8_t value) { return value == kLethal || value == kInscribed; }
}  // namespace cost

/// A cell, column i along x and row j along y; may lie outside the grid.
struct Cell {
  int i = 0;
  int j = 0;
};

/// A view of costs that another object owns, row-major, row 0 at the origin. Axis-parallel in the costmap frame.
struct GridView {
  const std::uint8_t* costs = nullptr;  // size_x * size_y values
  int size_x = 0;                       // [cells]
  int size_y = 0;                       // [cells]
  double resolution = 0.05;             // [m]
  double origin_x = 0.0;                // lower left corner of cell (0, 0), costmap frame [m]
  double origin_y = 0.0;                // [m]

  bool valid() const { return costs != nullptr && size_x > 0 && size_y > 0 && resolution > 0.0; }
  bool contains(Cell c) const {
    return static_cast<unsigned>(c.i) < static_cast<unsigned>(size_x) &&
           static_cast<unsigned>(c.j) < static_cast<unsigned>(size_y);
  }
  /// Whether a point lies on the map; no number does not. For points that nobody has looked at yet.
  bool holds(const Point& p) const {
    const double i = (p.x() - origin_x) / resolution, j = (p.y() - origin_y) / resolution;
    return i >= 0.0 && j >= 0.0 && i < size_x && j < size_y;
  }
  std::size_t index(Cell c) const {
    return static_cast<std::size_t>(c.j) * static_cast<std::size_t>(size_x) + static_cast<std::size_t>(c.i);
  }
  std::uint8_t at(Cell c) const { return costs[index(c)]; }
  /// Lethal, unknown where that is an obstacle, or beyond the map's edge.
  bool obstacle(Cell c, bool unknown_is_obstacle) const {
    if (!contains(c)) return true;
    const std::uint8_t value = at(c);
    return value == cost::kLethal || (value == cost::kUnknown && unknown_is_obstacle);
  }
  /// The cell that holds a point; a point on a border belongs to the higher cell.
  Cell cell_at(double x, double y) const {
    return {floor_to_int((x - origin_x) / resolution), floor_to_int((y - origin_y) / resolution)};
  }
  /// floor() without the call that it is on plain x86-64.
  static int floor_to_int(double value) {
    const int truncated = static_cast<int>(value);
    return value < truncated ? truncated - 1 : truncated;
  }
  Point centre(Cell c) const { return {origin_x + (c.i + 0.5) * resolution, origin_y + (c.j + 0.5) * resolution}; }
  std::size_t cell_count() const { return static_cast<std::size_t>(size_x) * static_cast<std::size_t>(size_y); }
};

}  // namespace hidwa_local_planner
