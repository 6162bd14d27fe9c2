// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "ways/ground.hpp"

namespace hidwa_ways {

/// A square of the world, in which the robot's centre has to stay.
struct Region {
  double x = 0.0, y = 0.0;  // its lower left corner [m]
  double side = 0.0;        // [m]
  bool has(double px, double py) const { return px >= x && py >= y && px < x + side && py < y + side; }
};

/// Poses in cells: of position, and of heading about multiples of an angle, counted from the heading of the start.
class Lattice {
 public:
  Lattice(const Region& region, double step, double heading, int headings = 90)
      : region_(region),
        step_(step),
        heading_(heading),
        headings_(headings),
        across_(static_cast<int>(std::ceil(region.side / step))) {}

  const Region& region() const { return region_; }
  double step() const { return step_; }  // of position [m]
  int headings() const { return headings_; }
  double turn() const { return 2.0 * M_PI / headings_; }  // of heading [rad]
  int across() const { return across_; }
  std::size_t size() const {
    return static_cast<std::size_t>(headings_) * static_cast<std::size_t>(across_) * static_cast<std::size_t>(across_);
  }
  int column(double x) const { return static_cast<int>(std::floor((x - region_.x) / step_)); }
  int row(double y) const { return static_cast<int>(std::floor((y - region_.y) / step_)); }
  double middle_x(int column) const { return region_.x + (column + 0.5) * step_; }
  double middle_y(int row) const { return region_.y + (row + 0.5) * step_; }
  bool has(int column, int row) const { return column >= 0 && row >= 0 && column < across_ && row < across_; }
  int wrap(int k) const { return ((k % headings_) + headings_) % headings_; }
  int turned(double theta) const { return wrap(static_cast<int>(std::lround((theta - heading_) / turn()))); }
  double heading(int k) const { return heading_ + k * turn(); }  // [rad]
  std::size_t index(int column, int row, int k) const {
    return (static_cast<std::size_t>(row) * static_cast<std::size_t>(across_) + static_cast<std::size_t>(column)) *
               static_cast<std::size_t>(headings_) +
           static_cast<std::size_t>(k);
  }

 private:
  Region region_;
  double step_, heading_;  // [m], [rad]
  int headings_, across_;
};

/// A shape at every heading of a lattice, and between: number `per` k is heading k.
inline std::vector<Turned> turned_to(const Lattice& lattice, const Shape& shape, int per) {
  std::vector<Turned> all;
  for (int k = 0; k < per * lattice.headings(); ++k)
    all.emplace_back(shape, lattice.heading(0) + k * lattice.turn() / per);
  return all;
}

/// How far any point of a robot may be from where it is at its cell's middle [m].
inline double reach_of_cell(const Lattice& lattice, const Shape& shape) {
  return lattice.step() * std::sqrt(0.5) + 0.5 * lattice.turn() * hidwa_attack::outermost(shape);
}

}  // namespace hidwa_ways
