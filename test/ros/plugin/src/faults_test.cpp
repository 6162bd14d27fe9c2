// SPDX-License-Identifier: BSD-3-Clause
// Something that the planner needs is missing, or what another program gives it is wrong: every command stays finite,
// within the limits and the accelerations. The planner brakes while the robot moves, fails at rest, says why, and
// drives on when the fault is over.
#include <algorithm>
#include <atomic>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>
#include <nav_msgs/Odometry.h>
#include <sensor_msgs/Joy.h>

#include "change.hpp"
#include "stage.hpp"

namespace hidwa_plugin_tests {
namespace {

// The defaults.
constexpr double kMaxVelX = 0.5;      // [m/s]
constexpr double kMaxVelTheta = 1.0;  // [rad/s]
constexpr double kAccX = 2.5;         // [m/s^2], both ways
constexpr double kAccTheta = 3.2;     // [rad/s^2]
constexpr double kRounding = 1e-6;

/// A host at 20 Hz of which every command is watched.
class Faults : public ::testing::Test {
 protected:
  Faults()
      : name_("Faults_" + std::string(::testing::UnitTest::GetInstance()->current_test_info()->name())), host_(name_) {
    robot().mend();
    Stage::get().clear();
    drive();
  }

  static Robot& robot() { return Stage::get().robot; }

  Host::Cycle cycle() { return watched(host_.cycle()); }

  bool cycle_until(const std::function<bool(const Host::Cycle&)>& done) {
    return host_.cycle_until([&](const Host::Cycle& c) { return done(watched(c)); });
  }

  /// A cycle whose command is finite, and within the limits and the accelerations.
  Host::Cycle watched(const Host::Cycle& c) {
    const geometry_msgs::Twist& t = c.command;
    for (const double value : {t.linear.x, t.linear.y, t.linear.z, t.angular.x, t.angular.y, t.angular.z}) {
      EXPECT_TRUE(std::isfinite(value));
    }
    EXPECT_GE(t.linear.x, -kRounding);  // min_vel_x
    EXPECT_LE(t.linear.x, kMaxVelX + kRounding);
    EXPECT_LE(std::abs(t.angular.z), kMaxVelTheta + kRounding);
    EXPECT_LE(std::abs(t.linear.x - last_.linear.x), kAccX * kPeriod * c.late + kRounding) << host_.report().fault;
    EXPECT_LE(std::abs(t.angular.z - last_.angular.z), kAccTheta * kPeriod * c.late + kRounding);
    last_ = t;
    return c;
  }

  /// At full speed, on a new plan.
  void drive(const std::string& frame = "odom") {
    EXPECT_TRUE(host_.plan_ahead(6.0, frame));
    goes_on();
  }
  void goes_on() {
    EXPECT_TRUE(cycle_until([](const Host::Cycle& c) { return c.success && c.command.linear.x > 0.45; }))
        << host_.report().fault;
  }
  /// Braking commands that succeed, then failure at rest, for which `reason` is given in words.
  void brakes_to_rest(const std::string& reason = "") {
    int brakes = 0;
    EXPECT_TRUE(cycle_until([&](const Host::Cycle& c) {
      brakes += c.success && host_.report().outcome == hidwa_local_planner::Cycle::BRAKE ? 1 : 0;
      return !c.success;
    }));
    // From 0.45 m/s or more by 0.125 m/s a cycle, or 0.6 rad/s by 0.16: at least three braking commands on the way.
    EXPECT_GE(brakes, 3);
    EXPECT_EQ(last_.linear.x, 0.0);
    EXPECT_EQ(last_.angular.z, 0.0);
    EXPECT_NE(host_.report().fault.find(reason), std::string::npos) << host_.report().fault;
  }
  /// After more cycles than braking to rest takes.
  void drives_on() {
    for (int i = 0; i < 10; ++i) cycle();
    EXPECT_TRUE(cycle_until([](const Host::Cycle& c) { return c.success && c.command.linear.x > 0.1; }))
        << host_.report().fault;
  }

  bool critics(const std::string& names) { return Change().set("critics", names).send(host_); }
  /// A critic of hidwa_broken_critics besides good ones.
  bool with_critic(const std::string& broken) { return critics("PathDist, GoalDist, hidwa_broken_critics/" + broken); }
  void drive_without_it() {
    EXPECT_TRUE(critics("PathDist, GoalDist"));
    drive();
  }

  const std::string name_;
  Host host_;
  geometry_msgs::Twist last_;
};

/// A host whose robot rests fails for this reason. Without odometry, which may come a little later, standing still
/// counts as braking for 0.25 s.
void expect_failure_at_rest(Host& host, const std::string& reason) {
  EXPECT_TRUE(host.cycle_until([&](const Host::Cycle& c) {
    EXPECT_EQ(c.command.linear.x, 0.0);
    return !c.success && host.report().fault.find(reason) != std::string::npos;
  })) << host.report().fault;
}

using MissingInput = Faults;

TEST_F(MissingInput, NoPlanYet) {
  host_.stop();
  Host other(name_ + "_other");
  expect_failure_at_rest(other, "no plan was given yet");
  ASSERT_TRUE(other.plan_ahead(6.0));
  EXPECT_TRUE(other.drives(0.45)) << other.report().fault;
}

TEST_F(MissingInput, EmptyPlan) {
  EXPECT_TRUE(host_.planner().setPlan({}));
  brakes_to_rest("plan is empty");
  drive();
}

TEST_F(MissingInput, WhileItTurns) {
  ASSERT_TRUE(host_.planner().setPlan(straight_plan(6.0, "odom", 1.5)));
  ASSERT_TRUE(cycle_until([](const Host::Cycle& c) { return c.success && c.command.angular.z > 0.6; }));
  EXPECT_TRUE(host_.planner().setPlan({}));
  brakes_to_rest("plan is empty");
  drive();
}

TEST_F(MissingInput, PlanInAFrameThatNobodyKnows) {
  ASSERT_TRUE(host_.plan_ahead(3.0, "nowhere"));
  brakes_to_rest("nowhere");
  drive();
}

TEST_F(MissingInput, TransformOfThePlanGrowsOld) {
  drive("map");
  robot().map_transform = false;
  brakes_to_rest("the transform from the plan's frame map to odom is ");
  robot().map_transform = true;
  goes_on();
}

TEST_F(MissingInput, PoseOfTheRobot) {
  robot().base_transform = false;
  brakes_to_rest("pose");
  robot().base_transform = true;
  goes_on();
}

TEST_F(MissingInput, Odometry) {
  robot().odometry = false;
  brakes_to_rest("s old (odom_timeout 0.50 s)");
  Host other(name_ + "_other");  // who begins now has never heard of any
  ASSERT_TRUE(other.plan_ahead(3.0));
  expect_failure_at_rest(other, "no odometry on /odom yet: check odom_topic");
  robot().odometry = true;
  goes_on();
}

// The age of the odometry is another figure in each cycle: the line is the same.
TEST_F(MissingInput, TheLogSaysSoOnceASecond) {
  const LogListener log;
  const std::string line = "s old (odom_timeout 0.50 s)";
  const ros::Time begin = ros::Time::now();
  robot().odometry = false;
  cycle_until([&begin](const Host::Cycle&) { return ros::Time::now() - begin > ros::Duration(3.0); });
  EXPECT_TRUE(wait_for([&] { return log.times(line) >= 2; }));
  EXPECT_LE(log.times(line), 1 + (ros::Time::now() - begin).toSec());
  robot().odometry = true;
  goes_on();
  EXPECT_TRUE(wait_for([&log] { return log.said(": driving again"); }));
}

TEST_F(MissingInput, CostmapThatIsNotCurrent) {
  robot().laser = false;
  brakes_to_rest("costmap is not current");
  robot().laser = true;
  ASSERT_TRUE(Stage::get().pass_until([] { return Stage::get().costmap->isCurrent(); }));
  goes_on();
}

costmap_2d::Costmap2DROS& costmap() { return *Stage::get().costmap; }

geometry_msgs::Point point(double x, double y) {
  geometry_msgs::Point p;
  p.x = x;
  p.y = y;
  return p;
}

TEST_F(MissingInput, AFootprintThatIsNoRobots) {
  const std::vector<geometry_msgs::Point> robots = costmap().getUnpaddedRobotFootprint();
  costmap().setUnpaddedRobotFootprint(
      {point(100.0, 100.0), point(-100.0, 100.0), point(-100.0, -100.0), point(100.0, -100.0)});
  brakes_to_rest("more than 20 m");
  costmap().setUnpaddedRobotFootprint(robots);
  goes_on();
}

// Plans.

TEST_F(Faults, AnotherPlanInEveryCycle) {
  for (int i = 0; i < 40; ++i) {
    ASSERT_TRUE(host_.plan_ahead(3.0 + 0.05 * (i % 7), i % 2 == 0 ? "odom" : "map"));
    EXPECT_TRUE(cycle().success);
  }
  EXPECT_GT(last_.linear.x, 0.4);
  goes_on();
}

TEST_F(Faults, APlanFarAway) {
  std::vector<geometry_msgs::PoseStamped> plan = straight_plan(3.0);
  for (geometry_msgs::PoseStamped& pose : plan) pose.pose.position.y += 1000.0;
  ASSERT_TRUE(host_.planner().setPlan(plan));
  brakes_to_rest("no pose of the plan lies on the local map");
  drive();
}

TEST_F(Faults, APlanOfNoNumbers) {
  std::vector<geometry_msgs::PoseStamped> plan = straight_plan(3.0);
  plan[5].pose.position.x = std::numeric_limits<double>::quiet_NaN();
  host_.planner().setPlan(plan);
  brakes_to_rest("the plan holds a pose that is not a number");
  drive();
}

// The costmap.

TEST_F(Faults, ACostmapThatIsResized) {
  costmap_2d::LayeredCostmap& layers = *costmap().getLayeredCostmap();
  costmap_2d::Costmap2D& map = *costmap().getCostmap();
  const unsigned int cells = map.getSizeInCellsX();
  const double resolution = map.getResolution();
  for (const unsigned int now : {cells / 2, cells + 60, 20U, cells}) {
    SCOPED_TRACE(now);
    layers.resizeMap(now, now, resolution, map.getOriginX(), map.getOriginY());
    drives_on();
  }
  // Finer and coarser.
  layers.resizeMap(2 * cells, 2 * cells, 0.5 * resolution, map.getOriginX(), map.getOriginY());
  drives_on();
  layers.resizeMap(cells, cells, resolution, map.getOriginX(), map.getOriginY());
  drive();
}

TEST_F(Faults, ACostmapThatIsMovedAway) {
  costmap_2d::Costmap2D& map = *costmap().getCostmap();
  const auto move_away = [&map] {
    const boost::unique_lock<costmap_2d::Costmap2D::mutex_t> lock(*map.getMutex());
    map.updateOrigin(map.getOriginX() + 100.0, map.getOriginY() - 100.0);
  };
  Stage::get().costmap_follows = false;
  move_away();
  brakes_to_rest("no pose of the plan lies on the local map");
  Stage::get().costmap_follows = true;
  drive();
  for (int i = 0; i < 20; ++i) {
    move_away();
    cycle();  // the robot is off the map until the costmap follows it again
  }
  drive();
}

TEST_F(Faults, ACostmapThatIsResetWhileItPlans) {
  std::atomic<bool> resets{true};
  std::thread resetting([&resets] {
    while (resets) {
      costmap().resetLayers();
      ros::WallDuration(0.001).sleep();
    }
  });
  for (int i = 0; i < 40; ++i) EXPECT_TRUE(cycle().success) << host_.report().fault;
  EXPECT_GT(last_.linear.x, 0.4);
  resets = false;
  resetting.join();
  drive();
}

// Transforms.

TEST_F(Faults, TransformsFromTheFuture) {
  const LogListener log;
  robot().transforms_ahead = 2.0;
  brakes_to_rest("ahead of the clock");
  EXPECT_TRUE(wait_for([&] { return log.said("set the clocks of its sender and of this machine alike"); }));
  robot().transforms_ahead = 0.0;
  drive();
}

// Critics of other packages.

TEST_F(Faults, ACriticThatThrows) {
  const LogListener log;
  ASSERT_TRUE(with_critic("Throws"));
  brakes_to_rest();
  EXPECT_TRUE(wait_for(
      [&] { return log.said("the critic hidwa_broken_critics/Throws threw in score(): its table has no such row"); }));
  const std::vector<std::string> names = host_.report().rejection_names;
  EXPECT_EQ(std::count(names.begin(), names.end(), "hidwa_broken_critics/Throws"), 1);
  drive_without_it();
}

TEST_F(Faults, ACriticThatThrowsWhatIsNoException) {
  const LogListener log;
  ros::param::set(ns(name_) + "Throws/in_prepare", true);
  ASSERT_TRUE(with_critic("Throws"));
  brakes_to_rest();
  EXPECT_TRUE(wait_for([&] { return log.said("threw in prepare(): something that is no std::exception"); }));
  drive_without_it();
}

TEST_F(Faults, ACriticThatThrowsOnceTheChoiceIsMade) {
  const LogListener log;
  ASSERT_TRUE(with_critic("ThrowsAtTheEnd"));
  for (int i = 0; i < 20; ++i) EXPECT_TRUE(cycle().success);
  EXPECT_TRUE(wait_for([&] { return log.said("threw in debrief(): its log is full"); }));
  goes_on();
}

TEST_F(Faults, ACriticThatHangsForASecond) {
  const LogListener log;
  ASSERT_TRUE(with_critic("Hangs"));
  ASSERT_TRUE(cycle_until([&](const Host::Cycle& c) {
    EXPECT_TRUE(c.success);
    return log.said("the critic hidwa_broken_critics/Hangs took ");
  }));
  Stage::get().pass(1.0);  // and the robot has gone on meanwhile
  EXPECT_TRUE(log.said("take it out of the parameter critics"));
  drive_without_it();
}

// The plugin itself.

TEST(Unloading, WhileMessagesArrive) {
  std::atomic<bool> sends{true};
  ros::NodeHandle node;
  const ros::Publisher sticks = node.advertise<sensor_msgs::Joy>("joy", 100);
  const ros::Publisher odometry = node.advertise<nav_msgs::Odometry>("odom", 100);
  std::thread sending([&] {
    sensor_msgs::Joy stick;
    stick.axes = {0.5F, 0.0F, 0.0F};
    stick.buttons = {0, 1, 0, 1};
    nav_msgs::Odometry reading;
    for (int i = 0; sends; ++i) {
      stick.header.stamp = reading.header.stamp = ros::Time::now();
      stick.buttons[0] = i % 2;
      sticks.publish(stick);
      odometry.publish(reading);
      ros::WallDuration(0.0005).sleep();
    }
  });
  const auto named = [](int i) { return "Unloaded_" + std::to_string(i); };
  for (int i = 0; i < 12; ++i) {
    Host host(named(i));
    ASSERT_TRUE(host.plan_ahead(3.0));
    std::thread changing([&] { Change().set("max_vel_x", 0.3).set("mode", std::string("switching")).send(host); });
    for (int k = 0; k < 1 + i % 4; ++k) host.cycle();
    changing.join();
  }
  EXPECT_TRUE(wait_for([&] { return sticks.getNumSubscribers() == 0 && odometry.getNumSubscribers() == 0; }));
  for (int i = 0; i < 12; ++i) {
    const std::string service = ns(named(i)) + "set_parameters";
    EXPECT_TRUE(wait_for([&] { return !ros::service::exists(service, false); })) << service;
  }
  sends = false;
  sending.join();
  Stage::get().clear();
  Host host("Unloaded_last");
  ASSERT_TRUE(host.plan_ahead(3.0));
  EXPECT_TRUE(host.drives());
}

}  // namespace
}  // namespace hidwa_plugin_tests
