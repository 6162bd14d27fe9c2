// SPDX-License-Identifier: BSD-3-Clause
// The mode by its topic: it counts at once, whoever looks sees it, and what is no mode changes nothing.
#include <dynamic_reconfigure/Config.h>
#include <std_msgs/String.h>

#include "change.hpp"
#include "person.hpp"

namespace hidwa_plugin_tests {
namespace {

std::string mode_in(const dynamic_reconfigure::Config& config) {
  for (const auto& parameter : config.strs) {
    if (parameter.name == "mode") return parameter.value;
  }
  return "";
}

class Commands : public Operated {
 protected:
  bool say_mode(const std::string& mode) { return say<std_msgs::String>("set_mode", mode); }
  /// What a client that subscribes now is told.
  bool late_subscriber_reads(const std::string& mode) {
    const Messages<std_msgs::String> shown(in_namespace("mode"));
    return wait_for([&] { return shown.newest().data == mode; });
  }
  /// That client, one of dynamic_reconfigure, and the parameter server.
  void expect_everywhere(const std::string& mode) {
    EXPECT_TRUE(late_subscriber_reads(mode)) << mode;
    const Messages<dynamic_reconfigure::Config> config(in_namespace("parameter_updates"));
    EXPECT_TRUE(wait_for([&] { return mode_in(config.newest()) == mode; })) << mode;
    EXPECT_EQ(ros::param::param<std::string>(in_namespace("mode"), ""), mode);
  }
  /// The robot drives, and the stick steers it.
  void expect_the_stick_steers() {
    ASSERT_TRUE(all_cycles([](const Host::Cycle& c) { return c.success; }, 0.3));
    person().left = 1.0f;
    EXPECT_TRUE(reaches("SHARED"));
  }
};

TEST_F(Commands, SetModeSwitchesWhileItDrives) {
  start();
  drive();
  EXPECT_EQ(state().mode_name, "joystick");
  EXPECT_EQ(state().mode, OperatorState::MODE_JOYSTICK);
  EXPECT_TRUE(late_subscriber_reads("joystick"));
  const Messages<dynamic_reconfigure::Config> updates(in_namespace("parameter_updates"));
  const Messages<std_msgs::String> shown(in_namespace("mode"));

  person().left = 1.0f;
  ASSERT_TRUE(reaches("SHARED"));
  ASSERT_TRUE(say_mode("off"));
  ASSERT_TRUE(reaches("AUTONOMY"));  // nobody steers any more, though the stick is where it was
  EXPECT_EQ(state().mode_name, "off");
  EXPECT_EQ(state().mode, OperatorState::MODE_OFF);
  person().left = 0.0f;

  for (const char* mode : {"switching", "gesture", "joystick"}) {
    ASSERT_TRUE(say_mode(mode));
    EXPECT_TRUE(cycle_until([&](const Host::Cycle& c) { return c.success && state().mode_name == mode; })) << mode;
    EXPECT_TRUE(wait_for([&] { return mode_in(updates.newest()) == mode && shown.newest().data == mode; })) << mode;
    expect_everywhere(mode);
  }
  expect_the_stick_steers();  // the mode that was set is the one that counts
}

TEST_F(Commands, TheModeIsToldWhileNoCyclesRun) {
  start();
  ASSERT_TRUE(late_subscriber_reads("joystick"));
  ASSERT_TRUE(say_mode("switching"));
  EXPECT_TRUE(late_subscriber_reads("switching"));
  // Set in another way it is told likewise.
  ASSERT_TRUE(Change().set("mode", "gesture").send(host()));
  EXPECT_TRUE(late_subscriber_reads("gesture"));
}

TEST_F(Commands, WhatIsNoModeIsRefused) {
  const LogListener log;
  set("mode", "switching");
  start();
  drive();
  press();
  ASSERT_EQ(state().state_name, "MANUAL");
  for (const char* wrong : {"sideways", "", "Joystick"}) {
    SCOPED_TRACE(wrong);
    const int before = log.times("set_mode: ");
    ASSERT_TRUE(say_mode(wrong));
    EXPECT_TRUE(cycle_until([&](const Host::Cycle&) { return log.times("set_mode: ") > before; }));
    EXPECT_TRUE(all_cycles(
        [this](const Host::Cycle& c) {
          return c.success && state().mode_name == "switching" && state().state_name == "MANUAL";
        },
        0.3));
    expect_everywhere("switching");
  }
}

// The hand's topic is no topic, or one that somebody in this node reads as something else: said, never thrown.
TEST_F(Commands, AModeWhoseTopicCannotBeHadIsRefused) {
  const LogListener log;
  start();
  drive();
  for (const auto& [topic, why] :
       {std::pair<std::string, std::string>{"a hand", "gesture_topic = a hand is no name of a topic"},
        {"joy", "joy_topic and gesture_topic are both joy"},
        {"scan", "a topic cannot be listened to"}}) {
    Change change;
    ASSERT_TRUE(change.set("gesture_topic", topic).set("mode", "gesture").send(host()));
    EXPECT_EQ(change.text("mode"), "joystick") << topic;
    EXPECT_TRUE(cycle_until([&](const Host::Cycle& c) { return c.success && log.said(why); })) << topic;
    EXPECT_TRUE(late_subscriber_reads("joystick"));
  }
  // What listens to the scan is there for mode gesture alone: valid, until that mode is asked for in words.
  ASSERT_TRUE(Change().set("gesture_topic", "scan").send(host()));
  ASSERT_TRUE(say_mode("gesture"));
  EXPECT_TRUE(cycle_until([&](const Host::Cycle&) { return log.said("set_mode: a topic cannot be listened to"); }));
  EXPECT_TRUE(late_subscriber_reads("joystick"));
  expect_the_stick_steers();
}

}  // namespace
}  // namespace hidwa_plugin_tests
