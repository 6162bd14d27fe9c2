// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "hidwa_local_planner/core/grid_view.hpp"

namespace hidwa_local_planner {

/// The obstacle cells that the robot overlaps, and those on the obstacles' edges that are connected to them
/// (8-neighbourhood) and so near that the robot may reach them. Connected cells are one cluster.
class ObstacleClusters {
 public:
  /// A square part of a map; what lies beyond the map's edge is an obstacle.
  struct Window {
    GridView map;
    bool unknown_is_obstacle = true;
    Cell first;    // in the map
    int size = 0;  // rows and columns [cells]

    bool obstacle(Cell cell) const { return map.obstacle(cell, unknown_is_obstacle); }
  };
  struct Overlap {
    Cell cell;
    double depth = 0.0;  // of the robot in it [m]
  };
  /// How deep the robot may come into a cell [m]. In a cell that it overlaps: as deep as there, or as in a neighbour,
  /// the latter up to half a cell. In any other: no deeper than in the nearest overlapped cells, and at most half a
  /// cell.
  struct Member {
    Cell cell;
    double limit = 0.0;
    double near_limit = 0.0;  // likewise until the next cycle: of the others, neighbours of overlapped ones only
    int cluster = 0;          // number
  };

  /// All of `overlaps` must lie in the window; others are looked for up to so many `steps` away from them [cells].
  void gather(const Window& window, const std::vector<Overlap>& overlaps, int steps);

  /// In the order of their clusters.
  const std::vector<Member>& members() const { return members_; }
  /// A cell of the window.
  bool holds(Cell cell) const { return marks_[index(cell)] >= 0; }

 private:
  bool inside(Cell cell) const;
  std::size_t index(Cell cell) const;
  bool edge(Cell cell) const;
  void add(const Member& member);
  void add_overlapped(const std::vector<Overlap>& overlaps);
  void raise_overlapped(const std::vector<Overlap>& overlaps);
  void add_ring(std::size_t begin, bool first);
  void reach(Cell cell, std::size_t ring, double limit, double near_limit);
  void number_clusters();
  void spread_number(std::size_t from, int number);

  Window window_;
  double half_ = 0.0;       // of a cell's side [m]
  std::vector<int> marks_;  // of the window's cells: which member; negative: none
  std::vector<Member> members_;
  std::vector<std::size_t> open_;
};

}  // namespace hidwa_local_planner
