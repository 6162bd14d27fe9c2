// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "drive/rolling_grid.hpp"

namespace hidwa_local_planner {
namespace drive {

/// How costs fall off round obstacles, in the words of costmap_2d's inflation layer.
struct InflationSettings {
  double inflation_radius = 0.8;     // [m], no cost beyond
  double cost_scaling_factor = 3.0;  // [1/m]
};

/// The cost at a distance [m] between cell centres: lethal at 0, inscribed up to `inscribed_radius` [m], then
/// falling off exponentially.
std::uint8_t inflated_cost(double distance, double inscribed_radius, double cost_scaling_factor);

/// Spreads costs round lethal cells, by the exact distance between cell centres.
class Inflation {
 public:
  /// `inscribed_radius` and `resolution` in [m].
  Inflation(const InflationSettings& settings, double inscribed_radius, double resolution);

  /// Fills `costs` from the lethal cells of `obstacles`, a grid of the same geometry; other costs of it do
  /// not count.
  void inflate(const RollingGrid& obstacles, RollingGrid& costs) const;

 private:
  void stamp(int i, int j, RollingGrid& costs) const;

  int radius_;                       // [cells]
  std::vector<std::uint8_t> stamp_;  // what one lethal cell costs around it, row by row
};

}  // namespace drive
}  // namespace hidwa_local_planner
