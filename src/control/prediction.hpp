// SPDX-License-Identifier: BSD-3-Clause
// Where autonomy will be in the next seconds if nobody steers, and what it is about to do: for those who watch. Nothing
// is decided by it.
//
// The robot first drives what the cycle has chosen, where autonomy chose it. From there it follows the plan as cycles
// do on average: it turns towards a point of the plan ahead of it (pure pursuit, Coulter 1992, CMU-RI-TR-92-01), within
// the limits, slows down for bends, and comes to rest at the goal or before an obstacle on the plan.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "control/control_loop.hpp"
#include "hidwa_local_planner/core/types.hpp"

namespace hidwa_local_planner::control {

/// What autonomy is about to do.
enum class NextMove { straight = 0, left, right, stop, recover };
const char* to_string(NextMove move);

struct TimedPose {
  Pose2 pose;         // costmap frame
  double time = 0.0;  // since the cycle [s]
};

class Prediction {
 public:
  static constexpr double kHorizon = 3.0;  // [s]
  static constexpr double kStep = 0.1;     // [s], from pose to pose

  /// Of the cycle that `loop` has just done.
  void update(const ControlLoop& loop, const Observation& observation, const Result& result);

  /// From the robot's pose on, up to kHorizon. Empty where an input is missing.
  const std::vector<TimedPose>& poses() const { return poses_; }
  NextMove next() const { return next_; }
  /// Why, in words; empty where autonomy just follows its plan.
  const std::string& reason() const { return reason_; }

 private:
  struct Robot {
    Pose2 pose;  // costmap frame
    Twist2 velocity;
    double time = 0.0;  // [s]
  };
  void lay_out(const ControlLoop& loop, const Observation& observation);
  void find_end(const Observation& observation, double inscribed_radius);
  void roll_out(const ControlLoop& loop, const Observation& observation, const Result& result);
  void follow_choice(const Decision& decision, double period, Robot& robot);
  Twist2 turn_to_goal(const Robot& robot, const ControlLoop& loop) const;
  Twist2 pursue(const Robot& robot, const Parameters& parameters);
  void name_next(const ControlLoop& loop, const Result& result);

  std::vector<TimedPose> poses_;
  std::vector<Point> ahead_;  // the plan from the robot on, costmap frame
  std::vector<double> arc_;   // arc length at each of these points [m]
  std::size_t at_ = 0;        // the point that the predicted robot has come to
  double braking_ = 0.0;      // [m/s^2]
  double end_ = 0.0;          // arc length where it comes to rest [m]
  bool blocked_ = false;      // an obstacle is there; else the goal
  bool rests_ = false;        // it comes to rest within the horizon
  NextMove next_ = NextMove::stop;
  std::string reason_;
};

}  // namespace hidwa_local_planner::control
