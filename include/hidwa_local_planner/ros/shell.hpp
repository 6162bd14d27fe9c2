// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <costmap_2d/costmap_2d_ros.h>
#include <geometry_msgs/PoseStamped.h>
#include <geometry_msgs/Twist.h>
#include <ros/node_handle.h>
#include <tf2_ros/buffer.h>

#include "hidwa_local_planner/control/control_loop.hpp"
#include "hidwa_local_planner/control/frame_watch.hpp"
#include "hidwa_local_planner/control/response_watch.hpp"
#include "hidwa_local_planner/control/sample_budget.hpp"
#include "hidwa_local_planner/record/cycle_recorder.hpp"
#include "hidwa_local_planner/ros/callback_thread.hpp"
#include "hidwa_local_planner/ros/conversions.hpp"
#include "hidwa_local_planner/ros/cycle_statistics.hpp"
#include "hidwa_local_planner/ros/diagnostics.hpp"
#include "hidwa_local_planner/ros/handover.hpp"
#include "hidwa_local_planner/ros/host/cycle_clock.hpp"
#include "hidwa_local_planner/ros/host/host_frequency.hpp"
#include "hidwa_local_planner/ros/loop_time.hpp"
#include "hidwa_local_planner/ros/message_throttle.hpp"
#include "hidwa_local_planner/ros/moving_obstacle_input.hpp"
#include "hidwa_local_planner/ros/odometry_input.hpp"
#include "hidwa_local_planner/ros/operator_commands.hpp"
#include "hidwa_local_planner/ros/operator_feedback.hpp"
#include "hidwa_local_planner/ros/operator_input.hpp"
#include "hidwa_local_planner/ros/parameter_set.hpp"
#include "hidwa_local_planner/ros/plan_message.hpp"
#include "hidwa_local_planner/ros/publishing.hpp"
#include "hidwa_local_planner/ros/reconfigure.hpp"
#include "hidwa_local_planner/ros/robot_description.hpp"

namespace hidwa_local_planner {

/// The planner among messages, clocks and parameters. A cycle gathers its inputs, runs the control loop once, and
/// publishes the decision. set_plan, cycle and goal_reached come from the host's control thread; parameters, odometry
/// and the operator's messages come from threads of their own.
class Shell {
 public:
  /// `name`: the planner's namespace below the node's. `tf` and `costmap` must outlive the shell.
  Shell(const std::string& name, const tf2_ros::Buffer& tf, costmap_2d::Costmap2DROS& costmap);
  ~Shell();

  void set_plan(const std::vector<geometry_msgs::PoseStamped>& plan);
  /// One control cycle. Outcome::fail: nothing to send, the host is to stop, replan or recover. The decision
  /// stays valid until the next cycle. With `stop` the robot brakes to rest and stays, whatever the operator command
  /// is.
  CycleResult cycle(bool stop = false);
  /// True when the goal is reached. A host that does not stop the robot then (`host_stops` false) hears it only
  /// when cycles have brought it to rest.
  bool goal_reached(bool host_stops = true);
  /// Where the goal is reached, instead of what the parameters say [m], [rad]. Brought into the parameters' ranges.
  void set_goal_tolerances(double xy, double yaw);
  /// The last command asked for rest, and the robot is at rest.
  bool stands() const { return loop_.stands(); }
  OperatorInput::Status operator_status() const;
  double period() const { return control_period(); }  // nominal, of a control cycle [s]

 private:
  /// What is known of the robot, and the kind of what is missing.
  struct Observation : control::Observation {
    Missing missing = Missing::nothing;
  };

  // Parameters.
  void start_parameters();
  void report_start(const std::vector<std::string>& found) const;
  std::vector<std::string> judge(const Parameters& wanted);
  std::string listen(const Parameters& parameters);  // to their topics; the fault in words where that cannot be
  void take_parameters();
  std::vector<std::string> put_in_force(const ParameterSet& set);
  double control_period() const;  // [s]
  Diagnostics::Load load() const;

  // One cycle.
  void watch_hand(const LoopTime& now);
  CycleClock::Tick watch_time(double now);
  CycleResult work(const LoopTime& now, const CycleClock::Tick& tick, bool host_stops);
  control::Timing timing(double now, const CycleClock::Tick& tick) const;
  Observation observe(const LoopTime& now, const control::Timing& timing);
  std::string observe_pose(const LoopTime& now, const control::Timing& timing, Observation& observation);
  double pose_ahead_of(const LoopTime& now, const ros::Time& stamp) const;
  std::string update_footprint();
  Twist2 velocity_after_pause(double now) const;
  Sampling sampling() const;
  void watch_odometry(const Observation& observation, const Decision& decision);
  void watch_sender();
  void explain(double now, const CycleResult& result);
  void keep_budget(double duration, double period, const CycleResult& result);
  void check_horizon();

  const std::string name_;
  ros::NodeHandle host_handle_;  // topics by the host's names
  ros::NodeHandle handle_;       // the planner's namespace
  const tf2_ros::Buffer& tf_;
  costmap_2d::Costmap2DROS& costmap_;

  RobotDescription description_;
  CriticRegistry registry_;
  std::string plan_fault_ = "no plan was given yet";  // empty when there is a plan to follow
  record::CycleRecorder recorder_;
  bool recorded_ = false;  // this cycle is
  CycleClock clock_;
  std::chrono::steady_clock::time_point called_;  // the newest call; long ago before the first one
  double silence_ = 0.0;                          // before that call [s]
  std::uint64_t doubted_ = 0;                     // readings of odometry
  ResponseWatch response_;
  CycleStatistics statistics_;
  SampleBudget budget_;
  bool arriving_ = false;  // at the goal, and not at rest yet
  ParameterSet in_force_;  // without the host's tolerances
  struct Tolerances {
    double xy = 0.0, yaw = 0.0;  // [m], [rad]
  };
  std::optional<Tolerances> host_tolerances_;
  std::string parameters_fault_;  // why the parameters at start cannot drive; empty once a valid set came
  MessageThrottle explanations_;
  std::vector<std::string> horizon_said_;

  Handover<ParameterSet> pending_;  // accepted, in force from the next cycle on

  // Threads outlive whatever they serve. Odometry has its own: a reconfigure call may wait for the parameter
  // server or load a library.
  CallbackThread thread_;
  CallbackThread odometry_thread_;
  HostFrequency host_frequency_;
  OdometryInput odometry_;
  MovingObstacleInput moving_obstacles_;
  OperatorInput person_;
  control::ControlLoop loop_;
  control::FrameWatch frame_watch_;
  std::string odom_topic_;     // listened to
  std::string odometry_said_;  // what is odd about it
  bool doubted_velocity_ = false;
  std::chrono::steady_clock::time_point sender_watched_;
  std::string moving_obstacles_topic_;
  Parameters accepted_;             // the last valid set, in force or about to be
  control::Prediction prediction_;  // of the last cycle, where somebody watched
  bool watched_ = false;
  Publishing publishing_;
  OperatorFeedback feedback_;
  std::unique_ptr<Reconfigure> reconfigure_;
  std::unique_ptr<OperatorCommands> commands_;
  std::unique_ptr<Diagnostics> diagnostics_;
};

/// Every plugin calls this when its host initializes it. Makes the shell, once; logs what is missing.
void start_shell(std::unique_ptr<Shell>& shell, const std::string& name, const tf2_ros::Buffer* tf,
                 costmap_2d::Costmap2DROS* costmap);

}  // namespace hidwa_local_planner
