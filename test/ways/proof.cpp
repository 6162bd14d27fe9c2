// SPDX-License-Identifier: BSD-3-Clause
#include "ways/proof.hpp"

#include <array>
#include <cstdint>
#include <queue>
#include <utility>

namespace hidwa_ways {
namespace {

struct Cell {
  int column = 0, row = 0, heading = 0;
};

class Flood {
 public:
  Flood(const Ground& ground, const Lattice& lattice, const Shape& shape, bool reverse, const Target& target)
      : ground_(ground),
        lattice_(lattice),
        outlines_(turned_to(lattice, hidwa_attack::padded(shape, -reach_of_cell(lattice, shape) - 1e-6), 1)),
        reverse_(reverse),
        target_(target),
        seen_(lattice.size(), 0) {}

  // Whether a cell within `tolerance` [m] of the target is reached. Those near it come first: most often there is a
  // way.
  bool reaches(const Cell& start, double tolerance) {
    visit(start);
    while (!queue_.empty()) {
      if (-queue_.top().first <= tolerance) return true;
      const Cell at = queue_.top().second;
      queue_.pop();
      for (const int side : {-1, 1}) {
        visit({at.column, at.row, lattice_.wrap(at.heading + side)});
        if (leads(at.heading, side, 0.0)) visit({at.column + side, at.row, at.heading});
        if (leads(at.heading, side, 0.5 * M_PI)) visit({at.column, at.row + side, at.heading});
      }
    }
    return false;
  }

 private:
  // Whether a heading of this cell leads to that side of the axis with this direction [rad].
  bool leads(int heading, int side, double axis) const {
    if (reverse_) return true;
    const double off = std::remainder(lattice_.heading(heading) - axis - (side > 0 ? 0.0 : M_PI), 2.0 * M_PI);
    return std::abs(off) <= 0.5 * M_PI + 0.5 * lattice_.turn() + 1e-9;
  }

  void visit(const Cell& cell) {
    if (!lattice_.has(cell.column, cell.row)) return;
    std::uint8_t& seen = seen_[lattice_.index(cell.column, cell.row, cell.heading)];
    if (seen != 0) return;
    seen = 1;
    const double x = lattice_.middle_x(cell.column), y = lattice_.middle_y(cell.row);
    if (ground_.overlaps(outlines_[static_cast<std::size_t>(cell.heading)], x, y)) return;
    queue_.push({-target_.distance(x, y), cell});
  }

  struct Farther {
    using Entry = std::pair<double, Cell>;
    bool operator()(const Entry& a, const Entry& b) const { return a.first < b.first; }
  };
  const Ground& ground_;
  const Lattice& lattice_;
  std::vector<Turned> outlines_;
  bool reverse_;
  const Target& target_;
  std::vector<std::uint8_t> seen_;
  std::priority_queue<Farther::Entry, std::vector<Farther::Entry>, Farther> queue_;
};

}  // namespace

bool surely_no_way(const Ground& ground, const Lattice& lattice, const Shape& shape, bool reverse, const Pose2& start,
                   const Target& target, double tolerance) {
  Flood flood(ground, lattice, shape, reverse, target);
  const Cell first{lattice.column(start.x), lattice.row(start.y), lattice.turned(start.theta)};
  return !flood.reaches(first, tolerance + lattice.step());
}

}  // namespace hidwa_ways
