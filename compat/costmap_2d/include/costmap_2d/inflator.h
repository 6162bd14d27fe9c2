// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <costmap_2d/costmap_2d.h>

#include <vector>

namespace costmap_2d {

/// Spreads costs round lethal cells by exact distance between cell centres.
class Inflator {
 public:
  struct Settings {
    double inflation_radius = 0.55;     // [m] no cost beyond
    double inscribed_radius = 0.0;      // [m] up to here the robot collides whatever its heading
    double cost_scaling_factor = 10.0;  // [1/m]
    double resolution = 0.05;           // [m/cell]
    bool inflate_unknown = false;       // unknown cells take any cost, not only inscribed ones
  };

  void configure(const Settings& settings);

  /// The cost at a distance [m] from an obstacle: lethal at 0, inscribed up to the inscribed radius, beyond
  /// 252 exp(-cost_scaling_factor (distance - inscribed_radius)).
  unsigned char costAt(double distance) const;

  int radiusInCells() const { return radius_; }

  /// Raises the costs of cells min_i <= x < max_i, min_j <= y < max_j; lethal cells outside that window count
  /// as well.
  void inflate(Costmap2D& grid, int min_i, int min_j, int max_i, int max_j);

 private:
  struct Window {
    int x0, xn, y0, yn;
  };
  void columnDistances(const Costmap2D& grid, const Window& seen);
  void inflateRow(Costmap2D& grid, int y, int min_i, int max_i, const Window& seen);
  unsigned char combined(unsigned char old_cost, unsigned char cost) const;

  Settings settings_;
  int radius_ = 0;                          // [cells]
  std::vector<unsigned char> cost_;         // by squared distance in cells
  std::vector<int> column_;                 // squared distance to the nearest lethal cell of the same column
  std::vector<unsigned char> row_has_any_;  // by row of the window: some column distance within the radius
  std::vector<int> padded_, nearest_;       // one row's work
};

}  // namespace costmap_2d
