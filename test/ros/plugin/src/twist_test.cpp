// SPDX-License-Identifier: BSD-3-Clause
// A Twist steers instead of the stick: with and without a header, and what is neither.
#include <cmath>
#include <memory>

#include <geometry_msgs/Pose.h>
#include <geometry_msgs/TwistStamped.h>
#include <topic_tools/shape_shifter.h>

#include "person.hpp"

namespace hidwa_plugin_tests {
namespace {

class ByTwist : public Operated {
 protected:
  /// Publishes `wanted` of now as a message of the type, once a period.
  template <typename Message>
  void start_with(Message (*message_of)(const geometry_msgs::Twist&)) {
    const std::string topic = in_namespace("keys");
    set("twist_topic", topic);
    start();
    publisher_ = node_.advertise<Message>(topic, 1);
    ASSERT_TRUE(wait_for([this] { return publisher_.getNumSubscribers() > 0; }));
    ticking_ = std::make_unique<Ticking>([this, message_of] {
      geometry_msgs::Twist wanted;
      wanted.linear.x = v_;
      wanted.angular.z = omega_;
      deliver(publisher_, message_of(wanted));
    });
    drive();
  }

  void expect_steered() {
    v_ = 0.3;
    omega_ = -0.5;
    ASSERT_TRUE(reaches("SHARED"));
    EXPECT_DOUBLE_EQ(state().wanted.linear.x, 0.3);
    EXPECT_DOUBLE_EQ(state().wanted.angular.z, -0.5);
    EXPECT_TRUE(cycle_until([](const Host::Cycle& c) {
      return std::abs(c.command.linear.x - 0.3) < 0.01 && std::abs(c.command.angular.z + 0.5) < 0.01;
    }));
    v_ = omega_ = 0.0;
    EXPECT_TRUE(reaches("HOLD"));
    expect_within_limits();
  }

  ros::NodeHandle node_;
  double v_ = 0.0, omega_ = 0.0;
  ros::Publisher publisher_;
  std::unique_ptr<Ticking> ticking_;
};

geometry_msgs::Twist plain(const geometry_msgs::Twist& wanted) { return wanted; }

geometry_msgs::TwistStamped stamped(const geometry_msgs::Twist& wanted) {
  geometry_msgs::TwistStamped message;
  message.header.stamp = ros::Time::now();
  message.twist = wanted;
  return message;
}

geometry_msgs::Pose neither(const geometry_msgs::Twist& wanted) {
  geometry_msgs::Pose message;
  message.position.x = wanted.linear.x;
  return message;
}

TEST_F(ByTwist, WithoutAHeader) {
  start_with(plain);
  person().left = 1.0f;  // the stick does not steer now
  EXPECT_TRUE(all_cycles([this](const Host::Cycle&) { return !state().active; }, 0.4));
  expect_steered();
}

TEST_F(ByTwist, WithAHeader) {
  start_with(stamped);
  expect_steered();
}

TEST_F(ByTwist, BeyondTheLimitsInManualControl) {
  set("mode", "switching");
  set("guard", "none");
  start_with(plain);
  press();
  ASSERT_EQ(state().state_name, "MANUAL");
  v_ = 7.0;
  omega_ = -9.0;
  EXPECT_TRUE(
      cycle_until([](const Host::Cycle& c) { return c.command.linear.x == 0.5 && c.command.angular.z == -1.0; }));
  EXPECT_DOUBLE_EQ(state().wanted.linear.x, 7.0);
  expect_within_limits();
}

TEST_F(ByTwist, AnotherTypeIsNamedAndSteersNothing) {
  const LogListener log;
  v_ = 0.3;
  const ros::Time begin = ros::Time::now();
  start_with(neither);
  ASSERT_TRUE(cycle_until([&](const Host::Cycle&) {
    return log.said("carries geometry_msgs/Pose from " + ros::this_node::getName() +
                    ": send geometry_msgs/Twist or TwistStamped");
  }));
  EXPECT_TRUE(all_cycles([this](const Host::Cycle& c) { return c.success && !state().active; }, 0.5));
  EXPECT_LE(log.times("carries geometry_msgs/Pose"), 1 + (ros::Time::now() - begin).toSec() / 5.0);
}

TEST_F(ByTwist, WhatOnlyBearsTheNameSteersNothing) {
  const LogListener log;
  set("twist_topic", in_namespace("keys"));
  start();
  drive();
  topic_tools::ShapeShifter other;
  other.morph("00000000000000000000000000000001", "geometry_msgs/Twist", "float64 x\n", "");
  std::vector<std::uint8_t> bytes(8, 0x3f);
  ros::serialization::IStream stream(bytes.data(), static_cast<std::uint32_t>(bytes.size()));
  other.read(stream);
  publisher_ = other.advertise(node_, in_namespace("keys"), 1);
  ASSERT_TRUE(cycle_until([&](const Host::Cycle&) {
    publisher_.publish(other);
    return log.said("cannot be read as geometry_msgs/Twist");
  }));
  EXPECT_TRUE(all_cycles([this](const Host::Cycle& c) { return c.success && !state().active; }, 0.3));
}

}  // namespace
}  // namespace hidwa_plugin_tests

int main(int argc, char** argv) {
  ros::init(argc, argv, "twist_test");
  ros::NodeHandle node;
  ::testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
