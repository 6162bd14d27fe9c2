// SPDX-License-Identifier: BSD-3-Clause
#include "start.hpp"

#include <algorithm>
#include <cmath>

namespace hidwa_attack {
namespace {

struct Depths {
  double least = 0.0, most = 0.0;  // [m]
};

// Sets `count` cells in which the robot lies so deep; where it is apart from them, negative.
void put_cells(World& world, const Placed& placed, int count, const Depths& depth, Random& random) {
  const double side = world.resolution(), around = std::max(0.0, -depth.least) + side;
  for (int attempt = 0; attempt < 2000 && count > 0; ++attempt) {
    const int i = world.cell(random.in(placed.low().x - around, placed.high().x + around));
    const int j = world.cell(random.in(placed.low().y - around, placed.high().y + around));
    const double here = placed.depth_in(i * side, j * side, side);
    if (world.lethal(i, j) || here < depth.least || here > depth.most) continue;
    world.set(i, j, true);
    --count;
  }
}

}  // namespace

void put_stray_cells(World& world, const Shape& padded_shape, const Pose2& pose, Random& random) {
  put_cells(world, Placed(padded_shape, pose), random.whole(1, 3), {0.001, 0.15}, random);
}

void put_cells_around(World& world, const Shape& padded_shape, const Pose2& pose, Random& random) {
  put_cells(world, Placed(padded_shape, pose), random.whole(0, 12), {-0.4, -0.01}, random);
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
