// SPDX-License-Identifier: BSD-3-Clause
// What the planner does while something it needs is missing: brakes within its limits while it moves, fails
// at rest, and goes on as new when it returns.
#include <cmath>

#include <gtest/gtest.h>

#include "stage.hpp"

namespace hidwa_plugin_tests {
namespace {

// The defaults of acc_lim_x and acc_lim_theta x period [m/s, rad/s].
constexpr double kStep = 2.5 * kPeriod + 1e-6;
constexpr double kTurnStep = 3.2 * kPeriod + 1e-6;

class MissingInput : public ::testing::Test {
 protected:
  MissingInput() : host_("Planner_" + std::string(::testing::UnitTest::GetInstance()->current_test_info()->name())) {
    Robot& robot = Stage::get().robot;
    robot.odometry = robot.laser = robot.base_transform = robot.map_transform = true;
  }

  void drive(const std::string& frame = "odom") {
    ASSERT_TRUE(host_.plan_ahead(6.0, frame));
    const auto fast = [this](const Host::Cycle& c) {
      last_ = c.command;
      return c.success && last_.linear.x > 0.45;
    };
    ASSERT_TRUE(host_.cycle_until(fast)) << host_.report().fault;
  }

  /// From the moment that something is missing: braking commands that succeed, then failure with `reason` in
  /// words.
  void expect_braking_then_failure(const std::string& reason) {
    int brakes = 0;
    const bool failed = host_.cycle_until([&](const Host::Cycle& c) {
      EXPECT_LE(std::abs(c.command.linear.x - last_.linear.x), kStep * c.late);
      EXPECT_LE(std::abs(c.command.angular.z - last_.angular.z), kTurnStep * c.late);
      last_ = c.command;
      const bool braking = c.success && host_.report().outcome == hidwa_local_planner::Cycle::BRAKE;
      brakes += braking ? 1 : 0;
      return !c.success;
    });
    EXPECT_TRUE(failed);
    // From 0.45 m/s or more by 0.125 m/s a cycle, or 0.6 rad/s by 0.16: at least three braking commands on the way.
    EXPECT_GE(brakes, 3);
    EXPECT_EQ(last_.linear.x, 0.0);
    EXPECT_EQ(last_.angular.z, 0.0);
    EXPECT_NE(host_.report().fault.find(reason), std::string::npos) << host_.report().fault;
  }

  void expect_driving_again() {
    EXPECT_TRUE(host_.cycle_until([](const Host::Cycle& c) { return c.success && c.command.linear.x > 0.2; }))
        << host_.report().fault;
  }

  Host host_;
  geometry_msgs::Twist last_;  // command
};

TEST_F(MissingInput, NoPlanYet) {
  // Without odometry, which may come a little later too, standing still counts as braking for 0.25 s.
  const auto failed = [this](const Host::Cycle& c) {
    EXPECT_EQ(c.command.linear.x, 0.0);
    return !c.success && host_.report().fault.find("plan") != std::string::npos;
  };
  EXPECT_TRUE(host_.cycle_until(failed)) << host_.report().fault;
  drive();
}

TEST_F(MissingInput, EmptyPlan) {
  drive();
  EXPECT_TRUE(host_.planner().setPlan({}));
  expect_braking_then_failure("plan is empty");
  ASSERT_TRUE(host_.plan_ahead(3.0));
  expect_driving_again();
}

TEST_F(MissingInput, PlanInAFrameThatNobodyKnows) {
  drive();
  ASSERT_TRUE(host_.plan_ahead(3.0, "nowhere"));
  expect_braking_then_failure("nowhere");
  ASSERT_TRUE(host_.plan_ahead(3.0));
  expect_driving_again();
}

TEST_F(MissingInput, TransformOfThePlanGrowsOld) {
  drive("map");
  Stage::get().robot.map_transform = false;
  expect_braking_then_failure("the transform from the plan's frame map to odom is ");
  Stage::get().robot.map_transform = true;
  expect_driving_again();
}

TEST_F(MissingInput, PoseOfTheRobot) {
  drive();
  Stage::get().robot.base_transform = false;
  expect_braking_then_failure("pose");
  Stage::get().robot.base_transform = true;
  expect_driving_again();
}

TEST_F(MissingInput, Odometry) {
  drive();
  Stage::get().robot.odometry = false;
  expect_braking_then_failure("s old (odom_timeout 0.50 s)");
  // Who begins now has never heard of any.
  Host other("Planner_Odometry_Never");
  ASSERT_TRUE(other.plan_ahead(3.0));
  const auto failed = [&other](const Host::Cycle& c) {
    EXPECT_EQ(c.command.linear.x, 0.0);
    return !c.success && other.report().fault.find("no odometry on /odom yet: check odom_topic") != std::string::npos;
  };
  EXPECT_TRUE(other.cycle_until(failed)) << other.report().fault;
  Stage::get().robot.odometry = true;
  expect_driving_again();
}

// The age of the odometry is another figure in each cycle: the line is the same.
TEST_F(MissingInput, TheLogSaysSoOnceASecond) {
  drive();
  const LogListener log;
  const std::string line = "s old (odom_timeout 0.50 s)";
  const ros::Time begin = ros::Time::now();
  Stage::get().robot.odometry = false;
  host_.cycle_until([&begin](const Host::Cycle&) { return ros::Time::now() - begin > ros::Duration(3.0); });
  EXPECT_TRUE(wait_for([&] { return log.times(line) >= 2; }));
  EXPECT_LE(log.times(line), 1 + (ros::Time::now() - begin).toSec());
  Stage::get().robot.odometry = true;
  expect_driving_again();
  EXPECT_TRUE(wait_for([&log] { return log.said(": driving again"); }));
}

TEST_F(MissingInput, WhileItTurns) {
  ASSERT_TRUE(host_.planner().setPlan(straight_plan(6.0, "odom", 1.5)));
  const auto turns = [this](const Host::Cycle& c) {
    last_ = c.command;
    return c.success && last_.angular.z > 0.6;
  };
  ASSERT_TRUE(host_.cycle_until(turns)) << host_.report().fault;
  EXPECT_TRUE(host_.planner().setPlan({}));
  expect_braking_then_failure("plan is empty");
  ASSERT_TRUE(host_.plan_ahead(3.0));
  expect_driving_again();
}

TEST_F(MissingInput, CostmapThatIsNotCurrent) {
  drive();
  Stage::get().robot.laser = false;
  expect_braking_then_failure("costmap is not current");
  Stage::get().robot.laser = true;
  ASSERT_TRUE(Stage::get().pass_until([] { return Stage::get().costmap->isCurrent(); }));
  expect_driving_again();
}

geometry_msgs::Point point(double x, double y) {
  geometry_msgs::Point p;
  p.x = x;
  p.y = y;
  return p;
}

TEST_F(MissingInput, AFootprintThatIsNoRobots) {
  drive();
  costmap_2d::Costmap2DROS& costmap = *Stage::get().costmap;
  const std::vector<geometry_msgs::Point> robots = costmap.getUnpaddedRobotFootprint();
  costmap.setUnpaddedRobotFootprint(
      {point(100.0, 100.0), point(-100.0, 100.0), point(-100.0, -100.0), point(100.0, -100.0)});
  expect_braking_then_failure("more than 20 m");
  costmap.setUnpaddedRobotFootprint(robots);
  expect_driving_again();
}

}  // namespace
}  // namespace hidwa_plugin_tests

int main(int argc, char** argv) {
  ros::init(argc, argv, "missing_input_test");
  ros::NodeHandle node;
  ::testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
