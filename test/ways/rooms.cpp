// SPDX-License-Identifier: BSD-3-Clause
#include "ways/rooms.hpp"

#include <algorithm>
#include <cmath>

#include "ways/drawing.hpp"

namespace hidwa_ways {
namespace {

constexpr double kRoom = 12.0;  // [m]
constexpr Spot kMiddle{0.5 * kRoom, 0.5 * kRoom};

World room(const Measure& measure) {
  World world(kRoom, kRoom, measure.resolution);
  wall_in(world);
  return world;
}

// Half of them along the grid: there half a cell decides.
double direction(Random& random) {
  return random.chance(0.5) ? 0.5 * M_PI * random.whole(0, 3) : random.in(-M_PI, M_PI);
}

Spot anywhere(Random& random) {
  const double x = random.in(1.5, kRoom - 1.5);
  return {x, random.in(1.5, kRoom - 1.5)};
}

// So thick that no slanted wall has a hole [m].
double thickness(const Measure& measure, Random& random) {
  return std::max(1.6 * measure.resolution, random.in(0.05, 0.3));
}

void add_posts(World& world, int count, Random& random) {
  for (int k = 0; k < count; ++k) {
    const double radius = random.in(0.04, 0.15);
    fill_disc(world, anywhere(random), radius, true);
  }
}

// A wall from a place on in a direction.
void wall(World& world, const Spot& from, double along, double length, double thick) {
  const Spot middle = farther(from, along, 0.5 * length);
  fill_box(world, {middle.x, middle.y, along}, length, thick, true);
}

}  // namespace

Site posts(const Measure& measure, Random& random) {
  Site site{room(measure), kMiddle};
  add_posts(site.world, static_cast<int>(81.0 * random.in(0.8, 2.0)), random);
  return site;
}

Site boxes(const Measure& measure, Random& random) {
  Site site{room(measure), kMiddle};
  for (int count = static_cast<int>(81.0 * random.in(0.3, 0.7)); count > 0; --count) {
    const Spot at = anywhere(random);
    const double length = random.in(0.2, 1.0), width = random.in(0.1, 0.6);
    fill_box(site.world, {at.x, at.y, direction(random)}, length, width, true);
  }
  return site;
}

Site dead_end(const Measure& measure, Random& random) {
  Site site{room(measure), kMiddle, 0.3, false};
  add_posts(site.world, random.whole(0, 60), random);
  const double open = direction(random),
               half = measure.half_width + random.of({random.in(0.03, 0.1), random.in(0.03, 0.4)});
  const double depth = random.in(0.5, 1.4), thick = thickness(measure, random);
  fill_box(site.world, {kMiddle.x, kMiddle.y, open}, 2.0 * depth, 2.0 * half, false);
  const Spot back = farther(kMiddle, open, -depth);
  for (const double side : {-0.5 * M_PI, 0.5 * M_PI}) {
    const Spot edge = farther(back, open + side, half + 0.5 * thick);
    wall(site.world, edge, open, depth + random.in(0.3, 1.0), thick);
    wall(site.world, farther(back, open, -0.5 * thick), open + side, half + thick, thick);
  }
  return site;
}

Site doorway(const Measure& measure, Random& random) {
  Site site{room(measure), kMiddle, 1.5, true};
  add_posts(site.world, random.whole(0, 40), random);
  const double across = direction(random), thick = thickness(measure, random);
  const double half = measure.half_width + random.in(-0.1, 0.2);
  fill_box(site.world, {kMiddle.x, kMiddle.y, across}, 2.0 * half, 1.6, false);
  wall(site.world, farther(kMiddle, across, half), across, kRoom, thick);
  wall(site.world, farther(kMiddle, across, -half), across + M_PI, kRoom, thick);
  return site;
}

Site corridor(const Measure& measure, Random& random) {
  Site site{room(measure), kMiddle, 1.5, true};
  fill_box(site.world, {kMiddle.x, kMiddle.y, 0.0}, kRoom, kRoom, true);
  const double first = direction(random), bend = random.of({-1.0, 1.0}) * random.of({0.25, 0.5, random.in(0.15, 0.6)});
  const double half = measure.half_width + random.of({random.in(0.0, 0.1), random.in(0.0, 0.3)});
  const double length = random.in(2.0, 3.5);
  for (const double along : {first, first + M_PI + bend * M_PI}) {
    const Spot middle = farther(kMiddle, along, 0.5 * length), end = farther(kMiddle, along, length);
    fill_box(site.world, {middle.x, middle.y, along}, length + 2.0 * half, 2.0 * half, false);
    fill_disc(site.world, end, random.in(0.8, 1.3), false);
  }
  return site;
}

Site corner(const Measure& measure, Random& random) {
  Site site{room(measure), kMiddle, 1.2, true};
  add_posts(site.world, random.whole(0, 40), random);
  const double turned = direction(random), away = turned + 0.25 * M_PI;
  // The block's corner looks along `away`; the passage round it is as wide as `gap`.
  const double gap = 2.0 * measure.half_width + random.in(0.0, 0.5), side = 4.0;
  const Spot middle = farther(kMiddle, away, -side * std::sqrt(0.5));
  const Spot opposite = farther(kMiddle, away, gap + 0.5);
  fill_disc(site.world, kMiddle, gap, false);
  fill_box(site.world, {middle.x, middle.y, turned}, side, side, true);
  fill_box(site.world, {opposite.x, opposite.y, away}, 1.0, random.in(0.1, 4.0), true);
  return site;
}

}  // namespace hidwa_ways
