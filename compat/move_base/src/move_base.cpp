// SPDX-License-Identifier: BSD-3-Clause
#include <move_base/move_base.h>
#include <move_base_msgs/RecoveryStatus.h>

#include <stdexcept>

namespace move_base {

MoveBase::MoveBase(tf2_ros::Buffer& tf) : tf_(tf) {
  readParams();
  announceLimits();
  makeGlobalPlanner();
  makeLocalPlanner();
  advertise();
  global_costmap_->start();
  local_costmap_->start();
  makeRecoveries();
  if (shutdown_costmaps_) {
    global_costmap_->stop();
    local_costmap_->stop();
  }
  planning_ = std::make_unique<PlanningThread>(
      [this](const geometry_msgs::PoseStamped& goal, PlanningThread::Plan& plan) { return planFromRobot(goal, plan); },
      planning_settings_);
  server_->start();
}

MoveBase::~MoveBase() {
  server_->shutdown();  // ends the goal in hand, which still says so
  server_.reset();
  planning_.reset();  // no plan is made any more
}

void MoveBase::readParams() {
  global_planner_type_ = private_nh_.param<std::string>("base_global_planner", "navfn/NavfnROS");
  local_planner_type_ = private_nh_.param<std::string>("base_local_planner", "base_local_planner/TrajectoryPlannerROS");
  controller_frequency_ = private_nh_.param("controller_frequency", controller_frequency_);
  controller_patience_ = private_nh_.param("controller_patience", controller_patience_);
  oscillation_timeout_ = private_nh_.param("oscillation_timeout", oscillation_timeout_);
  oscillation_distance_ = private_nh_.param("oscillation_distance", oscillation_distance_);
  recovery_behavior_enabled_ = private_nh_.param("recovery_behavior_enabled", recovery_behavior_enabled_);
  shutdown_costmaps_ = private_nh_.param("shutdown_costmaps", shutdown_costmaps_);
  planning_settings_.frequency = private_nh_.param("planner_frequency", planning_settings_.frequency);
  planning_settings_.patience = private_nh_.param("planner_patience", planning_settings_.patience);
  planning_settings_.max_retries = private_nh_.param("max_planning_retries", planning_settings_.max_retries);
  if (!(controller_frequency_ > 0.0)) throw std::runtime_error("parameter controller_frequency must be above 0 [Hz]");
}

void MoveBase::announceLimits() const {
  if (global_planner_type_ != "navfn/NavfnROS" && global_planner_type_ != "global_planner/GlobalPlanner") {
    throw std::runtime_error("base_global_planner is \"" + global_planner_type_ +
                             "\"; this move_base has one grid planner, which answers to navfn/NavfnROS and "
                             "global_planner/GlobalPlanner. Use one of these, or the navigation stack's own move_base");
  }
  ROS_INFO("This move_base is the compat one: for %s its own grid planner plans.", global_planner_type_.c_str());
  if (recovery_behavior_enabled_ && !private_nh_.hasParam("recovery_behaviors")) {
    ROS_INFO(
        "The navigation stack's default recovery behaviours are not here: without a list recovery_behaviors a goal is "
        "given up where the stack would recover.");
  }
}

void MoveBase::makeGlobalPlanner() {
  global_costmap_ = std::make_unique<costmap_2d::Costmap2DROS>("global_costmap", tf_);
  global_costmap_->pause();
  global_planner_.initialize(global_planner_type_.substr(global_planner_type_.find('/') + 1), global_costmap_.get());
}

void MoveBase::makeLocalPlanner() {
  local_costmap_ = std::make_unique<costmap_2d::Costmap2DROS>("local_costmap", tf_);
  local_costmap_->pause();
  local_planner_ = loader_.createInstance(local_planner_type_);
  ROS_INFO("Local planner %s", local_planner_type_.c_str());
  local_planner_->initialize(loader_.getName(local_planner_type_), &tf_, local_costmap_.get());
}

void MoveBase::makeRecoveries() { recoveries_.load(private_nh_, tf_, *global_costmap_, *local_costmap_); }

void MoveBase::advertise() {
  ros::NodeHandle action_nh("move_base");
  ros::NodeHandle simple_nh("move_base_simple");
  velocity_publisher_ = nh_.advertise<geometry_msgs::Twist>("cmd_vel", 1);
  current_goal_publisher_ = private_nh_.advertise<geometry_msgs::PoseStamped>("current_goal", 0);
  action_goal_publisher_ = action_nh.advertise<move_base_msgs::MoveBaseActionGoal>("goal", 1);
  recovery_status_publisher_ = action_nh.advertise<move_base_msgs::RecoveryStatus>("recovery_status", 1);
  simple_goal_subscriber_ = simple_nh.subscribe("goal", 1, &MoveBase::onSimpleGoal, this);
  make_plan_service_ = private_nh_.advertiseService("make_plan", &MoveBase::onMakePlan, this);
  clear_costmaps_service_ = private_nh_.advertiseService("clear_costmaps", &MoveBase::onClearCostmaps, this);
  server_ = std::make_unique<actionlib::SimpleActionServer<move_base_msgs::MoveBaseAction>>(
      nh_, "move_base", [this](const move_base_msgs::MoveBaseGoalConstPtr& goal) { execute(goal); }, false);
}

}  // namespace move_base
