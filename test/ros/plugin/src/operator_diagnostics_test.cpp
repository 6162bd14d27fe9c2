// SPDX-License-Identifier: BSD-3-Clause
// The person's device, and what moves, on /diagnostics, and what to do about it.
#include <diagnostic_msgs/DiagnosticArray.h>
#include <geometry_msgs/PoseStamped.h>
#include <std_msgs/Bool.h>
#include <topic_tools/shape_shifter.h>

#include "person.hpp"

namespace hidwa_plugin_tests {
namespace {

using diagnostic_msgs::DiagnosticStatus;

class OperatorDiagnostics : public Operated {
 protected:
  explicit OperatorDiagnostics(const std::string& part = "operator") {
    subscriber_ = node_.subscribe<diagnostic_msgs::DiagnosticArray>(
        "/diagnostics", 50, [this, part](const diagnostic_msgs::DiagnosticArray::ConstPtr& message) {
          const std::string name =
              std::string(": ") + ::testing::UnitTest::GetInstance()->current_test_info()->name() + " " + part;
          const std::lock_guard<std::mutex> lock(mutex_);
          for (const DiagnosticStatus& status : message->status) {
            if (status.name.size() < name.size()) continue;
            if (status.name.compare(status.name.size() - name.size(), name.size(), name) == 0) status_ = status;
          }
        });
  }
  DiagnosticStatus status() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return status_;
  }
  std::string value(const std::string& key) const {
    for (const auto& pair : status().values) {
      if (pair.key == key) return pair.value;
    }
    return "there is no " + key;
  }
  bool says(const std::string& part) const { return status().message.find(part) != std::string::npos; }
  std::string message() const { return status().message; }

  ros::NodeHandle node_;
  mutable std::mutex mutex_;
  DiagnosticStatus status_;
  ros::Subscriber subscriber_;
};

TEST_F(OperatorDiagnostics, TheDeviceIsDescribed) {
  start();
  drive();
  ASSERT_TRUE(cycle_until([this](const Host::Cycle&) { return std::atof(value("rate [Hz]").c_str()) > 0.0; }));
  EXPECT_EQ(status().level, DiagnosticStatus::OK);
  EXPECT_EQ(message(), "AUTONOMY");
  EXPECT_EQ(value("input"), "joy");
  EXPECT_EQ(value("device"), ros::this_node::getName());
  EXPECT_EQ(value("mode"), "joystick");
  EXPECT_EQ(value("state"), "AUTONOMY");
  EXPECT_EQ(value("messages dropped"), "0");
  const double age = std::atof(value("age of the last message [s]").c_str());
  EXPECT_GE(age, 0.0);
  EXPECT_LT(age, 0.5);

  person().left = 3.0f;  // no stick can
  ASSERT_TRUE(cycle_until([this](const Host::Cycle&) { return std::atoi(value("messages dropped").c_str()) > 0; }));
  EXPECT_EQ(status().level, DiagnosticStatus::WARN);
  EXPECT_TRUE(says("outside [-1, 1]")) << message();
}

TEST_F(OperatorDiagnostics, NothingCameYet) {
  set("joy_topic", "nobody_sends_here");
  start_unheard();
  drive();
  ASSERT_TRUE(cycle_until([this](const Host::Cycle&) { return value("input") == "nobody_sends_here"; }));
  EXPECT_EQ(message(), "nothing came on nobody_sends_here yet: start the device's node, or set mode off");
  EXPECT_EQ(status().level, DiagnosticStatus::OK);  // it drives all the same
  EXPECT_EQ(value("device"), "none yet");
  EXPECT_EQ(value("rate [Hz]"), "0");
  EXPECT_LT(std::atof(value("age of the last message [s]").c_str()), 0.0);
}

TEST_F(OperatorDiagnostics, AStopCountsWhereNobodySteersAndIsSaid) {
  set("mode", "off");
  start_unheard();
  drive();
  const std::string off = "off: nobody steers (parameter mode, or the topic set_mode)";
  ASSERT_TRUE(cycle_until([&](const Host::Cycle&) { return message() == off; })) << message();
  ASSERT_TRUE(say<std_msgs::Bool>("stop", true));
  EXPECT_TRUE(cycle_until([](const Host::Cycle& c) { return at_rest(c); }));
  EXPECT_TRUE(cycle_until([&](const Host::Cycle&) { return message() == "STOPPED; " + off; })) << message();
  ASSERT_TRUE(say<std_msgs::Bool>("stop", false));
  EXPECT_TRUE(cycle_until([&](const Host::Cycle& c) { return c.command.linear.x > 0.45 && message() == off; }))
      << message();
}

TEST_F(OperatorDiagnostics, AHandWithoutItsClutchIsExplained) {
  set("mode", "gesture");
  set("joy_topic", "nobody_sends_here");
  start_unheard();
  drive();
  ASSERT_TRUE(cycle_until([this](const Host::Cycle&) { return says("nothing came on hand_pose yet"); })) << message();
  ros::Publisher publisher = node_.advertise<geometry_msgs::PoseStamped>("hand_pose", 1);
  geometry_msgs::PoseStamped hand;
  hand.pose.position.x = hand.pose.orientation.w = 1.0;
  EXPECT_TRUE(cycle_until([&](const Host::Cycle&) {
    publisher.publish(hand);
    return says(
        "nothing came on nobody_sends_here yet: the hand steers only while the clutch, a button or axis there, is "
        "held");
  })) << message();
  EXPECT_EQ(value("input"), "hand_pose");
  EXPECT_EQ(value("device"), ros::this_node::getName());
}

TEST_F(OperatorDiagnostics, ALostLinkIsNamed) {
  start();
  drive();
  person().left = 1.0f;
  ASSERT_TRUE(reaches("SHARED"));
  person().sends = false;
  ASSERT_TRUE(reaches("LOST"));
  ASSERT_TRUE(cycle_until([this](const Host::Cycle&) { return says("fell silent"); }));
  EXPECT_EQ(status().level, DiagnosticStatus::ERROR);
  EXPECT_TRUE(says("joy fell silent while the operator steered: check the link to " + ros::this_node::getName()))
      << message();
  EXPECT_EQ(value("state"), "LOST");
  person().sends = true;
  person().left = 0.0f;
  EXPECT_TRUE(cycle_until([this](const Host::Cycle&) { return status().level != DiagnosticStatus::ERROR; }));
}

TEST_F(OperatorDiagnostics, AStickThatSendsOnlyChangesIsExplained) {
  set("input_timeout", 0.5);
  start();
  drive();
  person().sends = false;
  person().left = 0.6f;
  person().send();
  ASSERT_TRUE(reaches("LOST"));
  person().left = 0.0f;
  person().send();
  ASSERT_TRUE(reaches("AUTONOMY"));
  // What is wrong is said on, with both remedies, though nothing is lost at present.
  ASSERT_TRUE(cycle_until([this](const Host::Cycle&) {
    return status().level == DiagnosticStatus::WARN && says("sends only changes");
  })) << message();
  EXPECT_TRUE(says("autorepeat_rate to 20")) << message();
  EXPECT_TRUE(says("input_timeout to 0")) << message();
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
      return says(part);
    });
  }
  const std::string topic_ = in_namespace("people");
  ros::Publisher publisher_;
};

TEST_F(DetectorDiagnostics, PeopleAreHeard) {
  EXPECT_TRUE(says_of("people_msgs/People", "18722f4b8db20cc2369740732357847b", " is heard")) << message();
  EXPECT_EQ(value("moving obstacles"), "0");
}

TEST_F(DetectorDiagnostics, ObstacleArraysAreHeard) {
  EXPECT_TRUE(says_of("costmap_converter/ObstacleArrayMsg", "8a1bdcde72c65ca7d3ce8ebf52d43516", " is heard"))
      << message();
}

TEST_F(DetectorDiagnostics, AnotherTypeIsNamed) {
  EXPECT_TRUE(says_of("std_msgs/Header", "2176decaecbce78abc3b96ef049fabed", "std_msgs/Header came: send "))
      << message();
  EXPECT_EQ(status().level, DiagnosticStatus::WARN);
}

}  // namespace
}  // namespace hidwa_plugin_tests

int main(int argc, char** argv) {
  ros::init(argc, argv, "operator_diagnostics_test");
  ros::NodeHandle node;
  ::testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
