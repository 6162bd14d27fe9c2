// SPDX-License-Identifier: BSD-3-Clause
// The planner as a controller for a host that sends nothing of its own: not at the goal, not when it cancels.
#include <cmath>
#include <functional>
#include <string>

#include <gtest/gtest.h>
#include "ros/host/controller.hpp"

#include "stage.hpp"

namespace hidwa_plugin_tests {
namespace {

using hidwa_local_planner::Controller;
using hidwa_local_planner::ControllerOutcome;

constexpr double kStep = 2.5 * kPeriod + 1e-6;  // acc_lim_x by default x period [m/s]
constexpr double kWide = 3.0;                   // a heading tolerance that every heading meets [rad]

class ControllerTest : public ::testing::Test {
 protected:
  ControllerTest() {
    const std::string name =
        "Controller_" + std::string(::testing::UnitTest::GetInstance()->current_test_info()->name());
    Stage& stage = Stage::get();
    stage.clear();
    controller_.initialize(name, &stage.tf, stage.costmap.get());
  }

  /// As Move Base Flex has it: only what is a success is sent.
  ControllerOutcome cycle() {
    geometry_msgs::Twist command;
    const ControllerOutcome outcome = controller_.compute(command, message_);
    if (outcome == ControllerOutcome::success) {
      largest_change_ = std::max(largest_change_, std::abs(command.linear.x - sent_.linear.x));
      sent_ = command;
      Stage::get().robot.command(command);
    }
    Stage::get().pass(kPeriod);
    return outcome;
  }

  bool cycle_until(const std::function<bool(ControllerOutcome)>& done) {
    for (int i = 0; i < static_cast<int>(kPatience / kPeriod); ++i) {
      if (done(cycle())) return true;
    }
    return false;
  }

  bool comes_to(ControllerOutcome wanted) {
    return cycle_until([wanted](ControllerOutcome outcome) { return outcome == wanted; });
  }

  void drive_at_full_speed() {
    ASSERT_TRUE(controller_.set_plan(straight_plan(6.0)));
    ASSERT_TRUE(cycle_until([this](ControllerOutcome) { return sent_.linear.x > 0.45; })) << message_;
  }

  /// Cycles to the goal; what is left to it [m], negative where it is not reached.
  double arrive(double ahead, double xy) {
    const std::vector<geometry_msgs::PoseStamped> plan = straight_plan(ahead);
    EXPECT_TRUE(controller_.set_plan(plan));
    for (int i = 0; i < 400 && !controller_.goal_reached(xy, kWide); ++i) {
      EXPECT_EQ(cycle(), ControllerOutcome::success) << message_;
    }
    if (!controller_.goal_reached(xy, kWide)) return -1.0;
    const Pose pose = Stage::get().robot.pose();
    return std::hypot(plan.back().pose.position.x - pose.x, plan.back().pose.position.y - pose.y);
  }

  void expect_rest() const {
    EXPECT_EQ(sent_.linear.x, 0.0);
    EXPECT_EQ(sent_.angular.z, 0.0);
    EXPECT_LE(largest_change_, kStep);
  }

  Controller controller_;
  geometry_msgs::Twist sent_;
  double largest_change_ = 0.0;  // from one sent command to the next [m/s]
  std::string message_;
};

TEST_F(ControllerTest, CancelledItBrakesToRestAndThenSaysSo) {
  drive_at_full_speed();
  controller_.cancel();
  int brakes = 0;
  EXPECT_TRUE(cycle_until([&](ControllerOutcome outcome) {
    brakes += outcome == ControllerOutcome::success && sent_.linear.x > 0.0 ? 1 : 0;
    return outcome == ControllerOutcome::canceled;
  })) << message_;
  EXPECT_EQ(message_, "canceled: the robot stands");
  // From 0.45 m/s or more by 0.125 m/s a cycle: at least three commands on the way.
  EXPECT_GE(brakes, 3);
  expect_rest();
  drive_at_full_speed();  // what comes next is driven
  controller_.cancel();
  EXPECT_TRUE(comes_to(ControllerOutcome::canceled));
}

TEST_F(ControllerTest, APlanWhileItBrakesDoesNotMakeItDriveOn) {
  drive_at_full_speed();
  controller_.cancel();
  ASSERT_TRUE(controller_.set_plan(straight_plan(5.0)));
  EXPECT_TRUE(comes_to(ControllerOutcome::canceled)) << message_;
  expect_rest();
}

// The planner's own tolerance is 0.25 m.
TEST_F(ControllerTest, ArrivesAtRestWithinANarrowToleranceOfTheHost) {
  const double left = arrive(2.0, 0.1);
  EXPECT_GE(left, 0.0) << message_;
  EXPECT_LE(left, 0.1);
  expect_rest();
}

TEST_F(ControllerTest, AWiderToleranceEndsEarlier) {
  const double left = arrive(2.0, 0.6);
  EXPECT_GT(left, 0.3) << message_;
  EXPECT_LE(left, 0.6);
  expect_rest();
}

TEST_F(ControllerTest, APlanThatCannotBeUsedIsToldOfByTheCycle) {
  EXPECT_TRUE(controller_.set_plan({}));
  EXPECT_TRUE(comes_to(ControllerOutcome::invalid_path)) << message_;
  EXPECT_NE(message_.find("empty"), std::string::npos) << message_;
}

}  // namespace
}  // namespace hidwa_plugin_tests
