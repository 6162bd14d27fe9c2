// SPDX-License-Identifier: BSD-3-Clause
#include "critics/side_gaps.hpp"

#include <cstring>
#include <limits>

#include "hidwa_local_planner/core/util/vector_clones.hpp"

namespace hidwa_local_planner::critics {
namespace {

struct Sides {
  const double *normal_x, *normal_y, *offset;
  std::size_t count;
};

HIDWA_VECTOR_CLONES
void place_sides(const Sides& sides, const double* x, const double* y, std::size_t places, double* along) {
  static_assert(SideGaps::kPad % 4 == 0);
  for (std::size_t side = 0; side < sides.count; ++side) {
    const double nx = sides.normal_x[side], ny = sides.normal_y[side], offset = sides.offset[side];
    for (std::size_t i = 0; i < places; i += 4) {
      Four px, py;
      std::memcpy(&px, x + i, sizeof(px));
      std::memcpy(&py, y + i, sizeof(py));
      const Four here = nx * px + ny * py + offset;
      std::memcpy(along + side * places + i, &here, sizeof(here));
    }
  }
}

HIDWA_VECTOR_CLONES
void least_gaps(const Sides& sides, const double* along, std::size_t places, const std::vector<SideGaps::Disc>& discs,
                double least, double* gaps) {
  for (std::size_t i = 0; i < places; i += 4) {
    Four nearest = Four{} + std::numeric_limits<double>::infinity();
    for (const SideGaps::Disc& disc : discs) {
      Four most = Four{} + least;
      for (std::size_t side = 0; side < sides.count; ++side) {
        Four own;
        std::memcpy(&own, along + side * places + i, sizeof(own));
        const Four beyond = sides.normal_x[side] * disc.x + sides.normal_y[side] * disc.y - own;
        most = most < beyond ? beyond : most;
      }
      const Four gap = most - disc.radius;
      nearest = gap < nearest ? gap : nearest;
    }
    std::memcpy(gaps + i, &nearest, sizeof(nearest));
  }
}

}  // namespace

void SideGaps::reserve(std::size_t places, std::size_t sides) {
  for (std::vector<double>* values : {&normal_x_, &normal_y_, &offset_}) values->reserve(sides);
  along_.reserve(sides * places);
}

void SideGaps::turn(const Footprint& footprint, double cosine, double sine) {
  const std::size_t count = footprint.sides().size();
  for (std::vector<double>* values : {&normal_x_, &normal_y_, &offset_}) values->resize(count);
  for (std::size_t k = 0; k < count; ++k) {
    const Footprint::Side& side = footprint.sides()[k];
    normal_x_[k] = cosine * side.normal.x() - sine * side.normal.y();
    normal_y_[k] = sine * side.normal.x() + cosine * side.normal.y();
    offset_[k] = side.offset;
  }
}

void SideGaps::measure(const std::vector<double>& x, const std::vector<double>& y, const std::vector<Disc>& discs,
                       double least, std::vector<double>& gaps) {
  const Sides sides{normal_x_.data(), normal_y_.data(), offset_.data(), offset_.size()};
  along_.resize(sides.count * x.size());
  gaps.resize(x.size());
  place_sides(sides, x.data(), y.data(), x.size(), along_.data());
  least_gaps(sides, along_.data(), x.size(), discs, least, gaps.data());
}

}  // namespace hidwa_local_planner::critics
