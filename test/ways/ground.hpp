// SPDX-License-Identifier: BSD-3-Clause
// Which lethal cells an outline overlaps: the fast check of the searches. Row by row of cells.
//
// 1. Once a world: the number of lethal cells left of and below each cell (a summed-area table). How many lie in a
//    rectangle of cells is then four look-ups.
// 2. Once a heading: the outline turned to it.
// 3. Each pose: in each row of cells that the outline crosses, its extent along x; a lethal cell within is an overlap.
//
// Right because a convex outline cut by a row is one interval. A test compares it with the separating axes of
// attack/shape, with which it shares nothing.
#pragma once

#include <vector>

#include "attack/world.hpp"
#include "ways/body.hpp"

namespace hidwa_ways {

using hidwa_attack::World;

/// An outline turned to one heading.
class Turned {
 public:
  Turned(const Shape& shape, double heading);

  struct Interval {
    double low = 0.0, high = 0.0;  // [m]; empty where low > high
  };
  /// Its extent along x between two heights, relative to the robot's centre.
  Interval across(double bottom, double top) const;
  Interval x() const { return x_; }
  Interval y() const { return y_; }
  /// Half the side of a square about the robot's centre that lies inside, axis-parallel [m].
  double core() const { return core_; }

 private:
  struct Edge {
    Spot a, b;           // a is not above b
    double slope = 0.0;  // dx / dy
  };
  double radius_ = 0.0;  // of a circle [m]
  double core_ = 0.0;
  Interval x_, y_;
  std::vector<Edge> edges_;
};

/// A world prepared for many checks; keeps nothing of the world. Beyond its border everything is lethal.
class Ground {
 public:
  explicit Ground(const World& world);
  bool overlaps(const Turned& outline, double x, double y) const;

 private:
  int cell(double metres) const { return static_cast<int>(std::floor(metres * per_metre_)); }
  bool any(int first_i, int first_j, int last_i, int last_j) const;
  int sum(int i, int j) const {
    return sums_[static_cast<std::size_t>(j) * static_cast<std::size_t>(columns_ + 1) + static_cast<std::size_t>(i)];
  }

  double resolution_, per_metre_;  // [m], [1/m]
  int columns_, rows_;
  std::vector<int> sums_;  // of the cells left of i and below j
};

}  // namespace hidwa_ways
