// SPDX-License-Identifier: BSD-3-Clause
// The person stops the robot: by a button, by the stick, in words.
#include <limits>

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
  void expect_stops() {
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
    EXPECT_TRUE(cycle_until([](const Host::Cycle& c) { return c.command.linear.x > 0.49; }));
    expect_within_limits();
  }
};

TEST_F(Stop, ByTheButton) {
  start_driving();
  person().second_button = true;
  expect_stops();
  person().left = 1.0f;  // steers nothing meanwhile
  EXPECT_TRUE(all_cycles(at_rest, 0.3));
  person().left = 0.0f;
  EXPECT_TRUE(all_cycles(at_rest, 0.2));
  person().second_button = false;
  expect_goes_on();
}

TEST_F(Stop, ByTheButtonOutOfATurn) {
  start_driving();
  person().left = 1.0f;
  ASSERT_TRUE(cycle_until([](const Host::Cycle& c) { return c.command.angular.z > 0.95; }));
  person().second_button = true;
  ASSERT_TRUE(reaches("STOPPED"));
  EXPECT_TRUE(cycle_until(at_rest));
  EXPECT_TRUE(all_cycles(at_rest, 0.3));
  expect_within_limits();
}

TEST_F(Stop, ByTheStickPulledBack) {
  start_driving();
  person().ahead = -0.7f;  // not as far as stop_pull
  EXPECT_TRUE(all_cycles([this](const Host::Cycle& c) { return c.success && state().state_name == "AUTONOMY"; }, 0.3));
  person().ahead = -1.0f;
  expect_stops();
  person().ahead = 0.0f;
  expect_goes_on();
}

// The message is dropped for its steering, not for its stop.
TEST_F(Stop, ByTheButtonOfAFaultyDevice) {
  start_driving();
  person().left = std::numeric_limits<float>::quiet_NaN();
  person().second_button = true;
  expect_stops();
  person().second_button = false;
  EXPECT_TRUE(all_cycles(at_rest, 0.3));  // faulty messages do not let go
  person().left = 0.0f;
  expect_goes_on();
}

TEST_F(Stop, OfADeviceThatDiedEndsInWords) {
  const LogListener log;
  start_driving();
  person().second_button = true;
  expect_stops();
  person().vanish();
  EXPECT_TRUE(all_cycles(at_rest, 1.1));
  ASSERT_TRUE(say<std_msgs::Bool>("stop", false));
  expect_goes_on();
  EXPECT_TRUE(wait_for([&] { return log.said("The stop of " + ros::this_node::getName()); }));
}

TEST_F(Stop, InWords) {
  start_driving();
  ASSERT_TRUE(say<std_msgs::Bool>("stop", true));
  expect_stops();
  ASSERT_TRUE(say<std_msgs::Bool>("stop", false));
  expect_goes_on();
}

TEST_F(Stop, HoldsWithoutAPlanToo) {
  start_driving();
  host().planner().setPlan({});
  ASSERT_TRUE(cycle_until([](const Host::Cycle& c) { return !c.success; }));  // at rest it fails, else
  person().second_button = true;
  ASSERT_TRUE(reaches("STOPPED"));
  EXPECT_TRUE(all_cycles(at_rest, 0.5));
}

TEST_F(Stop, BrakesWithoutAPlanToo) {
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

}  // namespace
}  // namespace hidwa_plugin_tests

int main(int argc, char** argv) {
  ros::init(argc, argv, "stop_test");
  ros::NodeHandle node;
  ::testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
