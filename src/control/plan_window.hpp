// SPDX-License-Identifier: BSD-3-Clause
// The way along a plan: how much of it is driven, and which part of it matters now.
//
// Progress is an arc length that never goes back: a loop in the plan cannot pull the robot to the wrong branch. Where
// the plan is driven in its order (PlanOrder), two more rules hold:
//
// - The plan turns back where it leads out and comes near itself again: in a hairpin, a zigzag or a small loop. The
//   window ends at such a turn until the robot is there, and begins there afterwards. So distance grids and local goal,
//   which know nothing of order, hold one branch at a time. Two places are near each other if the way along the plan is
//   twice as long as the straight line between them or longer, and no obstacle lies between them: round an obstacle the
//   distance grids lead anyway. The turn is halfway. If an obstacle is there, the last free place before it counts.
// - Of several places of the plan where the robot may be, the first one counts. Who steers passes what lies before the
//   place to which the robot has been steered, if it goes on there in the plan's direction.
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "control/frame_transform.hpp"
#include "hidwa_local_planner/core/grid_view.hpp"
#include "hidwa_local_planner/core/types.hpp"

namespace hidwa_local_planner {

/// The plan with poses between those that are far apart: then it does not matter at which spacing a planner writes its
/// plans. A pose that is put in looks along the plan, and so does one whose heading is no number.
std::vector<Pose2> with_poses_between(const std::vector<Pose2>& plan);

/// Of a plan that is driven in its order.
struct PlanOrder {
  double tolerance = 0.25;  // a place counts as reached within this distance [m]
  bool steered = false;     // the operator decides where the robot goes
};

/// Where obstacles are.
struct PlanGround {
  GridView costmap;
  FrameTransform from_plan;  // of the plan's frame, in the costmap's
};

class PlanWindow {
 public:
  /// A plan to a new goal, any frame. Progress starts at the plan's pose nearest to the robot's first query; in the
  /// plan's order, at the first place that is about as near.
  void set_plan(std::vector<Pose2> plan);
  /// Another plan to the same goal, in the same frame: of such places progress starts where about as much is left.
  void replace_plan(std::vector<Pose2> plan);
  /// set_plan() with so many poses, or fewer, then takes no memory of its own.
  void reserve(std::size_t poses) { arc_.reserve(poses); }
  bool empty() const { return plan_.empty(); }
  const std::vector<Pose2>& plan() const { return plan_; }

  /// Moves the progress on to where the robot is, in the plan's frame. Without `order` the plan's order does not count.
  void advance(const Pose2& robot, const PlanOrder* order);
  /// After advance(): looks for the next turn on the first `ahead` [m] of what is left.
  void find_turn(double ahead, const PlanOrder& order, const PlanGround& ground);
  /// The robot cannot get to the turn that it is to reach: the window no longer ends there.
  void give_way() { pass_turn(); }

  /// The poses from `behind` [m] behind the progress to `ahead` [m] ahead of it, measured along the plan, and no
  /// farther than the turns on either side. Empty only when the plan is empty.
  struct Range {
    std::size_t begin = 0, end = 0;  // [begin, end) into plan()
    bool turns_back = false;         // it ends at turn(), which may lie between two poses
  };
  Range range(double behind, double ahead) const;
  /// Where the plan turns back next, of a range that does.
  Pose2 turn() const { return at(turn_); }

  /// What is left of the plan leads to its end and nowhere else: it lies within `tolerance` [m] of the end, or is too
  /// short to get out of there and back.
  bool leads_to_end(double tolerance) const;
  /// Arc length from the plan's start to the progress [m].
  double progress() const { return progress_; }
  /// The first pose from the progress on.
  std::size_t next_pose() const;
  /// What is remembered of the way; the plan is the same before and after.
  template <typename Self, typename Archive>
  static void archive(Self& self, Archive& io) {
    io(self.progress_, self.passed_, self.turn_, self.left_before_);
  }

 private:
  static constexpr double kNone = std::numeric_limits<double>::infinity();
  struct Projection {
    double arc = 0.0;         // [m]
    double distance2 = 0.0;   // from the robot [m^2]
    std::size_t segment = 0;  // of the plan: from this pose to the next one
  };
  double heading(std::size_t segment) const;  // [rad]
  Projection project(std::size_t segment, const Pose2& robot) const;
  Projection nearest(const Pose2& robot, double from, double to) const;
  template <typename Visit>
  void visit_projections(const Pose2& robot, double from, double within, Visit&& visit) const;
  double first_place(const Pose2& robot, const PlanOrder& order) const;
  void pass_by_steering(const Pose2& robot, double tolerance);
  void pass_turn();
  double middle_of_turn(std::size_t from, double round) const;
  Pose2 at(double arc) const;
  double length() const { return arc_.back(); }

  std::vector<Pose2> plan_;
  std::vector<double> arc_;    // arc length at each pose [m]
  double progress_ = -1.0;     // [m]; negative before the first query
  double passed_ = 0.0;        // arc length of the last turn that was reached [m]
  double turn_ = kNone;        // of the next one that is known [m]
  double left_before_ = -1.0;  // what was left of the plan before, to the same goal [m]; negative: there was none
};

}  // namespace hidwa_local_planner
