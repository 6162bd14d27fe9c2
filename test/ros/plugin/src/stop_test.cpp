// SPDX-License-Identifier: BSD-3-Clause
// The operator stops the robot, or takes control of it and gives it back: by a button, or in words.
#include <cmath>

#include <std_msgs/Bool.h>

#include "person.hpp"

namespace hidwa_plugin_tests {
namespace {

class Stop : public Operated {
 protected:
  void start_driving() {
    set("stop_button", 1);
    set("delta", 0.5);
    start();
    drive();
  }
  void stop_by_the_button() {
    person().second_button = true;
    ASSERT_TRUE(reaches("STOPPED"));
    int cycles = 0;
    bool success = true;
    EXPECT_TRUE(
        cycle_until([&](const Host::Cycle& c) { return ++cycles, success = success && c.success, at_rest(c); }));
    EXPECT_TRUE(success);
    EXPECT_LE(cycles, 5);  // 0.5 m/s at 2.5 m/s^2 are four periods
    EXPECT_TRUE(all_cycles(at_rest, 0.6));
    EXPECT_EQ(state().state_name, "STOPPED");
    EXPECT_FALSE(host().planner().isGoalReached());
  }
  /// The goal survived.
  void expect_goes_on() {
    EXPECT_TRUE(reaches("AUTONOMY"));
    EXPECT_TRUE(host().drives(0.49));
    expect_within_limits();
  }
};

TEST_F(Stop, ByTheButton) {
  start_driving();
  stop_by_the_button();
  person().left = 1.0f;  // steers nothing meanwhile
  EXPECT_TRUE(all_cycles(at_rest, 0.3));
  person().left = 0.0f;
  EXPECT_TRUE(all_cycles(at_rest, 0.2));
  person().second_button = false;
  expect_goes_on();
}

TEST_F(Stop, OfADeviceThatDiedEndsInWords) {
  const LogListener log;
  start_driving();
  stop_by_the_button();
  person().vanish();
  EXPECT_TRUE(all_cycles(at_rest, 1.1));
  ASSERT_TRUE(say<std_msgs::Bool>("stop", false));
  expect_goes_on();
  EXPECT_TRUE(wait_for([&] { return log.said("The stop of " + ros::this_node::getName()); }));
}

TEST_F(Stop, BrakesAndHoldsWithoutAPlanToo) {
  start_driving();
  host().planner().setPlan({});
  person().second_button = true;
  bool success = true;
  EXPECT_TRUE(cycle_until([&](const Host::Cycle& c) { return success = success && c.success, at_rest(c); }));
  // The button may have come a cycle after the robot stood.
  ASSERT_TRUE(reaches("STOPPED"));
  EXPECT_TRUE(success);
  EXPECT_TRUE(all_cycles(at_rest, 0.3));
  expect_within_limits();
}

class Switching : public Operated {
 protected:
  void start_switching() {
    set("mode", "switching");
    start();
    drive();
  }
  /// At rest, since nobody moves the stick.
  void take_control_by_the_button() {
    press();
    ASSERT_EQ(state().state_name, "MANUAL");
    ASSERT_TRUE(cycle_until(at_rest));
  }
};

TEST_F(Switching, TheButtonTakesControlAndGivesItBack) {
  start_switching();
  person().left = 1.0f;  // not in control
  EXPECT_TRUE(nobody_steers(0.4));
  person().left = 0.0f;

  take_control_by_the_button();
  EXPECT_EQ(state().mode, OperatorState::MODE_SWITCHING);
  EXPECT_TRUE(all_cycles(at_rest, 0.5));
  person().ahead = 0.8f;  // 0.8^2 of 0.5 m/s
  person().left = -0.5f;  // 0.5^2 of 1 rad/s
  EXPECT_TRUE(cycle_until([](const Host::Cycle& c) {
    return std::abs(c.command.linear.x - 0.32) < 1e-6 && std::abs(c.command.angular.z + 0.25) < 1e-6;
  }));
  EXPECT_EQ(state().state_name, "MANUAL");
  person().ahead = person().left = 0.0f;
  ASSERT_TRUE(cycle_until(at_rest));

  press();
  EXPECT_EQ(state().state_name, "AUTONOMY");
  EXPECT_TRUE(host().drives(0.49));  // its goal is kept
  expect_within_limits();
}

TEST_F(Switching, TheTopicTakesControlAndGivesItBack) {
  start_switching();
  ASSERT_TRUE(say<std_msgs::Bool>("take_control", true));
  ASSERT_TRUE(reaches("MANUAL"));
  EXPECT_TRUE(cycle_until(at_rest));
  ASSERT_TRUE(say<std_msgs::Bool>("take_control", false));
  ASSERT_TRUE(reaches("AUTONOMY"));
  EXPECT_TRUE(host().drives(0.49));
}

TEST_F(Switching, TheGoalIsNotReachedWhileThePersonIsInControl) {
  start_switching();
  take_control_by_the_button();
  ASSERT_TRUE(host().plan_ahead(0.1));  // there already
  EXPECT_TRUE(all_cycles([this](const Host::Cycle& c) { return c.success && !host().planner().isGoalReached(); }, 0.7));
  press();
  ASSERT_EQ(state().state_name, "AUTONOMY");
  EXPECT_TRUE(cycle_until([this](const Host::Cycle&) { return host().planner().isGoalReached(); }));
}

}  // namespace
}  // namespace hidwa_plugin_tests
