// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "hidwa_local_planner/core/grid_view.hpp"
#include "world.hpp"

namespace hidwa_attack {

using hidwa_local_planner::GridView;

/// The rolling window of costs that the planner is given: 254 lethal, 253 within the inscribed radius of a lethal
/// cell's middle, falling off beyond, as costmap_2d fills them.
class LocalMap {
 public:
  /// `side` of the window and `inscribed` radius [m].
  LocalMap(const World& world, double side, double inscribed);
  /// The world has changed.
  void renew(const World& world);
  /// Around a pose; valid until the next call.
  GridView around(const Pose2& pose);
  /// Frees those cells of the last view whose middle is farther than `sight` [m] from where the sensor was.
  void forget_beyond(const Pose2& sensor, double sight);

 private:
  double resolution_, inscribed_;  // [m]
  int columns_, rows_, size_;      // of the world, of the window
  int first_i_ = 0, first_j_ = 0;  // the window's first cell
  std::vector<std::uint8_t> costs_, window_;
};

}  // namespace hidwa_attack
