// SPDX-License-Identifier: BSD-3-Clause
#include "ways/drawing.hpp"

#include <algorithm>
#include <cmath>

namespace hidwa_ways {
namespace {

// Sets the cells within `reach` [m] of a place for which `inside` holds.
template <typename Inside>
void fill(World& world, const Spot& middle, double reach, bool lethal, Inside&& inside) {
  const int first_i = std::max(0, world.cell(middle.x - reach)), first_j = std::max(0, world.cell(middle.y - reach));
  const int last_i = std::min(world.columns() - 1, world.cell(middle.x + reach));
  const int last_j = std::min(world.rows() - 1, world.cell(middle.y + reach));
  for (int j = first_j; j <= last_j; ++j) {
    for (int i = first_i; i <= last_i; ++i) {
      if (inside(world.middle(i) - middle.x, world.middle(j) - middle.y)) world.set(i, j, lethal);
    }
  }
}

}  // namespace

void fill_box(World& world, const Pose2& middle, double length, double width, bool lethal) {
  const double c = std::cos(middle.theta), s = std::sin(middle.theta);
  fill(world, {middle.x, middle.y}, 0.5 * std::hypot(length, width), lethal, [&](double dx, double dy) {
    return std::abs(c * dx + s * dy) <= 0.5 * length && std::abs(c * dy - s * dx) <= 0.5 * width;
  });
}

void fill_disc(World& world, const Spot& middle, double radius, bool lethal) {
  fill(world, middle, radius, lethal, [&](double dx, double dy) { return std::hypot(dx, dy) <= radius; });
}

void wall_in(World& world) {
  for (int j = 0; j < world.rows(); ++j) {
    for (int i = 0; i < world.columns(); ++i) {
      if (std::min({i, j, world.columns() - 1 - i, world.rows() - 1 - j}) < 2) world.set(i, j, true);
    }
  }
}

Spot farther(const Spot& from, double direction, double by) {
  return {from.x + by * std::cos(direction), from.y + by * std::sin(direction)};
}

}  // namespace hidwa_ways
