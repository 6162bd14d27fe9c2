// SPDX-License-Identifier: BSD-3-Clause
// Where a cycle starts: the first of the planner's steps.
//
// 1. The last command is added to the history of commands that odometry may still show (CommandHistory).
// 2. The history gives the pending motion: what the robot does until this cycle's command takes effect.
// 3. Each axis of odometry is judged against the history (AxisBelief). It gives the reference velocity and the velocity
//    that is believed. Where odometry says something else than the commands, the robot may do either: both become
//    pending motions. While something holds the robot it may not be commanded faster than what could have started from
//    its velocity.
// 4. A base may react sooner than after control_latency: motions with a shorter latency are added as unlikely ones.
// 5. A pose that is some time old is led on to now, along the pending motion.
//
// Why it is right: a command starts from the last one, so that commands change no faster than the limits allow whatever
// odometry says. Where that is slower for good, commands fall to it at the braking limit. The braking check takes every
// motion of the set into account, so it holds whichever the robot does.
#pragma once

#include "core/collision/blind_motion.hpp"
#include "core/motion/command_history.hpp"
#include "core/motion/cycle_start.hpp"
#include "core/motion/odometry_belief.hpp"
#include "core/motion/pending_motion_set.hpp"
#include "hidwa_local_planner/core/parameters.hpp"
#include "hidwa_local_planner/core/situation.hpp"

namespace hidwa_local_planner {

class StartEstimator {
 public:
  /// Once per cycle. `blind` is prepared and narrows the limits of this cycle's commands. `radius` [m] reaches from the
  /// robot's centre to its farthest point. The result stays valid until the next call.
  const CycleStart& estimate(const Situation& measured, const Parameters& parameters, const VelocityLimits& limits,
                             const BlindMotion& blind, double radius);
  /// A cycle in which the host decides: see Planner::skip().
  void skip(const Situation& measured, const VelocityLimits& limits);
  /// See Planner::believed() [m/s, rad/s].
  Twist2 believed(const Twist2& measured, const Parameters& parameters) const;

  template <typename Self, typename Archive>
  static void archive(Self& self, Archive& io) {
    io(self.commands_, self.odometry_);
  }

 private:
  struct Axis {
    double Twist2::*member;
    AxisLimits& limits;
    AxisBelief& belief;
  };
  void remember_command(const Situation& measured, const VelocityLimits& limits, double span);
  void judge_axis(const Axis& axis, const Situation& measured, const Parameters& parameters);
  void add_alternative(double Twist2::*axis, double velocity, bool likeliest);
  void add_prompt_motions(double age, double latency, const VelocityLimits& limits);
  Pose2 pose_of_now(double age, const VelocityLimits& limits, double radius) const;

  CommandHistory commands_;
  OdometryBelief odometry_;
  PendingMotionSet pending_;
  std::size_t likeliest_ = 0;  // of the pending motions
  CycleStart start_;
};

}  // namespace hidwa_local_planner
