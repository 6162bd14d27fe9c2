// SPDX-License-Identifier: BSD-3-Clause
#include "ros/odometry_input.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "core/motion/odometry_belief.hpp"
#include "core/util/words.hpp"
#include "ros/conversions.hpp"

namespace hidwa_local_planner {
namespace {

constexpr double kSidewaysSpeed = 0.1;  // [m/s]; less is noise, or a wheel that slips

}  // namespace

void OdometryInput::subscribe(ros::NodeHandle handle, const std::string& topic) {
  subscriber_.shutdown();
  forget();
  const auto callback = [this](const nav_msgs::Odometry::ConstPtr& message) { receive(*message, LoopTime::now()); };
  subscriber_ = handle.subscribe<nav_msgs::Odometry>(topic, 1, callback, nullptr, ros::TransportHints().tcpNoDelay());
  std::string resolved = subscriber_.getTopic();
  const std::lock_guard<std::mutex> lock(mutex_);
  topic_.swap(resolved);
}

void OdometryInput::receive(const nav_msgs::Odometry& message, const LoopTime& received) {
  const Twist2 velocity = to_twist(message.twist.twist);
  if (!is_finite(velocity)) {
    ROS_WARN_THROTTLE(1.0, "an odometry message was dropped: its velocity is not a number; check the sender");
    return;
  }
  const Newest newest{velocity, received.of(message.header.stamp), received.seconds};
  const double sideways = std::abs(message.twist.twist.linear.y);
  const bool to_the_side = sideways > kSidewaysSpeed && sideways > 0.5 * std::abs(velocity.v);
  const std::lock_guard<std::mutex> lock(mutex_);
  if (form_.frame != message.header.frame_id) form_.frame = message.header.frame_id;
  if (form_.child_frame != message.child_frame_id) form_.child_frame = message.child_frame_id;
  form_.sideways = to_the_side ? std::min(form_.sideways + 1, kSideways) : std::max(form_.sideways - 1, 0);
  newest_ = newest;
  readings_[count_++ % kReadings] = newest;
}

std::optional<Twist2> OdometryInput::settled(double now, double timeout, const Parameters& parameters,
                                             const VelocityLimits& limits) const {
  if (!read(now, timeout).velocity) return std::nullopt;
  std::array<Newest, kReadings> readings;
  std::size_t count = 0;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    readings = readings_;
    count = count_;
  }
  // As if zero had been commanded: readings at rest agree at once, others must agree with each other.
  const Twist2 tolerance = reading_tolerance(parameters, {});
  OdometryBelief belief;
  Twist2 settled;
  bool agreed = false;
  for (std::size_t i = count > kReadings ? count - kReadings : 0; i < count; ++i) {
    const Newest& reading = readings[i % kReadings];
    const auto judge = [&](double Twist2::*axis, AxisBelief& own, const AxisLimits& axis_limits) {
      const OdometryReading said =
          own.judge(reading.received, reading.received, (*reading.velocity).*axis, {}, tolerance.*axis, axis_limits);
      settled.*axis = said == OdometryReading::faster ? own.believed() : (*reading.velocity).*axis;
      return said != OdometryReading::doubted;
    };
    const bool v = judge(&Twist2::v, belief.v, limits.x);
    agreed = judge(&Twist2::omega, belief.omega, limits.theta) && v;
  }
  return agreed ? std::optional<Twist2>(settled) : std::nullopt;
}

// Nothing is copied where nothing is odd: a cycle must not allocate.
std::string OdometryInput::advice(const std::string& base,
                                  const std::function<bool(const std::string& frame)>& known) const {
  const std::uint32_t senders = subscriber_ ? subscriber_.getNumPublishers() : 0;
  bool received = false, sideways = false, own_frame = false;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    received = newest_.velocity.has_value();
    sideways = form_.sideways == kSideways;
    own_frame = form_.child_frame == base;
  }
  if (received && own_frame && !sideways && senders < 2) return {};
  std::string topic, frame, child;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    topic = topic_;
    frame = form_.frame;
    child = form_.child_frame;
  }
  std::string text;
  const auto add = [&text](const std::string& sentence) { text += (text.empty() ? "" : " ") + sentence; };
  if (senders > 1) {
    add(std::to_string(senders) + " nodes publish " + topic + " (rostopic info): the velocity is now one's, now the " +
        "other's. Let only one of them publish it, or set odom_topic.");
  }
  if (!received) return text;
  if (child == frame && !child.empty()) {
    add("The velocity on " + topic + " is given in " + child +
        " (child_frame_id), which does not move with the robot: " + "set child_frame_id to " + base +
        ", and give the velocity in that frame.");
  } else if (!own_frame && (child.empty() || !known(child))) {
    add("child_frame_id on " + topic + " is " + (child.empty() ? "empty" : child + ", which tf does not know") +
        ": the velocity is taken as one in " + base + ". Set child_frame_id to the frame that it is given in.");
  }
  if (sideways) {
    add("The velocity on " + topic + " has a large part to the side (linear.y): it is given in another frame than " +
        "the robot's, or the robot drives sideways, of which the planner knows nothing. Look at its sender.");
  }
  return text;
}

OdometryInput::Reading OdometryInput::read(double now, double timeout) const {
  const Newest newest = this->newest();
  if (!newest.velocity) return {std::nullopt, 0.0, "no odometry on " + topic() + " yet: check odom_topic"};
  double age = now - newest.received;
  if (newest.stamp > 0.0) age = std::max(age, now - newest.stamp);
  if (age <= timeout) return {newest.velocity, newest.received, ""};
  return {std::nullopt, 0.0, "odometry on " + topic() + format(" is %.2f s old (odom_timeout %.2f s)", age, timeout)};
}

void OdometryInput::forget() {
  const std::lock_guard<std::mutex> lock(mutex_);
  newest_ = {};
  count_ = 0;
}

OdometryInput::Newest OdometryInput::newest() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return newest_;
}

std::string OdometryInput::topic() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return topic_;
}

}  // namespace hidwa_local_planner
