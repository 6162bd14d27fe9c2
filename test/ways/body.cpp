// SPDX-License-Identifier: BSD-3-Clause
#include "ways/body.hpp"

#include <algorithm>

namespace hidwa_ways {
namespace {

Shape rectangle(double length, double width) {
  const double x = 0.5 * length, y = 0.5 * width;
  return {{{-x, -y}, {x, -y}, {x, y}, {-x, y}}, 0.0};
}

}  // namespace

const std::array<Body, kBodies>& all_bodies() {
  using hidwa_attack::Outline;
  static const std::array<Body, kBodies> bodies = {{{"circle", shape_of(Outline::circle)},
                                                    {"square", rectangle(0.5, 0.5)},
                                                    {"rectangle", rectangle(0.6, 0.4)},
                                                    {"long_rectangle", shape_of(Outline::long_rectangle)},
                                                    {"off_centre", shape_of(Outline::off_centre)}}};
  return bodies;
}

// All of them are narrowest across.
double half_width(const Shape& shape) {
  if (shape.radius > 0.0) return shape.radius;
  double left = 0.0, right = 0.0;
  for (const Spot& corner : shape.corners) {
    left = std::max(left, corner.y);
    right = std::max(right, -corner.y);
  }
  return 0.5 * (left + right);
}

}  // namespace hidwa_ways
