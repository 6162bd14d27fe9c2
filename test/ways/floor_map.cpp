// SPDX-License-Identifier: BSD-3-Clause
#include "ways/floor_map.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "ways/drawing.hpp"

namespace hidwa_ways {
namespace {

constexpr double kPart = 12.0;                // [m]
constexpr double kNarrow = 0.5, kWide = 1.2;  // of gaps [m]
constexpr double kDeep = 0.5;                 // so far on is free before and behind a gap [m]
constexpr double kFar = 1.5;                  // farther is not looked [m]
constexpr int kDirections = 8;                // across a gap, of half a turn

// How far it is free from a place [m].
double free_along(const World& map, const Spot& from, double direction) {
  const double step = 0.5 * map.resolution();
  double far = 0.0;
  for (; far < kFar; far += step) {
    const Spot at = farther(from, direction, far);
    if (map.lethal(map.cell(at.x), map.cell(at.y))) break;
  }
  return far;
}

// The narrowest passage through a place: its direction across [rad], and how far it is free to both sides [m].
struct Passage {
  double across = 0.0, left = kFar, right = kFar;
};
Passage passage_at(const World& map, const Spot& at) {
  Passage narrowest;
  for (int k = 0; k < kDirections; ++k) {
    const double across = M_PI * k / kDirections;
    const Passage here{across, free_along(map, at, across), free_along(map, at, across + M_PI)};
    if (here.left + here.right < narrowest.left + narrowest.right) narrowest = here;
  }
  return narrowest;
}

bool is_gap(const World& map, const Spot& at, const Passage& passage) {
  const double width = passage.left + passage.right;
  if (width < kNarrow || width > kWide) return false;
  return std::min(free_along(map, at, passage.across + 0.5 * M_PI), free_along(map, at, passage.across - 0.5 * M_PI)) >=
         kDeep;
}

Site part_about(const World& map, const Spot& at) {
  Site site{World(kPart, kPart, map.resolution()), {}, 1.5, true};
  const int first_i = map.cell(at.x) - site.world.columns() / 2, first_j = map.cell(at.y) - site.world.rows() / 2;
  for (int j = 0; j < site.world.rows(); ++j) {
    for (int i = 0; i < site.world.columns(); ++i)
      site.world.set(i, j, !map.has(first_i + i, first_j + j) || map.lethal(first_i + i, first_j + j));
  }
  wall_in(site.world);
  site.at = {at.x - first_i * map.resolution(), at.y - first_j * map.resolution()};
  return site;
}

}  // namespace

Site gap_of(const World& map, Random& random) {
  for (int attempt = 0; attempt < 200000; ++attempt) {
    const double x = random.in(0.0, map.width());
    const Spot at{x, random.in(0.0, map.height())};
    if (map.lethal(map.cell(at.x), map.cell(at.y))) continue;
    const Passage passage = passage_at(map, at);
    if (!is_gap(map, at, passage)) continue;
    return part_about(map, farther(at, passage.across, 0.5 * (passage.left - passage.right)));
  }
  throw std::invalid_argument("the map has no gap between 0.5 m and 1.2 m");
}

}  // namespace hidwa_ways
