// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>

#include <tf2_ros/buffer.h>

#include "control/control_loop.hpp"
#include "control/response_watch.hpp"
#include "ros/odometry_input.hpp"

namespace hidwa_local_planner {

/// Tells in the log what is odd about the odometry, and measures how late the base answers commands.
class OdometryWatch {
 public:
  /// `name`: of the planner; `base`: the robot's frame.
  OdometryWatch(std::string name, std::string base) : name_(std::move(name)), base_(std::move(base)) {}

  /// A cycle came to this.
  void observe(const control::Observation& observation, const control::Result& result);
  /// Looks once a second at who sends the odometry, and at once where the loop begins or ceases to doubt the velocity.
  void watch_sender(const OdometryInput& odometry, const tf2_ros::Buffer& tf, const control::ControlLoop& loop);

  const std::string& said() const { return said_; }   // by watch_sender(); empty where nothing is odd
  std::uint64_t doubted() const { return doubted_; }  // readings that no command explains
  std::optional<double> latency() const { return response_.latency(); }  // of the base [s]

 private:
  const std::string name_, base_;
  ResponseWatch response_;
  std::uint64_t doubted_ = 0;
  bool doubts_ = false;  // the velocity, when watch_sender() looked last
  std::chrono::steady_clock::time_point looked_;
  std::string said_;
};

}  // namespace hidwa_local_planner
