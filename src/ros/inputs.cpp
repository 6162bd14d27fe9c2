// SPDX-License-Identifier: BSD-3-Clause
#include "ros/inputs.hpp"

#include <algorithm>

#include <ros/console.h>
#include <tf2/exceptions.h>

#include "core/util/words.hpp"
#include "ros/conversions.hpp"

namespace hidwa_local_planner {

Inputs::Inputs(const std::string& name, const tf2_ros::Buffer& tf, costmap_2d::Costmap2DROS& costmap)
    : name_(name), tf_(tf), costmap_(costmap) {
  thread_.start();
}

Inputs::~Inputs() { thread_.stop(); }

void Inputs::listen(const Parameters& parameters) {
  const ros::NodeHandle handle = thread_.serve(ros::NodeHandle());
  const auto follow = [&handle](auto& input, const std::string& wanted, std::string& topic) {
    if (wanted == topic) return;
    topic.clear();
    input.subscribe(handle, wanted);
    topic = wanted;
  };
  follow(odometry_, parameters.odom_topic, odom_topic_);
  follow(moving_obstacles_, parameters.moving_obstacles_topic, moving_obstacles_topic_);
}

void Inputs::forget() {
  odometry_.forget();
  moving_obstacles_.forget();
}

void Inputs::observe(const LoopTime& now, const std::string& plan_frame, const Parameters& parameters,
                     RobotObservation& observation) {
  OdometryInput::Reading odometry = odometry_.read(now.seconds, parameters.odom_timeout);
  observation.velocity = odometry.velocity;
  observation.velocity_time = odometry.received;
  if (observation.missing != Missing::nothing) return;
  if (!observation.velocity) {
    observation.lacks(Missing::odometry, std::move(odometry.fault));
  } else if (!costmap_.isCurrent()) {
    observation.lacks(Missing::costmap, "the local costmap is not current: a sensor that it waits for is silent");
  } else if (!observation.lacks(Missing::transform, observe_pose(now, parameters, observation))) {
    observation.lacks(Missing::transform, observe_plan_frame(now, plan_frame, parameters, observation));
  }
}

void Inputs::observe_moving_obstacles(double now, const Parameters& parameters, RobotObservation& observation) {
  moving_obstacles_.read(now, parameters.moving_obstacle_timeout, tf_, costmap_.getGlobalFrameID(),
                         observation.moving_obstacles);
  moving_obstacles_.read_sectors(tf_, costmap_.getBaseFrameID(), observation.sensor_sectors);
}

Twist2 Inputs::velocity_after_pause(double now, const Planner& planner) const {
  const Parameters& parameters = planner.parameters();
  return odometry_.settled(now, parameters.odom_timeout, parameters, planner.limits()).value_or(Twist2{});
}

void Inputs::watch(const control::Observation& observation, const control::Result& result) {
  if (!observation.velocity) return;
  const Twist2& u = *observation.velocity;
  const control::Timing& timing = observation.timing;
  response_.add(timing.now, timing.period, result.command, observation.velocity_time, u);
  const Decision* decision = result.decision;
  if (decision == nullptr || (!decision->odometry_doubted && !decision->odometry_fast)) return;
  if (decision->odometry_doubted) ++doubted_;
  ROS_WARN_THROTTLE(2.0,
                    "%s: odometry says %.2f m/s, %.2f rad/s, which the commands do not explain: %s (%lu readings were "
                    "doubted so far); check the odometry, and whether something else pushes, holds or drives the robot",
                    name_.c_str(), u.v, u.omega,
                    decision->odometry_fast ? "it lasts, so the collision check believes it" : "it is not believed",
                    static_cast<unsigned long>(doubted_));
}

void Inputs::watch_sender(const control::ControlLoop& loop) {
  const bool doubts = loop.doubts_velocity();
  const auto now = std::chrono::steady_clock::now();
  if (now - looked_ < std::chrono::seconds(1) && doubts == doubts_) return;
  looked_ = now;
  doubts_ = doubts;
  const std::string& base = costmap_.getBaseFrameID();
  std::string text =
      odometry_.advice(base, [&](const std::string& frame) { return tf_.canTransform(base, frame, ros::Time(0)); });
  if (doubts) {
    text += (text.empty() ? "The velocity of " : " The velocity of ") + loop.parameters().odom_topic +
            " is not believed: the pose moves as commanded, and the velocity (twist) says something else. It is taken "
            "from the pose. The twist must be the robot's own velocity, in m/s and rad/s, in the frame " +
            base + ": correct its sender.";
  }
  if (text == said_) return;
  said_ = std::move(text);
  if (said_.empty()) {
    ROS_INFO("%s: the odometry is as it should be", name_.c_str());
  } else {
    ROS_WARN("%s: %s", name_.c_str(), said_.c_str());
  }
}

std::string Inputs::observe_pose(const LoopTime& now, const Parameters& parameters, RobotObservation& observation) {
  const std::string& frame = costmap_.getGlobalFrameID();
  if (std::string fault = control::fault_of_frames(frame, costmap_.getBaseFrameID()); !fault.empty()) return fault;
  geometry_msgs::PoseStamped pose;
  if (!costmap_.getRobotPose(pose)) {
    return "there is no pose of the robot in " + frame + ": check the transform from " + costmap_.getBaseFrameID();
  }
  if (const double ahead = pose_ahead_of(now, pose.header.stamp); ahead > parameters.transform_tolerance) {
    return "the transform from " + costmap_.getBaseFrameID() + " to " + frame + " is " + worded(ahead) +
           " s ahead of the clock, so the present pose is not known: set the clocks of its sender and of this machine "
           "alike (transform_tolerance); if it stays, restart the host";
  }
  observation.pose = to_pose(pose.pose);
  if (!pose.header.stamp.isZero()) observation.pose_age = std::max(0.0, now.seconds - now.of(pose.header.stamp));
  if (!is_finite(observation.pose)) return "the robot's pose in " + frame + " is not a number";
  frame_watch_.observe(observation.pose, *observation.velocity, observation.timing.interval);
  if (frame_watch_.stands_still()) {
    return "the robot's pose in " + frame + " stays the same while odometry says that it drives: " + frame +
           " moves with the robot (set the local costmap's global_frame to odom), or the transform from " +
           costmap_.getBaseFrameID() + " is not renewed";
  }
  return "";
}

std::string Inputs::observe_plan_frame(const LoopTime& now, const std::string& plan_frame, const Parameters& parameters,
                                       RobotObservation& observation) const {
  const std::string& frame = costmap_.getGlobalFrameID();
  if (plan_frame == frame) return "";
  try {
    const geometry_msgs::TransformStamped transform = tf_.lookupTransform(frame, plan_frame, ros::Time(0));
    const double age = transform.header.stamp.isZero() ? 0.0 : now.seconds - now.of(transform.header.stamp);
    if (age > parameters.transform_tolerance) {
      return "the transform from the plan's frame " + plan_frame + " to " + frame + " is " + worded(age) +
             " s old (transform_tolerance)";
    }
    observation.from_plan = to_transform(transform.transform);
    return is_finite(observation.from_plan.origin) ? "" : "the transform from " + plan_frame + " is not a number";
  } catch (const tf2::TransformException& error) {
    return "no transform from the plan's frame " + plan_frame + " to " + frame + ": " + error.what();
  }
}

// By how much the newest transform is ahead of `now` [s]. A pose for `now` is then made of what was sent long before,
// or of nothing newer. A pose with a stamp of before shows that there is no newer transform: then tf is not asked.
double Inputs::pose_ahead_of(const LoopTime& now, const ros::Time& stamp) const {
  if (stamp < now.stamp) return 0.0;
  try {
    const ros::Time newest =
        tf_.lookupTransform(costmap_.getGlobalFrameID(), costmap_.getBaseFrameID(), ros::Time(0)).header.stamp;
    return now.of(newest) - now.seconds;
  } catch (const tf2::TransformException&) {
    return 0.0;
  }
}

}  // namespace hidwa_local_planner
