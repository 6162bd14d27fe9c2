// SPDX-License-Identifier: BSD-3-Clause
#include "start.hpp"

#include <cmath>

namespace hidwa_attack {

void put_stray_cells(World& world, const Shape& padded_shape, const Pose2& pose, Random& random) {
  const Placed placed(padded_shape, pose);
  const double side = world.resolution();
  int left = random.whole(1, 3);
  for (int attempt = 0; attempt < 2000 && left > 0; ++attempt) {
    const int i = world.cell(random.in(placed.low().x - side, placed.high().x + side));
    const int j = world.cell(random.in(placed.low().y - side, placed.high().y + side));
    const double depth = placed.depth_in(i * side, j * side, side);
    if (world.lethal(i, j) || depth < 0.001 || depth > 0.15) continue;
    world.set(i, j, true);
    --left;
  }
}

Pose2 grazing_pose(const World& world, const Shape& padded_shape, const Pose2& fallback, Random& random) {
  for (int attempt = 0; attempt < 5000; ++attempt) {
    const Pose2 pose{random.in(0.6, world.width() - 0.6), random.in(0.6, world.height() - 0.6), random.in(-M_PI, M_PI)};
    const double depth = deepest(world, Placed(padded_shape, pose), 0.01);
    if (depth > 0.002 && depth < 1.5 * world.resolution()) return pose;
  }
  return fallback;
}

}  // namespace hidwa_attack
