// SPDX-License-Identifier: BSD-3-Clause
#include "critics/side_gaps.hpp"

#include <cstring>
#include <limits>

#include "hidwa_local_planner/core/util/vector_clones.hpp"

namespace hidwa_local_planner::critics {
namespace {

struct Discs {
  const double* points;  // [discs * sides]
  const double* radii;   // [discs]
  std::size_t count, sides;
};

HIDWA_VECTOR_CLONES
void least_gaps(const Discs& discs, const double* along, std::size_t places, double least, double* gaps) {
  static_assert(SideGaps::kPad % 4 == 0);
  for (std::size_t i = 0; i < places; i += 4) {
    Four nearest = Four{} + std::numeric_limits<double>::infinity();
    const double* point = discs.points;
    for (std::size_t disc = 0; disc < discs.count; ++disc) {
      Four most = Four{} + least;
      for (std::size_t side = 0; side < discs.sides; ++side) {
        Four own;
        std::memcpy(&own, along + side * places + i, sizeof(own));
        const Four beyond = *point++ - own;
        most = most < beyond ? beyond : most;
      }
      const Four gap = most - discs.radii[disc];
      nearest = gap < nearest ? gap : nearest;
    }
    std::memcpy(gaps + i, &nearest, sizeof(nearest));
  }
}

}  // namespace

void SideGaps::reserve(std::size_t places, std::size_t sides, std::size_t discs) {
  normals_.reserve(sides);
  along_.reserve(sides * places);
  points_.reserve(sides * discs);
  radii_.reserve(discs);
}

void SideGaps::place(const Footprint& footprint, double cosine, double sine, const std::vector<double>& x,
                     const std::vector<double>& y) {
  places_ = x.size();
  normals_.clear();
  points_.clear();
  radii_.clear();
  along_.resize(footprint.sides().size() * places_);
  double* along = along_.data();
  for (const Footprint::Side& side : footprint.sides()) {
    const Normal normal{cosine * side.normal.x() - sine * side.normal.y(),
                        sine * side.normal.x() + cosine * side.normal.y()};
    normals_.push_back(normal);
    for (std::size_t i = 0; i < places_; ++i) *along++ = normal.x * x[i] + normal.y * y[i] + side.offset;
  }
}

void SideGaps::add(const Point& centre, double radius) {
  for (const Normal& normal : normals_) points_.push_back(normal.x * centre.x() + normal.y * centre.y());
  radii_.push_back(radius);
}

void SideGaps::measure(double least, std::vector<double>& gaps) const {
  gaps.resize(places_);
  least_gaps({points_.data(), radii_.data(), radii_.size(), normals_.size()}, along_.data(), places_, least,
             gaps.data());
}

}  // namespace hidwa_local_planner::critics
