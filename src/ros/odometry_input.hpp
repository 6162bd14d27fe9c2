// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <mutex>
#include <optional>
#include <string>

#include <nav_msgs/Odometry.h>
#include <ros/node_handle.h>
#include <ros/subscriber.h>

#include "hidwa_local_planner/core/parameters.hpp"
#include "hidwa_local_planner/core/types.hpp"
#include "ros/loop_time.hpp"

namespace hidwa_local_planner {

struct VelocityLimits;

/// The robot's measured velocity. Thread-safe; both sides hold the lock for a copy of numbers only.
class OdometryInput {
 public:
  /// `handle` decides the namespace and whose thread serves the messages.
  void subscribe(ros::NodeHandle handle, const std::string& topic);
  void receive(const nav_msgs::Odometry& message, const LoopTime& received);

  struct Reading {
    std::optional<Twist2> velocity;  // [m/s, rad/s]; nothing when it is missing or old
    double received = 0.0;           // [s]
    std::string fault;               // why
  };
  /// The velocity unless it is older than `timeout` [s] at `now` [s], by receive time or by a stamp that is
  /// set.
  Reading read(double now, double timeout) const;
  /// The velocity that the last readings agree on, see AxisBelief. After a pause of the host another node may have
  /// driven, and one reading alone proves nothing. No value where they do not agree, or are older than `timeout` [s].
  std::optional<Twist2> settled(double now, double timeout, const Parameters& parameters,
                                const VelocityLimits& limits) const;
  /// Time jumped back: readings from before no longer count.
  void forget();
  /// What is odd about who sends, in sentences with the remedy; mostly empty. `base`: the robot's frame; `known`:
  /// whether tf connects a frame with that one.
  std::string advice(const std::string& base, const std::function<bool(const std::string& frame)>& known) const;

 private:
  struct Newest {
    std::optional<Twist2> velocity;
    double stamp = 0.0;     // of the header, by the loop's time [s]; 0 where the sender leaves it empty
    double received = 0.0;  // [s]
  };
  // How the messages give the velocity.
  struct Form {
    std::string frame;        // that of the pose
    std::string child_frame;  // that of the velocity
    int sideways = 0;         // messages of late with a velocity to the side, up to kSideways
  };
  static constexpr int kSideways = 20;
  // Of about the last second, even at 100 Hz.
  static constexpr std::size_t kReadings = 128;
  Newest newest() const;
  std::string topic() const;

  ros::Subscriber subscriber_;
  mutable std::mutex mutex_;
  std::string topic_;
  Form form_;
  Newest newest_;
  std::array<Newest, kReadings> readings_;  // the last ones, in a ring
  std::size_t count_ = 0;                   // received
};

}  // namespace hidwa_local_planner
