// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <actionlib/server/simple_action_server.h>
#include <costmap_2d/costmap_2d_ros.h>
#include <geometry_msgs/PoseStamped.h>
#include <geometry_msgs/Twist.h>
#include <move_base/grid_planner.h>
#include <move_base/planning_thread.h>
#include <move_base/recoveries.h>
#include <move_base_msgs/MoveBaseAction.h>
#include <nav_core/base_local_planner.h>
#include <nav_msgs/GetPlan.h>
#include <ros/ros.h>
#include <std_srvs/Empty.h>
#include <tf2_ros/buffer.h>
#include <pluginlib/class_loader.hpp>

#include <boost/shared_ptr.hpp>
#include <memory>
#include <string>
#include <vector>

namespace move_base {

/// Drives a local planner plugin to goals.
///
/// Threads: callbacks on the node's spinning thread; goals, setPlan, isGoalReached and
/// computeVelocityCommands on the action server's; global plans on a third; each costmap updates on one of
/// its own.
class MoveBase {
 public:
  /// Throws std::runtime_error, or what pluginlib throws, when the parameters ask for what is not there.
  explicit MoveBase(tf2_ros::Buffer& tf);
  ~MoveBase();

 private:
  enum class State { kPlanning, kControlling, kClearing };

  void readParams();
  void announceLimits() const;
  void makeGlobalPlanner();
  void makeLocalPlanner();
  void makeRecoveries();
  void advertise();

  // The action server's thread (execute.cpp).
  void execute(const move_base_msgs::MoveBaseGoalConstPtr& goal);
  bool adopt(const geometry_msgs::PoseStamped& goal);
  bool handlePreempt();
  bool cycle();
  bool takeNewPlan();
  bool control();
  void clearFor(Recoveries::Trigger trigger);
  bool clear();
  bool compute(geometry_msgs::Twist& command);
  bool oscillates();
  bool abort(const std::string& reason);
  void rest();
  void publishZero();
  bool planFromRobot(const geometry_msgs::PoseStamped& goal, std::vector<geometry_msgs::PoseStamped>& plan);
  bool robotPose(const costmap_2d::Costmap2DROS& costmap, geometry_msgs::PoseStamped& pose) const;
  geometry_msgs::PoseStamped toGlobalFrame(const geometry_msgs::PoseStamped& goal) const;

  // The spinning thread (services.cpp).
  void onSimpleGoal(const geometry_msgs::PoseStamped& goal);
  bool onMakePlan(nav_msgs::GetPlan::Request& request, nav_msgs::GetPlan::Response& response);
  bool onClearCostmaps(std_srvs::Empty::Request& request, std_srvs::Empty::Response& response);

  tf2_ros::Buffer& tf_;
  ros::NodeHandle nh_;
  ros::NodeHandle private_nh_{"~"};

  std::string global_planner_type_;
  std::string local_planner_type_;
  double controller_frequency_ = 20.0;  // [Hz]
  double controller_patience_ = 15.0;   // [s]
  double oscillation_timeout_ = 0.0;    // [s] 0: never
  double oscillation_distance_ = 0.5;   // [m]
  bool shutdown_costmaps_ = false;
  bool recovery_behavior_enabled_ = true;
  PlanningThread::Settings planning_settings_;

  std::unique_ptr<costmap_2d::Costmap2DROS> global_costmap_;
  std::unique_ptr<costmap_2d::Costmap2DROS> local_costmap_;
  GridPlanner global_planner_;
  pluginlib::ClassLoader<nav_core::BaseLocalPlanner> loader_{"nav_core", "nav_core::BaseLocalPlanner"};
  boost::shared_ptr<nav_core::BaseLocalPlanner> local_planner_;
  Recoveries recoveries_;
  std::unique_ptr<PlanningThread> planning_;

  // Of the goal in hand; the action server's thread only.
  State state_ = State::kPlanning;
  geometry_msgs::PoseStamped goal_;
  ros::Time last_valid_control_;
  ros::Time last_oscillation_reset_;
  geometry_msgs::Point oscillation_position_;

  ros::Publisher velocity_publisher_;
  ros::Publisher current_goal_publisher_;
  ros::Publisher action_goal_publisher_;
  ros::Publisher recovery_status_publisher_;
  ros::Subscriber simple_goal_subscriber_;
  ros::ServiceServer make_plan_service_;
  ros::ServiceServer clear_costmaps_service_;
  std::unique_ptr<actionlib::SimpleActionServer<move_base_msgs::MoveBaseAction>> server_;
};

}  // namespace move_base
