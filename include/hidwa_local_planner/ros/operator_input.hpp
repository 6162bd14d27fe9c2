// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <mutex>
#include <string>

#include <ros/node_handle.h>
#include <ros/subscriber.h>
#include <sensor_msgs/Joy.h>

#include "hidwa_local_planner/core/parameters.hpp"
#include "hidwa_local_planner/input/operator_state_machine.hpp"
#include "hidwa_local_planner/ros/callback_thread.hpp"

namespace hidwa_local_planner {

/// The person: a joystick topic with its own queue and thread, and the state machine behind it. Thread-safe;
/// the control thread waits at most for one message to be taken.
class OperatorInput {
 public:
  OperatorInput();
  ~OperatorInput();
  /// Resubscribes where the topic changed. `handle` decides the namespace.
  void configure(const ros::NodeHandle& handle, const Parameters& parameters);
  /// `sender`: the publishing node; `received` [s].
  void receive(const sensor_msgs::Joy& message, const std::string& sender, double received);

  OperatorIntent update(double now);
  void debrief(double now, const input::CycleFeedback& feedback);
  void new_goal();
  /// Time jumped back.
  void reset();

  struct Status {
    OperatorStateId state = OperatorStateId::autonomy;
    double age = -1.0;  // of the last accepted message [s]; negative when none came yet
    std::uint32_t dropped = 0;
  };
  Status status(double now) const;
  std::string advice() const;

 private:
  void subscribe(const ros::NodeHandle& handle, const std::string& topic);

  mutable std::mutex mutex_;
  input::OperatorStateMachine machine_;
  CallbackThread thread_;  // outlives the subscriber that it serves
  std::string topic_;
  ros::Subscriber subscriber_;
};

}  // namespace hidwa_local_planner
