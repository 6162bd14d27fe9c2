// SPDX-License-Identifier: BSD-3-Clause
#include "hidwa_local_planner/ros/operator_input.hpp"

namespace hidwa_local_planner {

OperatorInput::OperatorInput() { thread_.start(); }

OperatorInput::~OperatorInput() { thread_.stop(); }

void OperatorInput::configure(const ros::NodeHandle& handle, const Parameters& parameters) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    machine_.configure(parameters);
  }
  const std::string topic = parameters.mode == OperatorMode::off ? std::string() : parameters.joy_topic;
  if (topic != topic_) subscribe(handle, topic);
}

void OperatorInput::subscribe(const ros::NodeHandle& handle, const std::string& topic) {
  topic_ = topic;
  subscriber_.shutdown();
  if (topic.empty()) return;
  // Size 1 and no delay: an old deflection must never be worked off late.
  using Event = ros::MessageEvent<const sensor_msgs::Joy>;
  const boost::function<void(const Event&)> callback = [this](const Event& event) {
    receive(*event.getConstMessage(), event.getPublisherName(), ros::Time::now().toSec());
  };
  subscriber_ = thread_.serve(handle).subscribe<sensor_msgs::Joy, const Event&>(
      topic, 1, callback, nullptr, ros::TransportHints().tcpNoDelay());
}

void OperatorInput::receive(const sensor_msgs::Joy& message, const std::string& sender, double received) {
  input::StickMessage stick;
  stick.sender = sender;
  stick.axes = message.axes;
  stick.buttons.assign(message.buttons.begin(), message.buttons.end());
  stick.stamp = message.header.stamp.toSec();
  stick.received = received;
  std::string fault;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    fault = machine_.receive(stick);
  }
  if (!fault.empty()) ROS_WARN_THROTTLE(1.0, "joystick message dropped: %s", fault.c_str());
}

OperatorIntent OperatorInput::update(double now) {
  const std::lock_guard<std::mutex> lock(mutex_);
  return machine_.update(now);
}

void OperatorInput::debrief(double now, const input::CycleFeedback& feedback) {
  const std::lock_guard<std::mutex> lock(mutex_);
  machine_.debrief(now, feedback);
}

void OperatorInput::new_goal() {
  const std::lock_guard<std::mutex> lock(mutex_);
  machine_.new_goal();
}

void OperatorInput::reset() {
  const std::lock_guard<std::mutex> lock(mutex_);
  machine_.reset();
}

OperatorInput::Status OperatorInput::status(double now) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return {machine_.state(), machine_.input_age(now), machine_.dropped()};
}

std::string OperatorInput::advice() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return machine_.advice();
}

}  // namespace hidwa_local_planner
