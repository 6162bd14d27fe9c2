// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <mutex>
#include <string>
#include <vector>

#include <geometry_msgs/TransformStamped.h>
#include <ros/node_handle.h>
#include <ros/steady_timer.h>
#include <ros/subscriber.h>
#include <tf2_ros/buffer.h>

#include "hidwa_local_planner/core/parameters.hpp"
#include "input/operator_state_machine.hpp"
#include "ros/callback_thread.hpp"
#include "ros/operator_devices.hpp"

namespace hidwa_local_planner {

/// The operator: the topics of the input devices with their own queue and thread, and the state machine
/// behind them. Thread-safe but for look_for_hand(). The control thread waits at most for one message to be taken, and
/// for a few milliseconds after a pause of the whole process, so that what arrived meanwhile is taken first.
class OperatorInput {
 public:
  /// `tf` must outlive it.
  explicit OperatorInput(const tf2_ros::Buffer& tf);
  ~OperatorInput();
  /// Resubscribes where a topic changed, at any time. `handle` decides the namespace.
  void listen(const ros::NodeHandle& handle, const Parameters& parameters);
  /// What messages mean and what follows from them, from the next cycle on.
  void configure(const Parameters& parameters);
  /// Subscribes to what a device without the right buttons can ask for by topic, below the planner's name:
  /// `take_control` and `stop` (std_msgs/Bool).
  void listen_to_commands(const ros::NodeHandle& handle);
  /// Takes the hand as tf has it, in mode gesture where it is a frame; the same transform again is no message. A
  /// transform that cannot be looked up counts as silence of the device. One call at a time.
  void look_for_hand(const Parameters& parameters, const LoopTime& now);

  /// What the operator asks for now. `before`, where it is not null, takes what the machine remembered until then
  /// (OperatorStateMachine::save()).
  OperatorIntent update(double now, Bytes* before);
  /// As those of OperatorStateMachine.
  void debrief(double now, const input::CycleFeedback& feedback);
  void new_goal();
  void set_goalless(bool goalless);

  struct Status {
    OperatorStateId state = OperatorStateId::autonomy;
    OperatorMode mode = OperatorMode::off;
    bool manual = false;    // SW: the operator has taken control and not given it back
    bool steers = false;    // the operator gives input that counts
    bool goalless = false;  // the host has no goal
    double age = -1.0;      // of the last accepted message of what steers [s]; negative when none came yet
    std::uint32_t dropped = 0;
    bool lost_by_pauses = false;  // the input is lost since the planner itself stood still
  };
  Status status(double now) const;

  /// What steers, as an operator would ask for it.
  struct Device {
    std::string topic;   // or frames; empty in mode off
    std::string sender;  // the node that sent the last message; empty when none came
    std::uint64_t messages = 0;
    std::string clutch_topic;  // of the device whose button lets this one count; empty where it needs none
    std::uint64_t clutch_messages = 0;
  };
  Device device() const;
  std::string advice() const;

 private:
  void show_device(const std::vector<input::ListedSource>& sources);
  void start_heartbeat(const ros::NodeHandle& handle);
  std::string take(const std::string& source, const input::OperatorMessage& message);
  void catch_up(double now);

  const tf2_ros::Buffer& tf_;
  mutable std::mutex mutex_;
  input::OperatorStateMachine machine_;
  OperatorMode mode_ = OperatorMode::off;
  Device device_;
  std::string steering_;        // the source that steers, by the parameters last listened by
  ros::Time hand_stamp_;        // of the newest transform; look_for_hand() alone
  CallbackThread thread_;       // outlives the subscribers and the timer that it serves
  ros::SteadyTimer heartbeat_;  // of that thread
  std::vector<OperatorDevice> devices_;
  ros::Subscriber take_control_, stop_;
};

}  // namespace hidwa_local_planner
