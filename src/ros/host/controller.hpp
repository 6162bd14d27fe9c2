// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <costmap_2d/costmap_2d_ros.h>
#include <geometry_msgs/PoseStamped.h>
#include <geometry_msgs/Twist.h>
#include <tf2_ros/buffer.h>

#include "ros/cycle_result.hpp"
#include "ros/host/cancel_request.hpp"

namespace hidwa_local_planner {

class DriveWithoutGoal;
class PlannerNode;

/// What a controller's cycle came to, in the kinds that Move Base Flex knows (mbf_msgs/ExePath).
enum class ControllerOutcome {
  success,           // the command is to be sent: driving, braking or holding
  canceled,          // as asked for: the robot rests
  no_valid_command,  // every candidate was rejected, or odometry is missing
  collision,         // the robot stands in collision and finds no way out
  missed_path,       // no pose of the path is near
  blocked_path,      // standing still is the best legal candidate, for too long
  invalid_path,
  map_error,  // the costmap is not current, or cannot be planned on
  tf_error,
  not_initialized,  // not initialized, or parameters or footprint are missing
  internal_error
};

/// Of a cycle without a request to cancel.
ControllerOutcome outcome_of(const CycleResult& result);

/// The planner as a controller that stops the robot itself, at the goal and when the host cancels: Move Base Flex does
/// not. Uses none of its types. Throws nothing. cancel() may come from any thread, the rest from the host's control
/// thread.
class Controller {
 public:
  Controller();
  ~Controller();

  /// `name`: the namespace of parameters and topics below the node's own. Both others must outlive this.
  void initialize(const std::string& name, const tf2_ros::Buffer* tf, costmap_2d::Costmap2DROS* costmap);
  /// False only before initialize(). If the plan cannot be used, the next cycle says so and brakes.
  bool set_plan(const std::vector<geometry_msgs::PoseStamped>& plan);
  /// One control cycle; send `command` where it is a success. `message` says what goes wrong or why the robot brakes;
  /// empty where it just drives.
  ControllerOutcome compute(geometry_msgs::Twist& command, std::string& message);
  /// Within `xy` [m] and `yaw` [rad], and at rest. The planner drives to these instead of its own tolerances.
  bool goal_reached(double xy, double yaw);
  /// From now on cycles brake, within the limits. Once the robot stands, a cycle answers `canceled`.
  void cancel();

 private:
  ControllerOutcome cycle(geometry_msgs::Twist& command, std::string& message);

  std::unique_ptr<PlannerNode> planner_;
  CancelRequest cancel_;
  std::unique_ptr<DriveWithoutGoal> drive_;  // goes before the planner
};

}  // namespace hidwa_local_planner
