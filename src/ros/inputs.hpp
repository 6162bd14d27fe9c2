// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>

#include <costmap_2d/costmap_2d_ros.h>
#include <tf2_ros/buffer.h>

#include "control/control_loop.hpp"
#include "control/frame_watch.hpp"
#include "control/response_watch.hpp"
#include "ros/callback_thread.hpp"
#include "ros/cycle_result.hpp"
#include "ros/loop_time.hpp"
#include "ros/moving_obstacle_input.hpp"
#include "ros/odometry_input.hpp"

namespace hidwa_local_planner {

/// What is known of the robot, and the kind of what is missing.
struct RobotObservation : control::Observation {
  Missing missing = Missing::nothing;
  /// Notes a fault, unless it is empty. Whether something is missing.
  bool lacks(Missing what, std::string why) {
    if (!why.empty()) missing = what;
    fault = std::move(why);
    return missing != Missing::nothing;
  }
};

/// What is observed: odometry and moving obstacles as messages, with a thread of their own, the robot's pose and the
/// plan's frame by tf, and the local costmap. Says in the log what is odd about the odometry. listen() comes from the
/// thread that changes parameters, everything else from the host's control thread.
class Inputs {
 public:
  /// `name`: of the planner. `tf` and `costmap` must outlive it.
  Inputs(const std::string& name, const tf2_ros::Buffer& tf, costmap_2d::Costmap2DROS& costmap);
  ~Inputs();

  /// Subscribes to the topics of these parameters. Throws what roscpp throws.
  void listen(const Parameters& parameters);
  /// Time jumped back: messages from before no longer count.
  void forget();

  /// Reads the velocity and, where nothing is missing already, the pose and the plan's frame; notes what is missing.
  void observe(const LoopTime& now, const std::string& plan_frame, const Parameters& parameters,
               RobotObservation& observation);
  /// Reads what moves, in the costmap's frame, and what the sensors look at that find it.
  void observe_moving_obstacles(double now, const Parameters& parameters, RobotObservation& observation);
  /// The robot's velocity after a pause, in which the host or another node may have sent commands [m/s, rad/s].
  Twist2 velocity_after_pause(double now, const Planner& planner) const;

  /// Compares the odometry with what a cycle came to.
  void watch(const control::Observation& observation, const control::Result& result);
  /// Looks once a second at who sends the odometry, and at once where the loop begins or ceases to doubt the velocity.
  void watch_sender(const control::ControlLoop& loop);
  const std::string& odometry_advice() const { return said_; }  // by watch_sender(); empty where nothing is odd
  std::uint64_t doubted_readings() const { return doubted_; }   // that no command explains
  std::optional<double> base_latency() const { return response_.latency(); }  // [s]
  const MovingObstacleInput& moving_obstacles() const { return moving_obstacles_; }

 private:
  std::string observe_pose(const LoopTime& now, const Parameters& parameters, RobotObservation& observation);
  std::string observe_plan_frame(const LoopTime& now, const std::string& plan_frame, const Parameters& parameters,
                                 RobotObservation& observation) const;
  double pose_ahead_of(const LoopTime& now, const ros::Time& stamp) const;

  const std::string name_;
  const tf2_ros::Buffer& tf_;
  costmap_2d::Costmap2DROS& costmap_;
  // A call of dynamic_reconfigure may wait for the parameter server or load a library: odometry waits for none.
  CallbackThread thread_;
  OdometryInput odometry_;
  MovingObstacleInput moving_obstacles_;
  std::string odom_topic_, moving_obstacles_topic_;  // listened to
  control::FrameWatch frame_watch_;
  ResponseWatch response_;
  std::uint64_t doubted_ = 0;
  bool doubts_ = false;  // the velocity, when watch_sender() looked last
  std::chrono::steady_clock::time_point looked_;
  std::string said_;
};

}  // namespace hidwa_local_planner
