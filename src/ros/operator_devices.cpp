// SPDX-License-Identifier: BSD-3-Clause
#include "ros/operator_devices.hpp"

#include <memory>

#include <geometry_msgs/PoseStamped.h>
#include <geometry_msgs/Twist.h>
#include <geometry_msgs/TwistStamped.h>
#include <ros/console.h>
#include <ros/message_event.h>
#include <sensor_msgs/Joy.h>
#include <topic_tools/shape_shifter.h>

#include "input/stick_reading.hpp"
#include "input/twist_source.hpp"
#include "ros/conversions.hpp"

namespace hidwa_local_planner {
namespace {

/// Why a ROS message cannot be used as a message of the device; `what` is empty where it can.
struct Misfit {
  std::string what;  // it is
  std::string why;   // with the remedy
};

/// roscpp gives each connection a header of its own, and all messages of a connection share it. While it is held, no
/// other one lies at its address.
std::shared_ptr<const void> connection_of(const boost::shared_ptr<ros::M_string>& header) {
  return {header.get(), [header](const void*) {}};
}

/// Makes a Message of each RosMessage. `kind`: what the device is called in the log.
template <typename RosMessage, typename Message>
OperatorDevice device(const char* kind, const char* source,
                      Misfit (*convert)(const RosMessage& from, const LoopTime& now, Message& to),
                      const DeliverMessage& deliver) {
  using Event = ros::MessageEvent<const RosMessage>;
  const auto take = [=](const Event& event, const std::string& topic) {
    const LoopTime now = LoopTime::now();
    if (now.stamp.isZero()) return;  // a simulated clock that has not begun: nothing can be said about lateness
    Message message;
    message.sender = event.getPublisherName();
    message.received = now.seconds;
    message.connection = connection_of(event.getConnectionHeaderPtr());
    const Misfit misfit = convert(*event.getConstMessage(), now, message);
    if (!misfit.what.empty()) {
      ROS_WARN_THROTTLE(5.0, "%s carries %s from %s: %s", topic.c_str(), misfit.what.c_str(), message.sender.c_str(),
                        misfit.why.c_str());
      return;
    }
    const std::string fault = deliver(source, message);
    if (!fault.empty()) ROS_WARN_THROTTLE(1.0, "%s message dropped: %s", kind, fault.c_str());
  };
  const auto subscribe = [=](ros::NodeHandle handle, const std::string& topic) {
    const boost::function<void(const Event&)> callback = [=](const Event& event) { take(event, topic); };
    // Size 1 and no delay: an old deflection must not count late.
    return handle.subscribe<RosMessage, const Event&>(topic, 1, callback, nullptr, ros::TransportHints().tcpNoDelay());
  };
  return {source, subscribe, "", {}};
}

Misfit to_stick(const sensor_msgs::Joy& from, const LoopTime& now, input::StickMessage& to) {
  to.axes = from.axes;
  to.buttons.assign(from.buttons.begin(), from.buttons.end());
  to.stamp = now.of(from.header.stamp);
  return {};
}

// Throws where a message is not of the type that it names.
Misfit read_twist(const topic_tools::ShapeShifter& from, const LoopTime& now, input::TwistMessage& to) {
  geometry_msgs::Twist twist;
  if (from.getDataType() == "geometry_msgs/TwistStamped") {
    const auto stamped = from.instantiate<geometry_msgs::TwistStamped>();
    twist = stamped->twist;
    to.stamp = now.of(stamped->header.stamp);
  } else if (from.getDataType() == "geometry_msgs/Twist") {
    twist = *from.instantiate<geometry_msgs::Twist>();
  } else {
    return {from.getDataType(), "send geometry_msgs/Twist or TwistStamped"};
  }
  to.u = to_twist(twist);
  return {};
}

Misfit to_twist_message(const topic_tools::ShapeShifter& from, const LoopTime& now, input::TwistMessage& to) {
  try {
    return read_twist(from, now, to);
  } catch (const ros::Exception& error) {
    return {"what cannot be read as " + from.getDataType(), error.what()};
  }
}

void set_pose(input::HandMessage& hand, double x, double y, double z, const geometry_msgs::Quaternion& orientation) {
  hand.position = {x, y, z};
  hand.orientation = {orientation.x, orientation.y, orientation.z, orientation.w};
}

Misfit to_hand(const geometry_msgs::PoseStamped& from, const LoopTime& now, input::HandMessage& to) {
  const geometry_msgs::Point& position = from.pose.position;
  set_pose(to, position.x, position.y, position.z, from.pose.orientation);
  to.stamp = now.of(from.header.stamp);
  return {};
}

}  // namespace

std::vector<OperatorDevice> operator_devices(const DeliverMessage& deliver) {
  return {device("joystick", "stick", to_stick, deliver), device("Twist", "twist", to_twist_message, deliver),
          device<geometry_msgs::PoseStamped, input::HandMessage>("hand pose", "hand", to_hand, deliver)};
}

input::HandMessage to_hand(const geometry_msgs::TransformStamped& from, const LoopTime& now) {
  input::HandMessage hand;
  const geometry_msgs::Vector3& position = from.transform.translation;
  set_pose(hand, position.x, position.y, position.z, from.transform.rotation);
  hand.stamp = now.of(from.header.stamp);
  return hand;
}

}  // namespace hidwa_local_planner
