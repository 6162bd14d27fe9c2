// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "attack/shape.hpp"

namespace hidwa_ways {

using hidwa_attack::Pose2;
using hidwa_attack::Shape;
using hidwa_attack::Spot;

/// An outline with a name.
struct Body {
  const char* name = "";
  Shape shape;  // robot frame [m]
};

constexpr int kBodies = 5;
/// Circle, square, two long rectangles, and a rectangle whose centre is near one end.
const std::array<Body, kBodies>& all_bodies();

/// Half of its smallest width [m]: it passes a gap twice as wide at best.
double half_width(const Shape& shape);

}  // namespace hidwa_ways
