// SPDX-License-Identifier: BSD-3-Clause
#include "world_building.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace hidwa_attack {
namespace {

constexpr double kStartGap = 0.03;  // [m]

// Sets or clears the cells whose middle lies within `reach` [m] of the line from a to b.
void draw(World& world, const Spot& a, const Spot& b, double reach, bool lethal) {
  const int first_i = world.cell(std::min(a.x, b.x) - reach), last_i = world.cell(std::max(a.x, b.x) + reach);
  const int first_j = world.cell(std::min(a.y, b.y) - reach), last_j = world.cell(std::max(a.y, b.y) + reach);
  const double dx = b.x - a.x, dy = b.y - a.y, length2 = dx * dx + dy * dy;
  for (int j = first_j; j <= last_j; ++j) {
    for (int i = first_i; i <= last_i; ++i) {
      const double px = world.middle(i) - a.x, py = world.middle(j) - a.y;
      const double t = length2 > 0.0 ? std::clamp((px * dx + py * dy) / length2, 0.0, 1.0) : 0.0;
      if (std::hypot(px - t * dx, py - t * dy) <= reach) world.set(i, j, lethal);
    }
  }
}

Spot anywhere(const World& world, Random& random) {
  const double x = random.in(0.2, world.width() - 0.2);
  return {x, random.in(0.2, world.height() - 0.2)};
}

Spot farther(const Spot& from, double angle, double by) {
  return {from.x + by * std::cos(angle), from.y + by * std::sin(angle)};
}

// Half of them along the grid: there a pose of one cell more or less decides.
double direction(Random& random) {
  return random.chance(0.5) ? 0.5 * M_PI * random.whole(0, 3) : random.in(-M_PI, M_PI);
}

void wall_in(World& world) {
  const double w = world.width(), h = world.height(), thick = 1.01 * world.resolution();
  draw(world, {0.0, 0.0}, {w, 0.0}, thick, true);
  draw(world, {0.0, h}, {w, h}, thick, true);
  draw(world, {0.0, 0.0}, {0.0, h}, thick, true);
  draw(world, {w, 0.0}, {w, h}, thick, true);
}

void add_posts(World& world, Random& random) {
  const int count = static_cast<int>(world.width() * world.height() * random.in(0.25, 0.7));
  for (int k = 0; k < count; ++k) {
    const Spot at = anywhere(world, random);
    draw(world, at, at, random.in(0.5 * world.resolution(), 0.2), true);
  }
}

void add_walls(World& world, Random& random) {
  const int count = static_cast<int>(world.width() * world.height() * random.in(0.08, 0.16));
  for (int k = 0; k < count; ++k) {
    const Spot from = anywhere(world, random);
    const double length = random.in(0.5, 3.0);
    draw(world, from, farther(from, direction(random), length), 0.71 * world.resolution(), true);
  }
}

void add_dead_ends(World& world, const Shape& shape, Random& random) {
  const int count = static_cast<int>(world.width() * world.height() * random.in(0.04, 0.08));
  for (int k = 0; k < count; ++k) {
    const Spot end = anywhere(world, random);
    const double angle = direction(random), half = innermost(shape) + random.in(0.05, 0.4);
    const Spot left = farther(end, angle + 0.5 * M_PI, half), right = farther(end, angle - 0.5 * M_PI, half);
    const double length = random.in(0.8, 2.0), reach = 0.71 * world.resolution();
    draw(world, left, right, reach, true);
    draw(world, left, farther(left, angle, length), reach, true);
    draw(world, right, farther(right, angle, length), reach, true);
  }
}

void add_clutter(World& world, Random& random) {
  const double share = random.in(0.001, 0.004) * world.resolution() / 0.05;
  for (int j = 0; j < world.rows(); ++j) {
    for (int i = 0; i < world.columns(); ++i) {
      if (random.chance(share)) world.set(i, j, true);
    }
  }
}

// Solid, and carved out of it a way that is little wider than the robot, with room to turn at its bends.
Pose2 carve_corridor(World& world, const Shape& shape, Random& random) {
  const Spot middle{0.5 * world.width(), 0.5 * world.height()};
  draw(world, middle, middle, world.width(), true);
  const double reach = innermost(shape) + world.resolution() + random.in(0.02, 0.15);
  const double room = outermost(shape) + random.in(0.05, 0.2);
  const double angle = direction(random);
  Spot at = farther(middle, angle, -0.6);
  draw(world, at, at, room, false);
  double heading = angle;
  for (int k = 0; k < 5; ++k) {
    const Spot next = farther(at, heading, k == 0 ? 2.0 : random.in(1.0, 2.5));
    const Spot kept{std::clamp(next.x, room, world.width() - room), std::clamp(next.y, room, world.height() - room)};
    draw(world, at, kept, reach, false);
    draw(world, kept, kept, room, false);
    at = kept;
    heading += random.of({-0.5, 0.5, 0.25, -0.25}) * M_PI;
  }
  return {middle.x, middle.y, angle};
}

bool stands_free(const World& world, const Shape& shape, const Pose2& pose) {
  return deepest(world, Placed(shape, pose), kStartGap) <= -kStartGap;
}

// Somewhere in the midst; where no place is free, one is made.
Pose2 find_start(World& world, const Shape& shape, const Pose2& wanted, Random& random) {
  Pose2 pose = wanted;
  for (int attempt = 0; attempt < 300; ++attempt) {
    if (stands_free(world, shape, pose)) return pose;
    pose = {world.width() * random.in(0.3, 0.7), world.height() * random.in(0.3, 0.7), random.in(-M_PI, M_PI)};
  }
  const Spot at{pose.x, pose.y};
  draw(world, at, at, outermost(shape) + kStartGap + world.resolution(), false);
  return pose;
}

}  // namespace

const char* name_of(Place place) {
  switch (place) {
    case Place::posts:
      return "posts";
    case Place::walls:
      return "walls";
    case Place::corridor:
      return "corridor";
    case Place::dead_ends:
      return "dead_ends";
    case Place::clutter:
      return "clutter";
    case Place::open:
      return "open";
  }
  return "";
}

Scenery cut(const World& ground, double size, const Shape& shape, Random& random) {
  constexpr int kAttempts = 20000;
  constexpr double kNear = 0.6;  // [m]
  const double edge = outermost(shape) + kNear;
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    const Pose2 pose{random.in(edge, ground.width() - edge), random.in(edge, ground.height() - edge),
                     random.in(-M_PI, M_PI)};
    if (ground.lethal(ground.cell(pose.x), ground.cell(pose.y)) || !stands_free(ground, shape, pose)) continue;
    // Open floor threatens nobody.
    if (deepest(ground, Placed(shape, pose), kNear) <= -kNear && attempt < kAttempts / 2) continue;
    const int half = static_cast<int>(0.5 * size / ground.resolution());
    const int first_i = ground.cell(pose.x) - half, first_j = ground.cell(pose.y) - half;
    World world(2 * half * ground.resolution(), 2 * half * ground.resolution(), ground.resolution());
    for (int j = 0; j < world.rows(); ++j) {
      for (int i = 0; i < world.columns(); ++i) {
        const bool there = ground.has(first_i + i, first_j + j);
        world.set(i, j, !there || ground.lethal(first_i + i, first_j + j));
      }
    }
    const Pose2 start{pose.x - first_i * ground.resolution(), pose.y - first_j * ground.resolution(), pose.theta};
    wall_in(world);
    return {std::move(world), start};
  }
  throw std::invalid_argument("the robot fits nowhere on this ground");
}

Scenery build(Place place, double size, double resolution, const Shape& shape, Random& random) {
  World world(size, size, resolution);
  Pose2 start{0.5 * size, 0.5 * size, random.in(-M_PI, M_PI)};
  switch (place) {
    case Place::posts:
      add_posts(world, random);
      break;
    case Place::walls:
      add_walls(world, random);
      break;
    case Place::corridor:
      start = carve_corridor(world, shape, random);
      break;
    case Place::dead_ends:
      add_dead_ends(world, shape, random);
      break;
    case Place::clutter:
      add_clutter(world, random);
      break;
    case Place::open:
      break;
  }
  wall_in(world);
  start = find_start(world, shape, start, random);
  return {std::move(world), start};
}

}  // namespace hidwa_attack
