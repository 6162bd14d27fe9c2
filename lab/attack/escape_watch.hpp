// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <deque>
#include <vector>

#include "spec.hpp"
#include "world.hpp"

namespace hidwa_attack {

/// Watches a robot that stands in obstacle cells. It may enter a cell only where that is a neighbour of one that it
/// overlapped when what it does now was decided, no deeper than it stood in then and at most half a cell; its total
/// depth never grows: the depth in the deepest cell of each cluster, cells that hang together, summed over the clusters
/// (along a wall the number of cells under the robot comes and goes, the depth in the wall does not); and it is no
/// faster than what stops within half a cell. A base that takes each command and axis at either end may go deeper by
/// what docs/understand/safety.md allows it.
class EscapeWatch {
 public:
  EscapeWatch(const World& world, const Shape& padded_shape, const Spec& spec);

  /// A control cycle at this pose.
  void decide(int now, const Pose2& pose, const Twist2& velocity);
  /// Each millisecond.
  void observe(int now, const Pose2& pose, const Twist2& velocity);
  /// Cells were added to the world: until the robot can have come to rest nothing is judged.
  void world_changed(int now);

  int entered() const { return entered_; }                 // cells that it must not enter
  double entered_depth() const { return entered_depth_; }  // [m]
  double neighbour_excess() const { return excess_; }      // deeper in a neighbour than allowed, by so much [m]
  double growth() const { return growth_; }                // of the total depth [m]
  double fastest() const { return fastest_; }              // |v| while it stands in collision [m/s]
  double speed_bound() const { return bound_; }            // [m/s]
  bool out() const { return now_in_.empty(); }
  bool broken() const;

 private:
  struct In {
    int i = 0, j = 0;
    double depth = 0.0;  // [m]
    bool forbidden = false;
  };
  using Set = std::vector<In>;
  struct Decided {
    int time = 0;  // [ms]
    Set set;
    double deepest = 0.0;  // [m]
  };
  Set overlapped(const Pose2& pose) const;
  bool judging(int now) const { return now >= judged_from_; }
  void judge_cells(Set& now_in);
  void judge_total(const Set& now_in);
  void find_clusters();
  bool may_neighbour(const In& cell) const;
  bool was_in(const In& cell) const;

  const World& world_;
  std::vector<int> cluster_;  // of each cell of the world
  Shape shape_;
  double outermost_, half_cell_, bound_;  // [m], [m], [m/s]
  double allowed_;                        // deeper than the rules say [m]
  int memory_, settling_;                 // [ms]
  int judged_from_ = 0;                   // [ms]
  int in_since_ = -1;                     // [ms]; -1: it is out
  double moved_ = 0.0, floor_ = 1e9;      // [m]
  std::deque<Decided> decided_;
  Set now_in_;
  int entered_ = 0;
  double entered_depth_ = 0.0, excess_ = 0.0, growth_ = 0.0, fastest_ = 0.0;
};

}  // namespace hidwa_attack
