// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "core/collision/collision.hpp"
#include "core/distance/distance_grid.hpp"
#include "core/search/search_task.hpp"

namespace hidwa_local_planner {

/// How far it is to the target of a search for the robot's centre, round what it hits at any heading (DistanceGrids,
/// geodesic): at most 8 % more than the shortest way of a disc, so nearly a lower bound of any way.
class TargetDistance {
 public:
  TargetDistance() = default;
  TargetDistance(const TargetDistance&) = delete;
  TargetDistance& operator=(const TargetDistance&) = delete;

  /// `task` and `checker`, prepared with its map, must outlive the questions.
  void prepare(const SearchTask& task, const CollisionChecker& checker);
  /// [m]; zero near the target, negative where there is no way, and off the map.
  double at(double x, double y);

 private:
  void block(const CollisionChecker& checker);
  void find_sources();

  const SearchTask* task_ = nullptr;
  std::vector<std::uint8_t> blocked_;  // costs: lethal where the robot's centre cannot be
  GridView grid_;
  std::vector<Cell> sources_;
  DistanceGrids distances_;
};

}  // namespace hidwa_local_planner
