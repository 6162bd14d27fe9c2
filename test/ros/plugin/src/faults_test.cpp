// SPDX-License-Identifier: BSD-3-Clause
// What only a program that holds the costmap, the plan and the plugin itself can disturb: every command stays finite,
// within the limits and the accelerations, and after the fault the robot drives on.
#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include <geometry_msgs/TransformStamped.h>
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

std::string test_name() { return ::testing::UnitTest::GetInstance()->current_test_info()->name(); }

/// A host at 20 Hz of which every command is watched.
class Faults : public ::testing::Test {
 protected:
  void SetUp() override {
    Robot& robot = Stage::get().robot;
    robot.odometry = robot.laser = robot.base_transform = robot.map_transform = true;
    Stage::get().clear();
    host_ = std::make_unique<Host>("Faults_" + test_name());
    drive();
  }

  Host& host() { return *host_; }

  Host::Cycle cycle() {
    const Host::Cycle c = host_->cycle();
    const geometry_msgs::Twist& t = c.command;
    for (const double value : {t.linear.x, t.linear.y, t.linear.z, t.angular.x, t.angular.y, t.angular.z}) {
      EXPECT_TRUE(std::isfinite(value));
    }
    EXPECT_GE(t.linear.x, -kRounding);  // min_vel_x
    EXPECT_LE(t.linear.x, kMaxVelX + kRounding);
    EXPECT_LE(std::abs(t.angular.z), kMaxVelTheta + kRounding);
    EXPECT_LE(std::abs(t.linear.x - last_.linear.x), kAccX * kPeriod * c.late + kRounding) << host_->report().fault;
    EXPECT_LE(std::abs(t.angular.z - last_.angular.z), kAccTheta * kPeriod * c.late + kRounding);
    last_ = t;
    return c;
  }

  template <typename Done>
  bool cycle_until(Done done) {
    const ros::Time end = ros::Time::now() + ros::Duration(kPatience);
    while (ros::Time::now() < end) {
      if (done(cycle())) return true;
    }
    return false;
  }

  /// At full speed, on a new plan.
  void drive() {
    ASSERT_TRUE(host_->plan_ahead(6.0));
    goes_on();
  }
  void goes_on() {
    EXPECT_TRUE(cycle_until([](const Host::Cycle& c) { return c.success && c.command.linear.x > 0.45; }))
        << host_->report().fault;
  }
  /// Braking commands that succeed, then failure at rest, for which `reason` is given in words.
  void brakes_to_rest(const std::string& reason = "") {
    int brakes = 0;
    double before = last_.linear.x;
    EXPECT_TRUE(cycle_until([&](const Host::Cycle& c) {
      brakes += c.success && c.command.linear.x > 0.0 && c.command.linear.x < before ? 1 : 0;
      before = c.command.linear.x;
      return !c.success;
    }));
    EXPECT_GE(brakes, 1);  // three by 0.125 m/s from 0.45 m/s, fewer after a critic that hangs
    EXPECT_EQ(last_.linear.x, 0.0);
    const std::string fault = host_->report().fault;
    EXPECT_NE(fault.find(reason), std::string::npos) << fault;
  }
  /// After more cycles than braking to rest takes.
  void drives_on() {
    for (int i = 0; i < 10; ++i) cycle();
    EXPECT_TRUE(cycle_until([](const Host::Cycle& c) { return c.success && c.command.linear.x > 0.1; }))
        << host_->report().fault;
  }

  /// The newest cycle says so.
  bool rejected_by(const std::string& name) const {
    const std::vector<std::string> names = host_->report().rejection_names;
    return std::find(names.begin(), names.end(), name) != names.end();
  }

  bool critics(const std::string& names) { return Change().set("critics", names).send(*host_); }

  std::unique_ptr<Host> host_;
  geometry_msgs::Twist last_;
};

// Plans.

TEST_F(Faults, AnotherPlanInEveryCycle) {
  for (int i = 0; i < 40; ++i) {
    ASSERT_TRUE(host().plan_ahead(3.0 + 0.05 * (i % 7), i % 2 == 0 ? "odom" : "map"));
    EXPECT_TRUE(cycle().success);
  }
  EXPECT_GT(last_.linear.x, 0.4);
  goes_on();
}

TEST_F(Faults, APlanFarAway) {
  std::vector<geometry_msgs::PoseStamped> plan = straight_plan(3.0);
  for (geometry_msgs::PoseStamped& pose : plan) pose.pose.position.y += 1000.0;
  ASSERT_TRUE(host().planner().setPlan(plan));
  brakes_to_rest("no pose of the plan lies on the local map");
  drive();
}

TEST_F(Faults, APlanOfNoNumbers) {
  std::vector<geometry_msgs::PoseStamped> plan = straight_plan(3.0);
  plan[5].pose.position.x = std::numeric_limits<double>::quiet_NaN();
  host().planner().setPlan(plan);
  brakes_to_rest("the plan holds a pose that is not a number");
  drive();
}

// The costmap.

costmap_2d::LayeredCostmap& layers() { return *Stage::get().costmap->getLayeredCostmap(); }

TEST_F(Faults, ACostmapThatIsResized) {
  costmap_2d::Costmap2D& map = *Stage::get().costmap->getCostmap();
  const unsigned int cells = map.getSizeInCellsX();
  const double resolution = map.getResolution();
  for (const unsigned int now : {cells / 2, cells + 60, 20U, cells}) {
    SCOPED_TRACE(now);
    layers().resizeMap(now, now, resolution, map.getOriginX(), map.getOriginY());
    drives_on();
  }
  // Finer and coarser.
  layers().resizeMap(2 * cells, 2 * cells, 0.5 * resolution, map.getOriginX(), map.getOriginY());
  drives_on();
  layers().resizeMap(cells, cells, resolution, map.getOriginX(), map.getOriginY());
  drive();
}

TEST_F(Faults, ACostmapThatIsMovedAway) {
  costmap_2d::Costmap2D& map = *Stage::get().costmap->getCostmap();
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
      Stage::get().costmap->resetLayers();
      ros::WallDuration(0.001).sleep();
    }
  });
  for (int i = 0; i < 40; ++i) EXPECT_TRUE(cycle().success) << host().report().fault;
  EXPECT_GT(last_.linear.x, 0.4);
  resets = false;
  resetting.join();
  drive();
}

// Transforms.

TEST_F(Faults, TransformsFromTheFuture) {
  const LogListener log;
  Stage::get().robot.transforms_ahead = 2.0;
  brakes_to_rest("ahead of the clock");
  EXPECT_TRUE(wait_for([&] { return log.said("set the clocks of its sender and of this machine alike"); }));
  Stage::get().robot.transforms_ahead = 0.0;
  drive();
}

// Critics of other packages.

TEST_F(Faults, ACriticThatThrows) {
  const LogListener log;
  ASSERT_TRUE(critics("PathDist, GoalDist, hidwa_broken_critics/Throws"));
  brakes_to_rest();
  EXPECT_TRUE(wait_for(
      [&] { return log.said("the critic hidwa_broken_critics/Throws threw in score(): its table has no such row"); }));
  EXPECT_TRUE(rejected_by("hidwa_broken_critics/Throws"));
  ASSERT_TRUE(critics("PathDist, GoalDist"));
  drive();
}

TEST_F(Faults, ACriticThatThrowsWhatIsNoException) {
  const LogListener log;
  ros::param::set(ros::this_node::getName() + "/" + host().name() + "/Throws/in_prepare", true);
  ASSERT_TRUE(critics("PathDist, GoalDist, hidwa_broken_critics/Throws"));
  brakes_to_rest();
  EXPECT_TRUE(wait_for([&] { return log.said("threw in prepare(): something that is no std::exception"); }));
  ASSERT_TRUE(critics("PathDist, GoalDist"));
  drive();
}

TEST_F(Faults, ACriticThatThrowsOnceTheChoiceIsMade) {
  const LogListener log;
  ASSERT_TRUE(critics("PathDist, GoalDist, hidwa_broken_critics/ThrowsAtTheEnd"));
  for (int i = 0; i < 20; ++i) EXPECT_TRUE(cycle().success);
  EXPECT_TRUE(wait_for([&] { return log.said("threw in debrief(): its log is full"); }));
  goes_on();
}

TEST_F(Faults, ACriticThatHangsForASecond) {
  const LogListener log;
  ASSERT_TRUE(critics("PathDist, GoalDist, hidwa_broken_critics/Hangs"));
  ASSERT_TRUE(cycle_until([&](const Host::Cycle& c) {
    EXPECT_TRUE(c.success);
    return log.said("the critic hidwa_broken_critics/Hangs took ");
  }));
  Stage::get().pass(1.0);  // and the robot has gone on meanwhile
  EXPECT_TRUE(log.said("take it out of the parameter critics"));
  ASSERT_TRUE(critics("PathDist, GoalDist"));
  drive();
}

TEST_F(Faults, ACriticWhoseScoresAreNoNumbers) {
  const LogListener log;
  ASSERT_TRUE(critics("PathDist, GoalDist, hidwa_broken_critics/NotANumber"));
  brakes_to_rest();
  EXPECT_TRUE(rejected_by("hidwa_broken_critics/NotANumber"));
  EXPECT_TRUE(wait_for(
      [&] { return log.said("the critic hidwa_broken_critics/NotANumber gives scores that are no finite numbers"); }));
  ASSERT_TRUE(critics("PathDist, GoalDist"));
  drive();
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
    const std::string service = ros::this_node::getName() + "/" + named(i) + "/set_parameters";
    EXPECT_TRUE(wait_for([&] { return !ros::service::exists(service, false); })) << service;
  }
  sends = false;
  sending.join();
  Stage::get().clear();
  Host host("Unloaded_last");
  ASSERT_TRUE(host.plan_ahead(3.0));
  EXPECT_TRUE(host.cycle_until([](const Host::Cycle& c) { return c.success && c.command.linear.x > 0.2; }));
}

}  // namespace
}  // namespace hidwa_plugin_tests

int main(int argc, char** argv) {
  ros::init(argc, argv, "faults_test");
  ros::NodeHandle node;
  ::testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
