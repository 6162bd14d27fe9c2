// SPDX-License-Identifier: BSD-3-Clause
// An operator's devices at their real topics: a stick, a Twist, a hand with a clutch. They steer, are let go of and
// fall silent; what they mean in detail is tested without ROS.
#include <cmath>
#include <memory>

#include <geometry_msgs/Pose.h>
#include <geometry_msgs/PoseStamped.h>
#include <geometry_msgs/TwistStamped.h>
#include <topic_tools/shape_shifter.h>

#include "person.hpp"

namespace hidwa_plugin_tests {
namespace {

constexpr double kTimeout = 0.5;  // input_timeout's default [s]

using Stick = Operated;
using Timeliness = Operated;  // how soon messages count, and for how long after the link was cut

TEST_F(Stick, SteersIsLetGoAndTheRobotTakesOver) {
  set("delta", 0.5);
  start();
  drive();
  EXPECT_EQ(state().state_name, "AUTONOMY");
  person().left = 1.0f;
  ASSERT_TRUE(reaches("SHARED"));
  EXPECT_TRUE(state().active);
  EXPECT_DOUBLE_EQ(state().wanted.linear.x, 0.5);
  EXPECT_DOUBLE_EQ(state().wanted.angular.z, 1.0);
  ASSERT_TRUE(cycle_until([](const Host::Cycle& c) { return c.command.angular.z > 0.9; }));

  person().left = 0.0f;
  ASSERT_TRUE(reaches("HOLD"));
  EXPECT_DOUBLE_EQ(state().wanted.linear.x, 0.5);
  EXPECT_DOUBLE_EQ(state().wanted.angular.z, 0.0);
  EXPECT_TRUE(
      cycle_until([this](const Host::Cycle& c) { return c.command.angular.z == 0.0 && state().state_name == "HOLD"; }));
  EXPECT_TRUE(reaches("AUTONOMY"));
  EXPECT_FALSE(state().active);
}

TEST_F(Timeliness, AMessageCountsInTheNextCycle) {
  start();
  drive();
  person().sends = false;
  for (int i = 0; i < 20; ++i) {
    person().left = 0.4f + 0.02f * static_cast<float>(i);
    person().send();
    host().cycle();
    EXPECT_NEAR(state().wanted.angular.z, std::pow(static_cast<double>(person().left), 2), 1e-9) << i;
    for (int cycle = 0; cycle < 2; ++cycle) host().cycle();
  }
}

TEST_F(Timeliness, AfterACutLinkTurningEndsWithinTheTimeout) {
  set("delta", 5.0);
  start();
  drive();
  person().left = 1.0f;
  ASSERT_TRUE(cycle_until([](const Host::Cycle& c) { return c.command.angular.z > 0.95; }));
  person().sends = false;
  pass_cycles(0.1);  // one that was under way
  const ros::Time cut = ros::Time::now();
  person().send();
  bool turning = true;
  ASSERT_TRUE(cycle_until([&](const Host::Cycle& c) {  // it has come
    return turning = c.command.angular.z > 0.0, (state().header.stamp - cut).toSec() >= state().input_age;
  }));
  person().vanish();
  int cycles = 0;  // since it was lost
  cycle_until([&](const Host::Cycle& c) {
    turning = c.command.angular.z > 0.0;
    if (state().state_name == "LOST") ++cycles;
    return !turning;
  });
  EXPECT_EQ(state().state_name, "LOST");
  EXPECT_GT(state().input_age, kTimeout);
  EXPECT_FALSE(turning);
  EXPECT_LE(cycles, 7);  // 1 rad/s at 3.2 rad/s^2
  double last = 0.0;
  for (const OperatorState& state : person().states()) {
    if (state.wanted.angular.z != 0.0) last = (state.header.stamp - cut).toSec();
  }
  EXPECT_LE(last, kTimeout + kPeriod);
  EXPECT_GE(last, kTimeout - kPeriod);  // not earlier either: a late message is none that is lost
  EXPECT_TRUE(all_cycles([this](const Host::Cycle&) { return state().wanted.angular.z == 0.0; }, 1.0));
}

// The whole process stands still for a while, as on a machine that is too busy, and the person steers all the time.
TEST_F(Stick, APauseOfTheProcessIsNotHeldAgainstIt) {
  start();
  drive();
  person().left = 1.0f;
  ASSERT_TRUE(reaches("SHARED"));
  for (int i = 0; i < 3; ++i) {
    Stage::get().skip(0.9);
    // Odometry and transforms are old at first, so a cycle may brake or fail; that is not looked at here.
    pass_cycles(0.8);
    EXPECT_EQ(state().state_name, "SHARED");  // without having let go of the stick
  }
  for (const OperatorState& told : person().states()) EXPECT_NE(told.state_name, "LOST");
}

class ByTwist : public Operated {
 protected:
  void start_listening() {
    set("twist_topic", in_namespace("keys"));
    start();
  }
  /// Publishes `wanted` of now as a message of the type, once a period.
  template <typename Message>
  void start_with(Message (*message_of)(const geometry_msgs::Twist&)) {
    start_listening();
    publisher_ = node_.advertise<Message>(in_namespace("keys"), 1);
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
  EXPECT_TRUE(nobody_steers(0.4));
  expect_steered();
}

TEST_F(ByTwist, WithAHeader) {
  start_with(stamped);
  expect_steered();
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
  start_listening();
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

/// The hand's tracker, once a period, half a metre in front of the head and off to its left by `left_` [m]; its clutch
/// is the stick's button.
class Gesture : public Operated {
 protected:
  enum class Tracker { silent, topic, topic_lost, tf, tf_repeats };

  void start_gesture() {
    set("mode", "gesture");
    set("delta", 0.5);
    start();
    publisher_ = node_.advertise<geometry_msgs::PoseStamped>("hand_pose", 1);
    ticking_ = std::make_unique<Ticking>([this] { track(); });
    drive();
  }

  void track() {
    if (tracker_ == Tracker::tf || tracker_ == Tracker::tf_repeats) {
      geometry_msgs::TransformStamped hand;
      if (tracker_ == Tracker::tf) stamp_ = ros::Time::now();
      hand.header.stamp = stamp_;
      hand.header.frame_id = "head";
      hand.child_frame_id = "hand";
      hand.transform.translation.x = 0.5;
      hand.transform.translation.y = left_;
      hand.transform.rotation.w = 1.0;
      Stage::get().tf.setTransform(hand, "tracker", false);
    } else if (tracker_ != Tracker::silent) {
      geometry_msgs::PoseStamped hand;
      hand.header.stamp = ros::Time::now();
      hand.header.frame_id = "head";
      hand.pose.position.x = 0.5;
      hand.pose.position.y = left_;
      if (tracker_ == Tracker::topic) hand.pose.orientation.w = 1.0;
      deliver(publisher_, hand);
    }
  }

  /// Presses the clutch, which makes the hand's place of now the origin, and moves the hand.
  void steer(double left) {
    person().button = true;
    EXPECT_TRUE(nobody_steers(0.3));
    left_ = left;
    EXPECT_TRUE(reaches("SHARED"));
  }

  ros::NodeHandle node_;
  Tracker tracker_ = Tracker::topic;
  double left_ = 0.0;
  ros::Time stamp_;
  ros::Publisher publisher_;
  std::unique_ptr<Ticking> ticking_;
};

TEST_F(Gesture, TheHandSteersWhileTheClutchIsHeld) {
  start_gesture();
  left_ = 0.2;
  EXPECT_TRUE(nobody_steers(0.4));  // no clutch
  steer(0.35);                      // half of gesture_range to the left of 0.2 m: 0.5^2 of 1 rad/s
  EXPECT_EQ(state().mode, OperatorState::MODE_GESTURE);
  EXPECT_NEAR(state().wanted.angular.z, 0.25, 1e-6);
  EXPECT_DOUBLE_EQ(state().wanted.linear.x, 0.5);
  EXPECT_TRUE(cycle_until([](const Host::Cycle& c) { return std::abs(c.command.angular.z - 0.25) < 0.01; }));
  person().button = false;
  ASSERT_TRUE(reaches("HOLD"));
  EXPECT_DOUBLE_EQ(state().wanted.angular.z, 0.0);
  ASSERT_TRUE(reaches("AUTONOMY"));
  steer(0.2);  // anew: another origin
  EXPECT_NEAR(state().wanted.angular.z, -0.25, 1e-6);
  expect_within_limits();
}

TEST_F(Gesture, AHandInTfSteersAndItsSilenceIsALoss) {
  set("gesture_frame", "hand");
  set("gesture_parent_frame", "head");
  tracker_ = Tracker::tf;
  start_gesture();
  for (const Tracker silence : {Tracker::tf_repeats, Tracker::silent}) {
    left_ = 0.0;
    steer(0.3);
    EXPECT_NEAR(state().wanted.angular.z, 1.0, 1e-6);
    EXPECT_TRUE(all_cycles([this](const Host::Cycle&) { return state().state_name == "SHARED"; }, 0.7));
    tracker_ = silence;  // also where the same transform comes again and again
    ASSERT_TRUE(reaches("LOST"));
    EXPECT_DOUBLE_EQ(state().wanted.angular.z, 0.0);
    tracker_ = Tracker::tf;
    person().button = false;
    EXPECT_TRUE(reaches("AUTONOMY"));
    EXPECT_TRUE(nobody_steers(0.2));  // the release has come, too
  }
}

// Poses go on to come, and no timeout says so.
TEST_F(Gesture, AHandWithoutOrientationIsLostAtOnce) {
  start_gesture();
  steer(0.3);
  tracker_ = Tracker::topic_lost;
  ASSERT_TRUE(reaches("LOST", kTimeout - 0.1));
  EXPECT_DOUBLE_EQ(state().wanted.angular.z, 0.0);
  EXPECT_GT(state().dropped, 0u);
}

}  // namespace
}  // namespace hidwa_plugin_tests
