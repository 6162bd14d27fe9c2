// SPDX-License-Identifier: BSD-3-Clause
#include "sim/floor_ways.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

#include "sim/random.hpp"

namespace hidwa_local_planner {
namespace sim {
namespace {

constexpr double kCoarse = 0.15;  // [m], side of the cells on which people's ways are planned

// Cells of about kCoarse, occupied where any of theirs is: ways on it are found some ten times as fast.
OccupancyMap coarsened(const OccupancyMap& map) {
  const int k = std::max(1, static_cast<int>(std::lround(kCoarse / map.resolution)));
  OccupancyMap coarse =
      make_map((map.width + k - 1) / k, (map.height + k - 1) / k, k * map.resolution, map.origin_x, map.origin_y);
  for (int row = 0; row < map.height; ++row) {
    for (int column = 0; column < map.width; ++column) {
      Cell& cell = coarse.cells[coarse.index(column / k, row / k)];
      const Cell fine = map.cells[map.index(column, row)];
      if (fine == Cell::kOccupied || (fine == Cell::kUnknown && cell == Cell::kFree)) cell = fine;
    }
  }
  return coarse;
}

RouteClearance people_clearance(double clearance) {
  RouteClearance of_people;
  of_people.robot_radius = clearance;
  return of_people;
}

double distance_to_way(const Eigen::Vector2d& point, const Route& way) {
  double least = std::numeric_limits<double>::infinity();
  for (const Eigen::Vector2d& p : way) least = std::min(least, (p - point).norm());
  return least;
}

}  // namespace

FloorWays::FloorWays(const OccupancyMap& map, std::vector<Eigen::Vector2d> places, double clearance)
    : step_(map.resolution), walls_(DistanceField::to_obstacles(map)), places_(std::move(places)) {
  if (places_.size() < 2) throw std::invalid_argument("people need two places or more to walk between");
  const OccupancyMap coarse = coarsened(map);
  ways_.reserve(places_.size());
  for (const Eigen::Vector2d& place : places_) ways_.emplace_back(coarse, people_clearance(clearance), place);
  for (std::size_t k = 1; k < places_.size(); ++k) {
    if (way(places_.front(), k).empty()) {
      throw std::invalid_argument("no way leads to the place (" + std::to_string(places_[k].x()) + ", " +
                                  std::to_string(places_[k].y()) + "): choose another");
    }
  }
}

Eigen::Vector2d FloorWays::away_from_wall(const Eigen::Vector2d& point) const {
  const Eigen::Vector2d x(step_, 0.0), y(0.0, step_);
  const Eigen::Vector2d slope(wall_distance(point + x) - wall_distance(point - x),
                              wall_distance(point + y) - wall_distance(point - y));
  const double norm = slope.norm();
  return norm > 0.0 ? Eigen::Vector2d(slope / norm) : Eigen::Vector2d(0.0, 0.0);
}

std::vector<Eigen::Vector2d> choose_places(const OccupancyMap& map, const Eigen::Vector2d& start,
                                           const Route& robot_way, std::size_t count, double clearance,
                                           std::uint64_t seed) {
  const OccupancyMap coarse = coarsened(map);
  const GridRoute reachable(coarse, people_clearance(clearance), start);
  const DistanceField walls = DistanceField::to_obstacles(coarse);
  Random random(seed);
  std::vector<Eigen::Vector2d> places;
  constexpr int kTries = 200000;
  for (int tries = 0; places.size() < count && tries < kTries; ++tries) {
    // What a seed means hangs on the order of the draws.
    const double up = random.uniform() * map.height * map.resolution,
                 right = random.uniform() * map.width * map.resolution;
    const Eigen::Vector2d point(map.origin_x + right, map.origin_y + up);
    const int column = coarse.column(point.x()), row = coarse.row(point.y());
    if (!coarse.inside(column, row) || coarse.cells[coarse.index(column, row)] != Cell::kFree) continue;
    if (walls.at_cell(column, row) < clearance) continue;
    const bool beside = places.size() % 2 == 0 && !robot_way.empty();
    if (beside && distance_to_way(point, robot_way) > kBeside) continue;
    if (!reachable.from(point).empty()) places.push_back(point);
  }
  return places;
}

}  // namespace sim
}  // namespace hidwa_local_planner
