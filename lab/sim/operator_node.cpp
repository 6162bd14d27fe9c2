// SPDX-License-Identifier: BSD-3-Clause
// hidwa_operator: a simulated person. Publishes sensor_msgs/Joy as joy_node does with autorepeat, and in mode
// gesture the hand's geometry_msgs/PoseStamped as a headset's bridge does.

#include <exception>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include <geometry_msgs/PoseStamped.h>
#include <nav_msgs/Odometry.h>
#include <nav_msgs/Path.h>
#include <ros/ros.h>
#include <sensor_msgs/Joy.h>

#include "node_messages.hpp"
#include "node_parameters.hpp"
#include "sim/avoiding_operator.hpp"
#include "sim/operator_device.hpp"
#include "sim/scripted_operator.hpp"

namespace hidwa_local_planner {
namespace sim {
namespace {

constexpr double kPublishRate = 20.0;  // [Hz], simulated time where the clock is
constexpr std::size_t kAxes = 8;       // those of a common gamepad
constexpr std::size_t kButtons = 11;
constexpr double kGestureRange = 0.3;  // [m], the planner's gesture_range

std::string required_path(const ros::NodeHandle& node, const std::string& name) {
  const auto path = node.param<std::string>(name, "");
  if (path.empty()) throw std::runtime_error("parameter ~" + name + " is missing: ~operator avoid needs that file");
  return path;
}

std::unique_ptr<AvoidingOperator> make_avoiding(const ros::NodeHandle& node) {
  RobotHabits habits;
  node.getParam("max_vel_x", habits.max_vel_x);
  node.getParam("max_vel_theta", habits.max_vel_theta);
  node.getParam("acc_lim_theta", habits.acc_lim_theta);
  node.getParam("dead_zone", habits.dead_zone);
  node.getParam("delta", habits.hold_time);
  if (node.param<std::string>("mode", "joystick") == "switching") habits.hold_time = 0.0;  // given back is given back
  node.getParam("sim_time", habits.refusal_time);
  habits.radius = circumscribed_radius(read_footprint(node, node.param("radius", habits.radius)));
  OperatorTraits traits;
  node.getParam("reaction_time", traits.reaction_time);
  node.getParam("region_margin", traits.region_margin);
  const OccupancyMap map = load_map(required_path(node, "map"));
  const RegionsFile file = load_regions(required_path(node, "regions"));
  const auto seed = static_cast<std::uint64_t>(node.param("seed", 1));
  return std::make_unique<AvoidingOperator>(traits, habits, map, file.regions, seed);
}

class OperatorNode {
 public:
  explicit OperatorNode(const ros::NodeHandle& private_node) {
    const auto mode = private_node.param<std::string>("operator", "none");
    if (mode == "avoid") {
      auto avoiding = make_avoiding(private_node);
      subscribe_to_plans(private_node, *avoiding);
      operator_ = std::move(avoiding);
    } else if (mode == "none") {
      operator_ = std::make_unique<AbsentOperator>();
    } else {
      operator_ = std::make_unique<ScriptedOperator>(load_script(mode));
    }
    device_ = make_operator_device(private_node.param<std::string>("mode", "joystick"),
                                   private_node.param("gesture_range", kGestureRange));
    joy_ = node_.advertise<sensor_msgs::Joy>("joy", 10);
    hand_ = node_.advertise<geometry_msgs::PoseStamped>("hand_pose", 10);
    truth_ = node_.subscribe<nav_msgs::Odometry>("ground_truth", 1,
                                                 [this](const nav_msgs::Odometry::ConstPtr& m) { seen_ = m; });
    timer_ = node_.createTimer(ros::Duration(1.0 / kPublishRate), [this](const ros::TimerEvent&) { publish(); });
  }

 private:
  void subscribe_to_plans(const ros::NodeHandle& private_node, AvoidingOperator& avoiding) {
    // Whichever of the usual global planners is at work; `plan` is there to be remapped.
    std::vector<std::string> topics{"plan", "/move_base/GlobalPlanner/plan", "/move_base/NavfnROS/plan"};
    private_node.getParam("plan_topics", topics);
    for (const std::string& topic : topics) {
      plans_.push_back(node_.subscribe<nav_msgs::Path>(topic, 1, [&avoiding](const nav_msgs::Path::ConstPtr& m) {
        Route route;
        for (const geometry_msgs::PoseStamped& pose : m->poses) {
          route.emplace_back(pose.pose.position.x, pose.pose.position.y);
        }
        avoiding.set_plan(route);
      }));
    }
  }

  void publish() {
    sensor_msgs::Joy joy;
    joy.header.stamp = ros::Time::now();
    joy.axes.assign(kAxes, 0.0F);
    joy.buttons.assign(kButtons, 0);
    double hand_left = 0.0;  // [m]
    if (seen_) {
      const Stick stick = operator_->update(
          {seen_->header.stamp.toSec(),
           {seen_->pose.pose.position.x, seen_->pose.pose.position.y, yaw_of(seen_->pose.pose.orientation)},
           velocity_of(seen_->twist.twist)});
      const Controls controls = device_->update(seen_->header.stamp.toSec(), stick);
      joy.axes[0] = static_cast<float>(controls.stick.left);
      joy.axes[1] = static_cast<float>(controls.stick.up);
      joy.buttons[0] = controls.toggle || controls.clutch ? 1 : 0;
      hand_left = controls.hand_left;
    }
    joy_.publish(joy);
    publish_hand(joy.header.stamp, hand_left);
  }

  void publish_hand(const ros::Time& stamp, double left) {
    geometry_msgs::PoseStamped hand;
    hand.header.stamp = stamp;
    hand.header.frame_id = "vr_origin";
    hand.pose.position.x = 0.35;  // [m], before the person, on the armrest's height
    hand.pose.position.y = -0.2 + left;
    hand.pose.position.z = 0.9;
    hand.pose.orientation.w = 1.0;
    hand_.publish(hand);
  }

  ros::NodeHandle node_;
  std::unique_ptr<Operator> operator_;
  nav_msgs::Odometry::ConstPtr seen_;
  std::unique_ptr<OperatorDevice> device_;
  ros::Publisher joy_, hand_;
  ros::Subscriber truth_;
  std::vector<ros::Subscriber> plans_;
  ros::Timer timer_;
};

}  // namespace
}  // namespace sim
}  // namespace hidwa_local_planner

int main(int argc, char** argv) {
  ros::init(argc, argv, "hidwa_operator");
  const ros::NodeHandle private_node("~");  // outlives the error below: the log ends with the last handle
  try {
    hidwa_local_planner::sim::OperatorNode node(private_node);
    ros::spin();
  } catch (const std::exception& e) {
    ROS_FATAL("%s", e.what());
    return 1;
  }
  return 0;
}
