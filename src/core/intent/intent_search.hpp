// SPDX-License-Identifier: BSD-3-Clause
// Finds the motion that does what an operator without a goal means, where their own one would meet an obstacle.
//
// 1. The operator's own motion, kept, is a straight line or an arc. If it stays free for the look-ahead distance,
//    nothing else is looked for.
// 2. Else a path is searched for (A* over poses): it consists of short arcs, and its heading stays within 31.5 degrees
//    of the operator's direction at each place. It costs its length; more where it leads off that direction, bends, or
//    has little clearance; and the progress that is left. Progress is counted along the operator's direction.
// 3. The path counts if it leads clearly farther than the operator's own motion, or has more clearance. The robot
//    then aims at a point of it some tenths of a metre ahead (pure pursuit, Coulter 1992).
// 4. Else the operator's own motion stays, and the robot stops where that ends.
//
// Why it is safe: nothing here makes a command legal. The result is what candidates are compared with.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/collision/collision.hpp"
#include "core/cycle/cycle.hpp"
#include "core/search/bin_table.hpp"
#include "core/util/rotation.hpp"

namespace hidwa_local_planner {

class IntentSearch {
 public:
  struct Request {
    Pose2 start;       // where the robot is when a command takes effect, costmap frame
    double off = 0.0;  // its heading, less the operator's direction [rad]
    Twist2 wanted;     // the operator command, within the limits [m/s, rad/s]
    int side = 0;      // of the path before: 1 left of the operator's own motion, -1 right, 0 where there was none
  };
  struct Result {
    Twist2 motion;  // [m/s, rad/s]
    int side = 0;   // of its path; 0 for the operator's own motion
  };

  IntentSearch();
  Result run(const Cycle& cycle, const Request& request);

 private:
  struct Node {
    Pose2 pose;
    double off = 0.0;        // its heading, less the operator's direction there [rad]
    double progress = 0.0;   // along the operator's direction [m]
    double cost = 0.0;       // [m]
    double clearance = 0.0;  // [m]
    double bend = 0.0;       // curvature beyond the operator's own [1/m]
    std::int32_t parent = -1;
    int side = 0;
  };
  struct Arc {
    double length = 0.0;     // positive [m]
    double curvature = 0.0;  // of the heading per length [1/m]
  };

  void prepare(const Cycle& cycle, const Request& request);
  double clearance_at(const Pose2& pose) const;
  Pose2 after(const Pose2& from, const Arc& arc) const;
  double go_along(const Arc& arc, Node& node) const;
  double bend_home(double off) const;
  Node own_motion(const Node& start) const;
  int search(const Node& start, int side);
  void leave(std::uint32_t from, int side);
  void turn_first(const Node& start, int side);
  void push(const Node& node);
  std::uint64_t bin_of(const Node& node) const;
  Result aim(int last, const Request& request) const;

  CollisionChecker checker_;
  const Cycle* cycle_ = nullptr;  // during run()
  double forward_ = 1.0;          // -1: the operator drives backwards
  double curvature_ = 0.0;        // of the operator's own motion [1/m]
  double ahead_ = 0.0;            // the look-ahead distance [m]
  double comfort_ = 0.0;          // less clearance costs [m]
  double counted_ = 0.0;          // the largest clearance that is told [m]
  double gentle_ = 0.0;           // a gentle bend beyond the operator's own [1/m]
  double sharpest_ = 0.0;         // the sharpest one [1/m]
  double needed_ = 0.0;           // the least clearance of an arc [m]
  Pose2 origin_;                  // of the bins
  std::vector<Node> nodes_;
  std::vector<std::pair<double, std::uint32_t>> queue_;  // negative bound of the cost [m], node
  BinTable bins_;
};

}  // namespace hidwa_local_planner
