// SPDX-License-Identifier: BSD-3-Clause
#include "drive/people_sight.hpp"

#include <cmath>
#include <cstddef>
#include <set>
#include <utility>

namespace hidwa_local_planner {
namespace drive {

void PeopleSight::add(std::uint32_t id, const Point& in_map, const Point& in_costmap) {
  const int column = map_.column(in_map.x()), row = map_.row(in_map.y());
  for (int j = row - 1; j <= row + 1; ++j) {
    for (int i = column - 1; i <= column + 1; ++i) {
      if (map_.occupied(i, j)) return;
    }
  }
  points_[id].push_back(in_costmap);
}

void PeopleSight::keep_marked(const GridView& costmap) {
  for (auto& [id, points] : points_) {
    std::set<std::pair<int, int>> cells;
    std::size_t kept = 0;
    for (const Point& point : points) {
      const Cell cell = costmap.cell_at(point.x(), point.y());
      const bool marked = costmap.contains(cell) && costmap.at(cell) == cost::kLethal;
      if (marked && cells.emplace(cell.i, cell.j).second) points[kept++] = point;
    }
    points.resize(kept);
  }
}

MovingObstacleEstimates PeopleSight::truth(const std::vector<sim::Mover>& movers,
                                           const sim::Pose& map_in_costmap) const {
  MovingObstacleEstimates obstacles;
  const double c = std::cos(map_in_costmap.theta), s = std::sin(map_in_costmap.theta);
  const auto turned = [c, s](const Eigen::Vector2d& v) { return Point(c * v.x() - s * v.y(), s * v.x() + c * v.y()); };
  for (const sim::Mover& mover : movers) {
    MovingObstacleEstimate obstacle;
    obstacle.id = mover.id;
    obstacle.position = Point(map_in_costmap.x, map_in_costmap.y) + turned(mover.position);
    obstacle.velocity = turned(mover.velocity);
    obstacle.radius = mover.radius;
    const auto seen = points_.find(mover.id);
    if (seen != points_.end()) obstacle.points = seen->second;
    obstacles.push_back(std::move(obstacle));
  }
  return obstacles;
}

}  // namespace drive
}  // namespace hidwa_local_planner
