// SPDX-License-Identifier: BSD-3-Clause
#include "ros/odometry_watch.hpp"

#include <utility>

#include <ros/console.h>

namespace hidwa_local_planner {

void OdometryWatch::observe(const control::Observation& observation, const control::Result& result) {
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

void OdometryWatch::watch_sender(const OdometryInput& odometry, const tf2_ros::Buffer& tf,
                                 const control::ControlLoop& loop) {
  const bool doubts = loop.doubts_velocity();
  const auto now = std::chrono::steady_clock::now();
  if (now - looked_ < std::chrono::seconds(1) && doubts == doubts_) return;
  looked_ = now;
  doubts_ = doubts;
  std::string text =
      odometry.advice(base_, [&](const std::string& frame) { return tf.canTransform(base_, frame, ros::Time(0)); });
  if (doubts) {
    text += (text.empty() ? "The velocity of " : " The velocity of ") + loop.parameters().odom_topic +
            " is not believed: the pose moves as commanded, and the velocity (twist) says something else. It is taken "
            "from the pose. The twist must be the robot's own velocity, in m/s and rad/s, in the frame " +
            base_ + ": correct its sender.";
  }
  if (text == said_) return;
  said_ = std::move(text);
  if (said_.empty()) {
    ROS_INFO("%s: the odometry is as it should be", name_.c_str());
  } else {
    ROS_WARN("%s: %s", name_.c_str(), said_.c_str());
  }
}

}  // namespace hidwa_local_planner
