// SPDX-License-Identifier: BSD-3-Clause
#include "drive/ground.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "sim/contact.hpp"
#include "sim/laser.hpp"

namespace hidwa_local_planner {
namespace drive {
namespace {

std::shared_ptr<const sim::OccupancyMap> required(std::shared_ptr<const sim::OccupancyMap> map) {
  if (!map || map->cells.empty()) throw std::invalid_argument("a drive needs a map");
  return map;
}

double distance_to_box(const Eigen::Vector2d& p, const Eigen::Vector2d& low, double size) {
  const Eigen::Vector2d high = low + Eigen::Vector2d(size, size);
  return (p - p.cwiseMax(low).cwiseMin(high)).norm();
}

// Between a polygon and a square that do not overlap: from a corner of the one to a side of the other.
double gap(const sim::Polygon& polygon, const Eigen::Vector2d& low, double size) {
  const Eigen::Vector2d corners[] = {
      low, {low.x() + size, low.y()}, {low.x(), low.y() + size}, {low.x() + size, low.y() + size}};
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    least = std::min(least, distance_to_box(polygon[i], low, size));
    for (const Eigen::Vector2d& corner : corners) {
      least = std::min(least, sim::distance_to_segment(corner, polygon[j], polygon[i]));
    }
  }
  return least;
}

}  // namespace

Ground::Ground(std::shared_ptr<const sim::OccupancyMap> map, std::shared_ptr<const sim::DiscField> discs)
    : map_(required(std::move(map))), discs_(std::move(discs)), distance_(sim::DistanceField::to_obstacles(*map_)) {}

double Ground::range(double x, double y, double angle, double range_max) const {
  const double to_disc = discs_ ? discs_->range(x, y, angle, range_max) : std::numeric_limits<double>::infinity();
  return std::min(to_disc, sim::range_in(*map_, x, y, angle, std::min(to_disc, range_max), &distance_));
}

double Ground::clearance(const sim::Polygon& outline, const sim::Pose& pose, double at_most) const {
  const double to_map = clearance_of_map(outline, pose, at_most);
  return discs_ ? discs_->gap(sim::transformed(outline, pose), to_map) : to_map;
}

double Ground::clearance_of_map(const sim::Polygon& outline, const sim::Pose& pose, double at_most) const {
  const double size = map_->resolution;
  // The field measures between the centres of cells: up to half a diagonal at either end.
  const double surely = distance_.at(pose.x, pose.y) - sim::circumscribed_radius(outline) - std::sqrt(2.0) * size;
  if (surely >= at_most) return at_most;
  const sim::Polygon placed = sim::transformed(outline, pose);
  if (sim::overlaps_occupied(*map_, placed)) return 0.0;
  const sim::Box box = sim::bounds(placed);
  double least = at_most;
  const int last_row = std::min(map_->row(box.high.y() + at_most), map_->height - 1);
  const int last_column = std::min(map_->column(box.high.x() + at_most), map_->width - 1);
  for (int row = std::max(map_->row(box.low.y() - at_most), 0); row <= last_row; ++row) {
    for (int column = std::max(map_->column(box.low.x() - at_most), 0); column <= last_column; ++column) {
      if (map_->cells[map_->index(column, row)] != sim::Cell::kOccupied) continue;
      least = std::min(least, gap(placed, {map_->origin_x + column * size, map_->origin_y + row * size}, size));
    }
  }
  return least;
}

sim::RouteClearance navfn_clearance(double inscribed_radius, double cost_scaling_factor) {
  constexpr double kNeutralCost = 50.0, kCostFactor = 0.8, kHighestCost = 252.0;
  return {inscribed_radius, cost_scaling_factor, kCostFactor * kHighestCost / kNeutralCost};
}

}  // namespace drive
}  // namespace hidwa_local_planner
