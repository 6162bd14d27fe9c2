// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace hidwa_local_planner {
namespace sim {

enum class Cell : std::uint8_t { kFree = 0, kOccupied = 1, kUnknown = 2 };

/// Where the cells of a grid lie in the map frame: row 0 at the bottom, its axes parallel to the frame's.
struct GridGeometry {
  int width = 0;            // [cells]
  int height = 0;           // [cells]
  double resolution = 0.0;  // [m], side of a cell
  double origin_x = 0.0;    // [m], lower left corner of cell (0, 0), map frame
  double origin_y = 0.0;    // [m]

  bool inside(int column, int row) const { return column >= 0 && row >= 0 && column < width && row < height; }
  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(width) + static_cast<std::size_t>(column);
  }
  int column(double x) const { return static_cast<int>(std::floor((x - origin_x) / resolution)); }
  int row(double y) const { return static_cast<int>(std::floor((y - origin_y) / resolution)); }
  double center_x(int column) const { return origin_x + (column + 0.5) * resolution; }  // [m]
  double center_y(int row) const { return origin_y + (row + 0.5) * resolution; }        // [m]
};

/// The true map.
struct OccupancyMap : GridGeometry {
  std::vector<Cell> cells;  // width * height, row by row

  /// Outside the map nothing is occupied.
  bool occupied(int column, int row) const {
    return inside(column, row) && cells[index(column, row)] == Cell::kOccupied;
  }
};

/// An empty map: every cell free.
OccupancyMap make_map(int width, int height, double resolution, double origin_x = 0.0, double origin_y = 0.0);

/// Reads a map in map_server's format: a YAML with image (PGM, P2 or P5), resolution, origin, negate,
/// occupied_thresh and free_thresh (`mode: trinary`). Throws std::runtime_error naming file, fault and
/// remedy.
OccupancyMap load_map(const std::string& yaml_path);

}  // namespace sim
}  // namespace hidwa_local_planner
