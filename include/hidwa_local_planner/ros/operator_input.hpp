// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstdint>
#include <mutex>
#include <string>

#include <geometry_msgs/PoseStamped.h>
#include <geometry_msgs/TransformStamped.h>
#include <ros/message_event.h>
#include <ros/node_handle.h>
#include <ros/steady_timer.h>
#include <ros/subscriber.h>
#include <sensor_msgs/Joy.h>
#include <topic_tools/shape_shifter.h>

#include "hidwa_local_planner/control/operator.hpp"
#include "hidwa_local_planner/core/parameters.hpp"
#include "hidwa_local_planner/input/operator_state_machine.hpp"
#include "hidwa_local_planner/ros/callback_thread.hpp"

namespace hidwa_local_planner {

/// The person: the topics of stick, Twist and hand with their own queue and thread, and the state machine
/// behind them. Thread-safe; the control thread waits at most for one message to be taken, and for a few milliseconds
/// after a pause of the whole process, so that what arrived meanwhile is taken first.
class OperatorInput : public control::Operator {
 public:
  OperatorInput();
  ~OperatorInput() override;
  /// Resubscribes where a topic changed, at any time. `handle` decides the namespace.
  void listen(const ros::NodeHandle& handle, const Parameters& parameters);
  /// What messages mean and what follows from them, from the next cycle on.
  void configure(const Parameters& parameters) override;
  /// The same handle, its callbacks served by the thread that takes the person's messages.
  ros::NodeHandle serve(const ros::NodeHandle& handle) { return thread_.serve(handle); }
  /// `sender`: the publishing node; `received` [s].
  void receive(const sensor_msgs::Joy& message, const std::string& sender, double received);
  /// The hand as tf has it; the same transform again is no news.
  void receive(const geometry_msgs::TransformStamped& hand, double received);

  /// From now on each update() writes there what the machine was before it (OperatorStateMachine::save()); null:
  /// nowhere.
  void save_to(Bytes* before) { before_ = before; }
  /// What the person wants now.
  OperatorIntent update(double now) override;
  void debrief(double now, const input::CycleFeedback& feedback) override;
  void new_goal() override;
  bool manual() const override;
  /// In words: see OperatorStateMachine.
  void take_control(bool manual);
  void stop(bool stop);

  struct Status {
    OperatorStateId state = OperatorStateId::autonomy;
    OperatorMode mode = OperatorMode::off;
    bool manual = false;  // SW: the person has taken control and not given it back
    double age = -1.0;    // of the last accepted message of what steers [s]; negative when none came yet
    std::uint32_t dropped = 0;
    bool own_pause = false;  // the input is lost since the planner itself stood still
  };
  Status status(double now) const;

  /// What steers, as a person would ask for it.
  struct Device {
    std::string topic;   // or frames
    std::string sender;  // the node that sent the last message; empty when none came
    std::uint64_t messages = 0;
    std::string clutch_topic;  // of the stick whose button lets a hand count; empty where no hand steers
    std::uint64_t clutch_messages = 0;
  };
  Device device() const;
  std::string advice() const;

 private:
  template <typename Message>
  using Receive = void (OperatorInput::*)(const Message&, const std::string&, double);
  template <typename Message>
  void follow(ros::Subscriber& subscriber, std::string& followed, const ros::NodeHandle& handle,
              const std::string& topic, Receive<Message> taker);
  template <typename Message>
  void take(const Message& message, const char* kind, bool steers);
  void catch_up(double now);
  void receive_twist(const topic_tools::ShapeShifter& message, const std::string& sender, double received);
  void receive_hand(const geometry_msgs::PoseStamped& message, const std::string& sender, double received);

  mutable std::mutex mutex_;
  input::OperatorStateMachine machine_;
  OperatorMode mode_ = OperatorMode::off;
  Bytes* before_ = nullptr;
  Device device_;
  std::atomic<bool> stick_steers_{false};
  ros::Time hand_stamp_;                 // of the newest transform
  std::atomic<std::uint64_t> taken_{0};  // messages, dropped ones too
  CallbackThread thread_;                // outlives the subscribers and the timer that it serves
  ros::SteadyTimer heartbeat_;           // of that thread
  std::string joy_topic_, twist_topic_, hand_topic_;
  ros::Subscriber joy_, twist_, hand_;
};

}  // namespace hidwa_local_planner
