// SPDX-License-Identifier: BSD-3-Clause
// Mode switching over its real topics: control is taken and given back.
#include <cmath>

#include <std_msgs/Bool.h>

#include "person.hpp"

namespace hidwa_plugin_tests {
namespace {

constexpr double kRadius = 0.25;  // of the robot, as in costmap.yaml [m]

class Switching : public Operated {
 protected:
  void start_switching(const std::string& guard = "nearest") {
    set("mode", "switching");
    set("guard", guard);
    start();
    drive();
  }
};

TEST_F(Switching, TheButtonTakesControlAndGivesItBack) {
  start_switching();
  person().left = 1.0f;  // not in control
  EXPECT_TRUE(all_cycles([this](const Host::Cycle&) { return !state().active; }, 0.4));
  person().left = 0.0f;

  press();
  ASSERT_EQ(state().state_name, "MANUAL");
  EXPECT_EQ(state().mode, OperatorState::MODE_SWITCHING);
  // Nobody holds the stick: the robot stops, goal or not.
  ASSERT_TRUE(cycle_until(at_rest));
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
  EXPECT_TRUE(cycle_until([](const Host::Cycle& c) { return c.command.linear.x > 0.49; }));  // its goal is kept
  expect_within_limits();
}

TEST_F(Switching, TheTopicTakesControlAndGivesItBack) {
  start_switching();
  ASSERT_TRUE(say<std_msgs::Bool>("take_control", true));
  ASSERT_TRUE(reaches("MANUAL"));
  EXPECT_TRUE(cycle_until(at_rest));
  ASSERT_TRUE(say<std_msgs::Bool>("take_control", false));
  ASSERT_TRUE(reaches("AUTONOMY"));
  EXPECT_TRUE(cycle_until([](const Host::Cycle& c) { return c.command.linear.x > 0.49; }));
}

TEST_F(Switching, TheGuardKeepsThePersonOffTheWall) {
  start_switching();
  press();
  ASSERT_EQ(state().state_name, "MANUAL");
  Robot& robot = Stage::get().robot;
  robot.wall_ahead(1.8);
  person().ahead = 1.0f;
  ASSERT_TRUE(cycle_until([&](const Host::Cycle&) { return robot.room() < 0.8; }));  // it does go there
  for (const float side : {0.0f, 1.0f, -1.0f}) {
    person().left = side;
    EXPECT_TRUE(all_cycles([](const Host::Cycle& c) { return c.success; }, 1.5));
    EXPECT_EQ(state().state_name, "MANUAL");
  }
  EXPECT_GE(robot.room(), kRadius);
  expect_within_limits();
}

TEST_F(Switching, WithoutAGuardThePersonHitsTheWall) {
  start_switching("none");
  press();
  ASSERT_EQ(state().state_name, "MANUAL");
  Robot& robot = Stage::get().robot;
  person().ahead = 1.0f;
  ASSERT_TRUE(cycle_until([](const Host::Cycle& c) { return c.command.linear.x == 0.5; }));
  robot.wall_ahead(1.0);
  bool as_wanted = true;
  ASSERT_TRUE(cycle_until([&](const Host::Cycle& c) {
    as_wanted = as_wanted && c.success && c.command.linear.x == 0.5 && c.command.angular.z == 0.0;
    return robot.room() < kRadius;
  }));
  EXPECT_TRUE(as_wanted);
  expect_within_limits();
}

TEST_F(Switching, TheGoalIsNotReachedWhileThePersonIsInControl) {
  start_switching();
  press();
  ASSERT_EQ(state().state_name, "MANUAL");
  ASSERT_TRUE(cycle_until(at_rest));
  ASSERT_TRUE(host().plan_ahead(0.1));  // there already
  EXPECT_TRUE(all_cycles([this](const Host::Cycle& c) { return c.success && !host().planner().isGoalReached(); }, 0.7));
  press();
  ASSERT_EQ(state().state_name, "AUTONOMY");
  EXPECT_TRUE(cycle_until([this](const Host::Cycle&) { return host().planner().isGoalReached(); }));
}

}  // namespace
}  // namespace hidwa_plugin_tests

int main(int argc, char** argv) {
  ros::init(argc, argv, "switching_test");
  ros::NodeHandle node;
  ::testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
