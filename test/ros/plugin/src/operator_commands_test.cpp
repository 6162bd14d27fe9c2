// SPDX-License-Identifier: BSD-3-Clause
// The mode by its topic: it counts at once, whoever looks sees it, and what is no mode changes nothing.
#include <dynamic_reconfigure/Config.h>
#include <std_msgs/String.h>

#include "change.hpp"
#include "person.hpp"

namespace hidwa_plugin_tests {
namespace {

/// The newest message of a topic, of those that came after it was made.
template <typename Message>
class Newest {
 public:
  explicit Newest(const std::string& topic) {
    subscriber_ = node_.subscribe<Message>(topic, 10, [this](const typename Message::ConstPtr& message) {
      const std::lock_guard<std::mutex> lock(mutex_);
      message_ = message;
    });
  }
  typename Message::ConstPtr get() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return message_;
  }

 private:
  ros::NodeHandle node_;
  mutable std::mutex mutex_;
  typename Message::ConstPtr message_;
  ros::Subscriber subscriber_;
};

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
    const Newest<std_msgs::String> shown(in_namespace("mode"));
    return wait_for([&] { return shown.get() && shown.get()->data == mode; });
  }
  bool clients_see(const std::string& mode) {
    const Newest<dynamic_reconfigure::Config> config(in_namespace("parameter_updates"));
    return wait_for([&] { return config.get() && mode_in(*config.get()) == mode; });
  }
  std::string stored_mode() const {
    std::string mode;
    ros::param::get(in_namespace("mode"), mode);
    return mode;
  }
};

TEST_F(Commands, SetModeSwitchesWhileItDrives) {
  start();
  drive();
  EXPECT_EQ(state().mode_name, "joystick");
  EXPECT_EQ(state().mode, OperatorState::MODE_JOYSTICK);
  EXPECT_TRUE(late_subscriber_reads("joystick"));
  const Newest<dynamic_reconfigure::Config> updates(in_namespace("parameter_updates"));
  const Newest<std_msgs::String> shown(in_namespace("mode"));

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
    EXPECT_TRUE(wait_for([&] { return updates.get() && mode_in(*updates.get()) == mode; })) << mode;
    EXPECT_TRUE(wait_for([&] { return shown.get() && shown.get()->data == mode; })) << mode;
    EXPECT_TRUE(late_subscriber_reads(mode));
    EXPECT_TRUE(clients_see(mode));
    EXPECT_EQ(stored_mode(), mode);
  }
  // And the mode that was set is the one that counts.
  ASSERT_TRUE(all_cycles([](const Host::Cycle& c) { return c.success; }, 0.3));
  person().left = 1.0f;
  EXPECT_TRUE(reaches("SHARED"));
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
    const int before = log.times("set_mode: ");
    ASSERT_TRUE(say_mode(wrong));
    EXPECT_TRUE(cycle_until([&](const Host::Cycle&) { return log.times("set_mode: ") > before; })) << wrong;
    EXPECT_TRUE(all_cycles(
        [this](const Host::Cycle& c) {
          return c.success && state().mode_name == "switching" && state().state_name == "MANUAL";
        },
        0.3))
        << wrong;
    EXPECT_TRUE(late_subscriber_reads("switching"));
    EXPECT_TRUE(clients_see("switching"));
    EXPECT_EQ(stored_mode(), "switching");
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
  // The stick steers as before.
  ASSERT_TRUE(all_cycles([](const Host::Cycle& c) { return c.success; }, 0.3));
  person().left = 1.0f;
  EXPECT_TRUE(reaches("SHARED"));
}

}  // namespace
}  // namespace hidwa_plugin_tests

int main(int argc, char** argv) {
  ros::init(argc, argv, "operator_commands_test");
  ros::NodeHandle node;
  ::testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
