// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include <costmap_2d/costmap_2d_ros.h>
#include <geometry_msgs/PoseStamped.h>
#include <tf2_ros/buffer.h>

#include "control/control_loop.hpp"
#include "control/sample_budget.hpp"
#include "record/cycle_recorder.hpp"
#include "ros/callback_thread.hpp"
#include "ros/host/host_calls.hpp"
#include "ros/inputs.hpp"
#include "ros/operator_input.hpp"
#include "ros/outputs.hpp"
#include "ros/parameter_updates.hpp"

namespace hidwa_local_planner {

/// The planner in a ROS node: among messages, clocks and parameters. A cycle observes the robot, runs the control loop
/// once, and tells of the decision. The public functions come from the host's control thread, or while it has no goal
/// from the thread that serves its callbacks: each locks the costmap first, as hosts do, and then the planner.
/// Parameters, odometry and the operator's messages come from threads of their own.
class PlannerNode {
 public:
  /// `name`: the planner's namespace below the node's. `tf` and `costmap` must outlive it.
  PlannerNode(const std::string& name, const tf2_ros::Buffer& tf, costmap_2d::Costmap2DROS& costmap);
  ~PlannerNode();

  void set_plan(const std::vector<geometry_msgs::PoseStamped>& plan);
  /// One control cycle. Outcome::fail: nothing to send, the host is to stop, replan or recover. The decision
  /// stays valid until the next cycle. With `stop` the robot brakes to rest and stays, whatever the operator command
  /// is.
  CycleResult cycle(bool stop = false);
  /// One control cycle while the host has no goal: the operator drives, or the robot brakes to rest; with `stop` it
  /// does in any case.
  CycleResult cycle_without_goal(bool stop);
  /// The newest parameters, which may come into force with the next cycle. From any thread.
  std::shared_ptr<const ParameterSet> newest_parameters() const { return parameters_.accepted(); }
  /// Without a cycle: puts the newest parameters in force.
  void take_parameters();
  /// See OperatorStateMachine. From any thread.
  void set_goalless(bool goalless) { operator_.set_goalless(goalless); }
  /// When the host called last, on the wall [s]; negative before the first call. From any thread.
  double host_called() const { return host_called_; }
  /// True when the goal is reached; `host_stops`: see HostCalls.
  bool goal_reached(bool host_stops = true);
  /// See HostCalls.
  void set_goal_tolerances(double xy, double yaw);
  /// The last command asked for rest, and the robot is at rest.
  bool stands() const;
  OperatorInput::Status operator_status() const;  // from any thread
  double period() const;                          // nominal, of a control cycle [s]

 private:
  void start_parameters();
  std::string listen(const Parameters& parameters);
  std::vector<std::string> configure(const ParameterSet& set);
  void report_start(std::size_t found) const;

  struct Entry {
    boost::unique_lock<costmap_2d::Costmap2D::mutex_t> costmap;
    std::unique_lock<std::mutex> planner;
  };
  Entry enter() const;
  Entry enter_from_host();
  CycleResult run_cycle(bool stop, bool goalless);
  control::Timing begin_cycle(double now);
  CycleResult decide(const LoopTime& now, RobotObservation& observation, bool recorded);
  RobotObservation observe(const LoopTime& now, const control::Timing& timing, bool goalless);
  std::string update_footprint();
  void check_horizon();
  void adapt_sample_count(double duration, double period, const CycleResult& result);
  Diagnostics::Load load() const;
  double nominal_period() const { return host_.period(loop_.parameters()); }

  const std::string name_;
  costmap_2d::Costmap2DROS& costmap_;
  mutable std::mutex mutex_;
  std::atomic<double> host_called_{-1.0};
  CallbackThread thread_;  // of parameters and diagnostics; outlives what it serves
  HostCalls host_;
  Inputs inputs_;
  OperatorInput operator_;
  Outputs outputs_;
  ParameterUpdates parameters_;
  control::ControlLoop loop_;
  record::CycleRecorder recorder_;
  SampleBudget budget_;
  std::string plan_fault_ = "no plan was given yet";  // empty when there is a plan to follow
  std::vector<std::string> horizon_said_;
};

/// Every plugin calls this when its host initializes it. Makes the planner, once; logs what is missing.
void start_planner(std::unique_ptr<PlannerNode>& planner, const std::string& name, const tf2_ros::Buffer* tf,
                   costmap_2d::Costmap2DROS* costmap);

}  // namespace hidwa_local_planner
