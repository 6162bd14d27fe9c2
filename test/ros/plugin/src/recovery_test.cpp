// SPDX-License-Identifier: BSD-3-Clause
// The recovery behaviour, loaded as a host does it beside the planner: brakes, yields to the person, clears.
#include <algorithm>
#include <atomic>
#include <cmath>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include <actionlib_msgs/GoalID.h>
#include <costmap_2d/cost_values.h>
#include <costmap_2d/obstacle_layer.h>
#include <gtest/gtest.h>
#include <nav_core/recovery_behavior.h>
#include <std_msgs/Bool.h>

#include "person.hpp"

namespace hidwa_plugin_tests {
namespace {

pluginlib::ClassLoader<nav_core::RecoveryBehavior>& loader() {
  static pluginlib::ClassLoader<nav_core::RecoveryBehavior> instance("nav_core", "nav_core::RecoveryBehavior");
  return instance;
}

/// What is sent on cmd_vel, and the robot that hears it.
class Commands {
 public:
  struct Sent {
    ros::Time time;  // when it arrived, simulated
    geometry_msgs::Twist twist;
  };
  Commands() {
    subscriber_ = ros::NodeHandle().subscribe<geometry_msgs::Twist>(
        "cmd_vel", 100, [this](const geometry_msgs::Twist::ConstPtr& twist) {
          const std::lock_guard<std::mutex> lock(mutex_);
          Stage::get().robot.command(*twist);
          all_.push_back({ros::Time::now(), *twist});
        });
  }
  std::vector<Sent> all() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return all_;
  }
  /// Waits until what is sent from now on arrives.
  void expect_connected() const {
    EXPECT_TRUE(wait_for([this] { return subscriber_.getNumPublishers() > 0; }));
  }

 private:
  mutable std::mutex mutex_;
  std::vector<Sent> all_;
  ros::Subscriber subscriber_;
};

/// A recovery with the stage's costmap in both places.
boost::shared_ptr<nav_core::RecoveryBehavior> recovery(const std::string& name, double patience,
                                                       double reset_distance = 3.0) {
  ros::param::set(ns(name) + "patience", patience);
  ros::param::set(ns(name) + "reset_distance", reset_distance);
  const auto behavior = loader().createInstance("hidwa_local_planner/YieldingRecovery");
  Stage& stage = Stage::get();
  behavior->initialize(name, &stage.tf, stage.costmap.get(), stage.costmap.get());
  return behavior;
}

/// A behaviour that runs on a thread of its own, as in the host's control thread.
class Running {
 public:
  explicit Running(boost::shared_ptr<nav_core::RecoveryBehavior> behavior)
      : behavior_(behavior), thread_([this] {
          behavior_->runBehavior();
          ended_ = true;
        }) {}
  ~Running() { thread_.join(); }
  bool ends(double seconds = kPatience) {
    return Stage::get().pass_until([this] { return ended_.load(); }, seconds);
  }
  bool ended() const { return ended_; }

 private:
  boost::shared_ptr<nav_core::RecoveryBehavior> behavior_;
  std::atomic<bool> ended_{false};
  std::thread thread_;
};

class RecoveryTest : public Operated {
 protected:
  void start_stopped() {
    start();
    host().plan_ahead(2.0);
    ASSERT_TRUE(say<std_msgs::Bool>("stop", true));
    ASSERT_TRUE(reaches("STOPPED"));
  }
};

TEST_F(RecoveryTest, BrakesWithinTheLimitsAndNeverTurns) {
  start();
  drive();
  const Commands commands;
  const auto behavior = recovery("Brakes", 10.0);
  commands.expect_connected();
  ros::Time before = ros::Time::now() - ros::Duration(kPeriod);  // of the last cycle
  Running running(behavior);
  ASSERT_TRUE(running.ends());
  ASSERT_TRUE(wait_for([&] { return !commands.all().empty() && commands.all().back().twist.linear.x == 0.0; }));
  double last = 0.5;  // [m/s]
  for (const Commands::Sent& sent : commands.all()) {
    // A cycle that is late brakes by more.
    const double passed = std::max(kPeriod, (sent.time - before).toSec()) + 0.5 * kPeriod;
    EXPECT_GE(sent.twist.linear.x, last - 2.5 * passed - 1e-3);
    EXPECT_LE(sent.twist.linear.x, last + 1e-9);
    EXPECT_EQ(sent.twist.angular.z, 0.0);
    last = sent.twist.linear.x;
    before = sent.time;
  }
  // 0.5 m/s at 2.5 m/s2 and 20 Hz are 4 cycles.
  EXPECT_GE(commands.all().size(), 3u);
}

TEST_F(RecoveryTest, WaitsWhileSomebodyStopsTheRobot) {
  start_stopped();
  const Commands commands;
  const auto behavior = recovery("Stopped", 20.0);
  commands.expect_connected();
  Running running(behavior);
  EXPECT_TRUE(Stage::get().pass_until([&] { return commands.all().size() > 20; }));  // told all the time
  EXPECT_FALSE(running.ended());
  EXPECT_EQ(state().state_name, "STOPPED");
  ASSERT_TRUE(say<std_msgs::Bool>("stop", false));
  EXPECT_TRUE(running.ends());
  for (const Commands::Sent& sent : commands.all()) {
    EXPECT_EQ(sent.twist.linear.x, 0.0);
    EXPECT_EQ(sent.twist.angular.z, 0.0);
  }
}

TEST_F(RecoveryTest, ItsPatienceEnds) {
  start_stopped();
  const ros::Time before = ros::Time::now();
  Running running(recovery("Patience", 1.0));
  ASSERT_TRUE(running.ends());
  EXPECT_GE(ros::Time::now() - before, ros::Duration(1.0));
  EXPECT_EQ(state().state_name, "STOPPED");
}

// The host looks at a cancel only after the recovery.
TEST_F(RecoveryTest, ACancelEndsTheWait) {
  start_stopped();
  Running running(recovery("Cancelled", 20.0));
  const ros::Publisher cancel = ros::NodeHandle().advertise<actionlib_msgs::GoalID>("move_base/cancel", 1);
  ASSERT_TRUE(wait_for([&] { return cancel.getNumSubscribers() > 0; }));
  EXPECT_FALSE(running.ends(0.5));
  cancel.publish(actionlib_msgs::GoalID());
  EXPECT_TRUE(running.ends());
}

TEST(Recovery, WithoutAPlannerItDoesNotWait) {
  Stage::get().clear();
  const ros::Time before = ros::Time::now();
  recovery("Alone", 20.0)->runBehavior();  // one that waited would wait for ever: no time passes here
  EXPECT_EQ(ros::Time::now(), before);
}

long lethal_cells() {
  costmap_2d::Costmap2D& map = *Stage::get().costmap->getCostmap();
  const boost::unique_lock<costmap_2d::Costmap2D::mutex_t> lock(*map.getMutex());
  const unsigned char* cells = map.getCharMap();
  return std::count(cells, cells + map.getSizeInCellsX() * map.getSizeInCellsY(), costmap_2d::LETHAL_OBSTACLE);
}

/// Marks the cell `behind` [m] behind the robot, where no beam clears it.
void mark_behind(double behind) {
  costmap_2d::Costmap2DROS& costmap = *Stage::get().costmap;
  const boost::unique_lock<costmap_2d::Costmap2D::mutex_t> lock(*costmap.getCostmap()->getMutex());
  const Pose robot = Stage::get().robot.pose();
  for (const auto& layer : *costmap.getLayeredCostmap()->getPlugins()) {
    auto* obstacles = dynamic_cast<costmap_2d::ObstacleLayer*>(layer.get());
    if (obstacles == nullptr) continue;
    const double x = robot.x - behind * std::cos(robot.theta);
    const double y = robot.y - behind * std::sin(robot.theta);
    unsigned int mx = 0, my = 0;
    ASSERT_TRUE(obstacles->worldToMap(x, y, mx, my));
    obstacles->setCost(mx, my, costmap_2d::LETHAL_OBSTACLE);
    obstacles->addExtraBounds(x - 0.1, y - 0.1, x + 0.1, y + 0.1);
  }
}

// Remembered 0.7 m and 1.5 m behind the robot: a square of 3.6 m, 1.8 m to each side, keeps both; one of 2 m keeps the
// near one; one without a side keeps none.
TEST(Recovery, ForgetsWhatLiesFarFromTheRobot) {
  Stage::get().clear();
  mark_behind(0.7);
  mark_behind(1.5);
  struct Row {
    const char* name;
    double side;
    long kept;
  };
  ASSERT_TRUE(Stage::get().pass_until([] { return lethal_cells() == 2; }));
  for (const Row& row : {Row{"KeepsBoth", 3.6, 2}, Row{"KeepsOne", 2.0, 1}, Row{"KeepsNone", 0.0, 0}}) {
    SCOPED_TRACE(row.name);
    recovery(row.name, 1.0, row.side)->runBehavior();
    EXPECT_TRUE(Stage::get().pass_until([&row] { return lethal_cells() == row.kept; }));
    EXPECT_FALSE(Stage::get().pass_until([&row] { return lethal_cells() != row.kept; }, 0.5));
  }
}

}  // namespace
}  // namespace hidwa_plugin_tests
