// SPDX-License-Identifier: BSD-3-Clause
// The person's device, and what moves, on /diagnostics, and what to do about it.
#include <geometry_msgs/PoseStamped.h>
#include <std_msgs/Bool.h>
#include <topic_tools/shape_shifter.h>

#include "person.hpp"

namespace hidwa_plugin_tests {
namespace {

using diagnostic_msgs::DiagnosticStatus;

std::string test_name() { return ::testing::UnitTest::GetInstance()->current_test_info()->name(); }

class OperatorDiagnostics : public Operated {
 protected:
  explicit OperatorDiagnostics(const std::string& part = "operator") : diagnosis_(test_name() + " " + part) {}
  bool comes_to_say(const std::string& words) {
    return cycle_until([&](const Host::Cycle&) { return diagnosis_.says(words); });
  }
  void start_with_nobody_at_the_stick() {
    set("joy_topic", "nobody_sends_here");
    start_unheard();
    drive();
  }

  ros::NodeHandle node_;
  const Diagnosis diagnosis_;
};

TEST_F(OperatorDiagnostics, TheDeviceIsDescribed) {
  start();
  drive();
  ASSERT_TRUE(cycle_until([this](const Host::Cycle&) { return diagnosis_.number("rate [Hz]") > 0.0; }));
  EXPECT_EQ(diagnosis_.level(), DiagnosticStatus::OK);
  EXPECT_EQ(diagnosis_.message(), "AUTONOMY");
  EXPECT_EQ(diagnosis_.value("input"), "joy");
  EXPECT_EQ(diagnosis_.value("device"), ros::this_node::getName());
  EXPECT_EQ(diagnosis_.value("mode"), "joystick");
  EXPECT_EQ(diagnosis_.value("state"), "AUTONOMY");
  EXPECT_EQ(diagnosis_.value("messages dropped"), "0");
  EXPECT_GE(diagnosis_.number("age of the last message [s]"), 0.0);
  EXPECT_LT(diagnosis_.number("age of the last message [s]"), 0.5);

  person().left = 3.0f;  // no stick can
  ASSERT_TRUE(cycle_until([this](const Host::Cycle&) { return diagnosis_.number("messages dropped") > 0.0; }));
  EXPECT_EQ(diagnosis_.level(), DiagnosticStatus::WARN);
  EXPECT_TRUE(diagnosis_.says("outside [-1, 1]")) << diagnosis_.message();
}

TEST_F(OperatorDiagnostics, NothingCameYet) {
  start_with_nobody_at_the_stick();
  ASSERT_TRUE(cycle_until([this](const Host::Cycle&) { return diagnosis_.value("input") == "nobody_sends_here"; }));
  EXPECT_EQ(diagnosis_.message(), "nothing came on nobody_sends_here yet: start the device's node, or set mode off");
  EXPECT_EQ(diagnosis_.level(), DiagnosticStatus::OK);  // it drives all the same
  EXPECT_EQ(diagnosis_.value("device"), "none yet");
  EXPECT_EQ(diagnosis_.value("rate [Hz]"), "0");
  EXPECT_LT(diagnosis_.number("age of the last message [s]"), 0.0);
}

TEST_F(OperatorDiagnostics, AStopCountsWhereNobodySteersAndIsSaid) {
  set("mode", "off");
  start_unheard();
  drive();
  const std::string off = "off: nobody steers (parameter mode, or the topic set_mode)";
  const auto is_said = [this](const std::string& message) {
    return cycle_until([&](const Host::Cycle&) { return diagnosis_.message() == message; });
  };
  ASSERT_TRUE(is_said(off)) << diagnosis_.message();
  ASSERT_TRUE(say<std_msgs::Bool>("stop", true));
  EXPECT_TRUE(cycle_until(at_rest));
  EXPECT_TRUE(is_said("STOPPED; " + off)) << diagnosis_.message();
  ASSERT_TRUE(say<std_msgs::Bool>("stop", false));
  EXPECT_TRUE(host().drives(0.45));
  EXPECT_TRUE(is_said(off)) << diagnosis_.message();
}

TEST_F(OperatorDiagnostics, AHandWithoutItsClutchIsExplained) {
  set("mode", "gesture");
  start_with_nobody_at_the_stick();
  ASSERT_TRUE(comes_to_say("nothing came on hand_pose yet")) << diagnosis_.message();
  ros::Publisher publisher = node_.advertise<geometry_msgs::PoseStamped>("hand_pose", 1);
  geometry_msgs::PoseStamped hand;
  hand.pose.position.x = hand.pose.orientation.w = 1.0;
  EXPECT_TRUE(cycle_until([&](const Host::Cycle&) {
    publisher.publish(hand);
    return diagnosis_.says(
        "nothing came on nobody_sends_here yet: the hand steers only while the clutch, a button or axis there, is "
        "held");
  })) << diagnosis_.message();
  EXPECT_EQ(diagnosis_.value("input"), "hand_pose");
  EXPECT_EQ(diagnosis_.value("device"), ros::this_node::getName());
}

TEST_F(OperatorDiagnostics, ALostLinkIsNamed) {
  start();
  drive();
  person().left = 1.0f;
  ASSERT_TRUE(reaches("SHARED"));
  person().sends = false;
  ASSERT_TRUE(reaches("LOST"));
  EXPECT_TRUE(
      comes_to_say("joy fell silent while the operator steered: check the link to " + ros::this_node::getName()))
      << diagnosis_.message();
  EXPECT_EQ(diagnosis_.level(), DiagnosticStatus::ERROR);
  EXPECT_EQ(diagnosis_.value("state"), "LOST");
  person().sends = true;
  person().left = 0.0f;
  EXPECT_TRUE(cycle_until([this](const Host::Cycle&) { return diagnosis_.level() != DiagnosticStatus::ERROR; }));
}

// A message of a type whose package is not needed: this header, and a list of nobody.
topic_tools::ShapeShifter nobody(const std::string& type, const std::string& md5) {
  std_msgs::Header header;
  header.stamp = ros::Time::now();
  header.frame_id = "odom";
  std::vector<std::uint8_t> bytes(ros::serialization::serializationLength(header) + 4U, 0);
  const auto size = static_cast<std::uint32_t>(bytes.size());
  ros::serialization::OStream out(bytes.data(), size);
  out.next(header);
  topic_tools::ShapeShifter message;
  message.morph(md5, type, "Header header", "");
  ros::serialization::IStream in(bytes.data(), size);
  message.read(in);
  return message;
}

class DetectorDiagnostics : public OperatorDiagnostics {
 protected:
  DetectorDiagnostics() : OperatorDiagnostics("moving obstacles") {}
  /// Whether a detector that sends this type leads to these words.
  bool says_of(const std::string& type, const std::string& md5, const std::string& part) {
    set("moving_obstacles_topic", topic_);
    start();
    drive();
    publisher_ = nobody(type, md5).advertise(node_, topic_, 1);
    return cycle_until([&](const Host::Cycle&) {
      publisher_.publish(nobody(type, md5));
      return diagnosis_.says(part);
    });
  }
  const std::string topic_ = in_namespace("people");
  ros::Publisher publisher_;
};

TEST_F(DetectorDiagnostics, PeopleAreHeard) {
  EXPECT_TRUE(says_of("people_msgs/People", "18722f4b8db20cc2369740732357847b", " is heard")) << diagnosis_.message();
  EXPECT_EQ(diagnosis_.value("moving obstacles"), "0");
}

TEST_F(DetectorDiagnostics, AnotherTypeIsNamed) {
  EXPECT_TRUE(says_of("std_msgs/Header", "2176decaecbce78abc3b96ef049fabed", "std_msgs/Header came: send "))
      << diagnosis_.message();
  EXPECT_EQ(diagnosis_.level(), DiagnosticStatus::WARN);
}

}  // namespace
}  // namespace hidwa_plugin_tests
