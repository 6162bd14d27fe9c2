// SPDX-License-Identifier: BSD-3-Clause
// hidwa_plan_follower: a host for a local planner in the place of move_base, whose plans come by topic. Bag tests
// play to it what a robot saw.
//
//   plan          nav_msgs/Path, heard: what is followed from now on
//   goal_reached  std_msgs/Bool, latched: whether the planner says so of the newest plan
//   cmd_vel       geometry_msgs/Twist: what the planner commands; zero where it fails or has arrived
//   ~base_local_planner, ~controller_frequency, ~local_costmap/...: as of move_base
#include <memory>
#include <mutex>
#include <string>

#include <costmap_2d/costmap_2d_ros.h>
#include <geometry_msgs/Twist.h>
#include <nav_core/base_local_planner.h>
#include <nav_msgs/Path.h>
#include <ros/ros.h>
#include <std_msgs/Bool.h>
#include <tf2_ros/buffer.h>
#include <tf2_ros/transform_listener.h>
#include <boost/thread/locks.hpp>
#include <pluginlib/class_loader.hpp>

namespace {

class PlanFollower {
 public:
  PlanFollower() : loader_("nav_core", "nav_core::BaseLocalPlanner"), listener_(tf_), costmap_("local_costmap", tf_) {
    const auto name = ros::param::param<std::string>("~base_local_planner", "hidwa_local_planner/HIDWAPlannerROS");
    planner_ = loader_.createInstance(name);
    planner_->initialize(loader_.getName(name), &tf_, &costmap_);
    command_ = node_.advertise<geometry_msgs::Twist>("cmd_vel", 10);
    reached_ = node_.advertise<std_msgs::Bool>("goal_reached", 10, true);
    // Last: who waits for this subscriber finds everything else there.
    plans_ = node_.subscribe<nav_msgs::Path>("plan", 10, [this](const nav_msgs::Path::ConstPtr& plan) {
      const std::lock_guard<std::mutex> lock(mutex_);
      newest_ = plan;
    });
  }

  void run() {
    ros::Rate rate(ros::param::param("~controller_frequency", 20.0));
    while (ros::ok()) {
      cycle();
      rate.sleep();
    }
  }

 private:
  void cycle() {
    if (const nav_msgs::Path::ConstPtr plan = take_plan()) {
      following_ = planner_->setPlan(plan->poses);
      tell(false);
    }
    if (!following_) return;
    // The costmap's own thread may lag behind a bag that is played fast: what was seen by now is to count.
    costmap_.updateMap();
    geometry_msgs::Twist command;
    if (planner_->isGoalReached()) {
      following_ = false;
      tell(true);
    } else {
      const boost::unique_lock<costmap_2d::Costmap2D::mutex_t> lock(*costmap_.getCostmap()->getMutex());
      if (!planner_->computeVelocityCommands(command)) command = geometry_msgs::Twist();
    }
    command_.publish(command);
  }

  nav_msgs::Path::ConstPtr take_plan() {
    const std::lock_guard<std::mutex> lock(mutex_);
    nav_msgs::Path::ConstPtr plan;
    plan.swap(newest_);
    return plan;
  }

  void tell(bool reached) {
    std_msgs::Bool message;
    message.data = reached;
    reached_.publish(message);
  }

  ros::NodeHandle node_;
  pluginlib::ClassLoader<nav_core::BaseLocalPlanner> loader_;  // outlives its planner
  tf2_ros::Buffer tf_;
  tf2_ros::TransformListener listener_;
  costmap_2d::Costmap2DROS costmap_;
  boost::shared_ptr<nav_core::BaseLocalPlanner> planner_;
  ros::Publisher command_, reached_;
  std::mutex mutex_;
  nav_msgs::Path::ConstPtr newest_;
  bool following_ = false;
  ros::Subscriber plans_;
};

}  // namespace

int main(int argc, char** argv) {
  ros::init(argc, argv, "plan_follower");
  ros::AsyncSpinner spinner(1);
  spinner.start();
  try {
    PlanFollower follower;
    follower.run();
  } catch (const std::exception& error) {
    ROS_FATAL("plan_follower: %s", error.what());
    return 1;
  }
  return 0;
}
