// SPDX-License-Identifier: BSD-3-Clause
// What a global planner gives: Dijkstra's cheapest way over inflated costs, for a point. It knows the inscribed radius
// by the cost 253 and nothing else of the outline, as navfn does. It stands for navfn and shares nothing with it.
#pragma once

#include <cstdint>
#include <vector>

#include "hidwa_local_planner/core/grid_view.hpp"
#include "ways/body.hpp"

namespace hidwa_ways {

class GridPlan {
 public:
  /// Ways from everywhere to the root, over costs that need not outlive this.
  GridPlan(const hidwa_local_planner::GridView& costs, const Spot& root);
  bool reaches(const Spot& from) const;
  double length(const Spot& from) const;  // along the cells [m]
  /// From a place to the root, smoothed as a running mean; headings along it.
  std::vector<Pose2> from(const Spot& start) const;

 private:
  struct Neighbour {
    int di = 0, dj = 0;
    double cells = 0.0;  // how far
  };
  std::vector<Spot> cells_from(const Spot& start) const;
  int index_of(const Spot& spot) const;
  void flood(const std::vector<std::uint8_t>& costs, int root);

  int columns_, rows_;
  double resolution_, origin_x_, origin_y_;  // [m]
  std::vector<float> cost_, length_;         // to the root: of driving, and [m]
  std::vector<std::int32_t> next_;           // the cell on the way to the root; -1: none
};

}  // namespace hidwa_ways
