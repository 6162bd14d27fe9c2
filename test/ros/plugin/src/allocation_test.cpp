// SPDX-License-Identifier: BSD-3-Clause
// A cycle allocates nothing while nobody subscribes: the host's two calls a cycle, minus what the costmap and
// tf allocate when they are asked the same.
#include <cmath>

#include <gtest/gtest.h>
#include <sensor_msgs/Joy.h>

#include "stage.hpp"
#include "support/allocation_counter.hpp"

namespace hidwa_plugin_tests {
namespace {

using hidwa_local_planner::test::allocations_of_this_thread;

// Nothing may grow any more.
constexpr long kGrowth = 0;

/// What the planner asks the host for in either call.
std::size_t of_the_host(const std::string& plan_frame) {
  Stage& stage = Stage::get();
  const std::size_t before = allocations_of_this_thread();
  stage.costmap->isCurrent();
  geometry_msgs::PoseStamped pose;
  stage.costmap->getRobotPose(pose);
  stage.costmap->getRobotFootprint();
  if (plan_frame != stage.costmap->getGlobalFrameID()) {
    stage.tf.lookupTransform(stage.costmap->getGlobalFrameID(), plan_frame, ros::Time(0));
  }
  return allocations_of_this_thread() - before;
}

/// The robot does, as the costmap sees it: its heading is 0.
bool faces_along_x() {
  geometry_msgs::PoseStamped pose;
  return Stage::get().costmap->getRobotPose(pose) && std::abs(pose.pose.orientation.z) < 5e-4;  // sin of half of it
}

/// Once a period on the topic `joy`.
struct Stick {
  bool is_heard() const {
    return wait_for([this] { return publisher.getNumSubscribers() > 0; });
  }
  void send() {
    sensor_msgs::Joy message;
    message.axes = {left, 0.0f};
    message.buttons = {0};
    deliver(publisher, message);
  }
  ros::NodeHandle node;
  float left = 0.0f;
  ros::Publisher publisher = node.advertise<sensor_msgs::Joy>("joy", 1);
  Ticking ticking{[this] { send(); }};
};

class Allocations : public ::testing::Test {
 protected:
  /// Allocations of one cycle beyond the host's own.
  long cycle(Host& host, const std::string& plan_frame = "odom") {
    Stage& stage = Stage::get();
    long own = 0;
    {
      const boost::unique_lock<costmap_2d::Costmap2D::mutex_t> lock(*stage.costmap->getCostmap()->getMutex());
      const auto of_host = static_cast<long>(of_the_host(plan_frame));
      const std::size_t before = allocations_of_this_thread();
      host.planner().isGoalReached();
      success_ = host.planner().computeVelocityCommands(command_);
      own = static_cast<long>(allocations_of_this_thread() - before) - 2 * of_host;
    }
    stage.robot.command(success_ ? command_ : geometry_msgs::Twist());
    stage.pass(kPeriod);
    return own;
  }

  long cycles(Host& host, int count, const std::string& plan_frame = "odom") {
    long own = 0;
    for (int i = 0; i < count; ++i) own += cycle(host, plan_frame);
    return own;
  }

  /// Cycles until `done`.
  template <typename Done>
  bool cycle_until(Host& host, Done done) {
    for (int i = 0; i < static_cast<int>(kPatience / kPeriod); ++i) {
      cycle(host);
      if (done()) return true;
    }
    return false;
  }

  /// Of 100 cycles in which the log was told nothing that begins so; to say something allocates.
  long in_silence(Host& host, const LogListener& log, const std::string& sender) {
    for (int attempt = 0; attempt < 5; ++attempt) {
      const int before = log.times(sender);
      const long own = cycles(host, 100);
      // What was said before this line has come when it has.
      const std::string line = "100 cycles, " + std::to_string(attempt);
      ROS_INFO("%s", line.c_str());
      EXPECT_TRUE(wait_for([&] { return log.said(line); }));
      if (log.times(sender) == before) return own;
    }
    ADD_FAILURE() << "the planner never kept silent for 100 cycles";
    return 0;
  }

  bool success_ = false;
  geometry_msgs::Twist command_;
};

TEST_F(Allocations, NoneWhileDriving) {
  Host host("Drives", Host::Listens::no);
  ASSERT_TRUE(host.plan_ahead(15.0));
  cycles(host, 40);
  ASSERT_GT(command_.linear.x, 0.49);
  EXPECT_LE(cycles(host, 300), kGrowth);  // 7.5 m
  EXPECT_GT(command_.linear.x, 0.49);
}

TEST_F(Allocations, NoneWithThePlanInAnotherFrame) {
  Host host("Map", Host::Listens::no);
  ASSERT_TRUE(host.plan_ahead(10.0, "map"));
  cycles(host, 40, "map");
  EXPECT_LE(cycles(host, 100, "map"), kGrowth);
  EXPECT_GT(command_.linear.x, 0.49);
}

TEST_F(Allocations, NoneWhileThePersonSteers) {
  Host host("Steered", Host::Listens::no);
  Stick stick;
  ASSERT_TRUE(stick.is_heard());
  ASSERT_TRUE(host.plan_ahead(15.0));
  cycles(host, 40);
  stick.left = 0.8f;
  ASSERT_TRUE(cycle_until(host, [this] { return command_.angular.z > 0.6; }));  // 0.8^2 = 0.64 rad/s
  cycles(host, 60);  // the way there is the first of its kind
  EXPECT_LE(cycles(host, 100), kGrowth);
  EXPECT_GT(command_.angular.z, 0.6);
}

// The state, its markers and the stick's motor have much to say now, and nobody listens.
TEST_F(Allocations, NoneWhileThePersonIsRejected) {
  ros::param::set(ns("Rejects") + "critics",
                  "RotateToGoal, Oscillation, ObstacleFootprint, GoalAlign, PathAlign, PathDist, GoalDist");
  for (const char* name : {"blocked_time", "stall_time"}) ros::param::set(ns("Rejects") + name, 0.5);
  ros::param::set(ns("Rejects") + "cycle_budget", -1.0);  // a busy machine would be told so, in the log
  // A wall across the grid marks other cells as the robot turns, with corners nearer to it than the wall: it would be
  // told that it collides, again and again. Along the grid's columns it marks the same cells from anywhere.
  Pose along_x = Stage::get().robot.pose();
  along_x.theta = 0.0;
  Stage::get().robot.put(along_x);
  ASSERT_TRUE(Stage::get().pass_until(faces_along_x));
  Host host("Rejects", Host::Listens::no);
  Stick stick;
  const LogListener log;
  ASSERT_TRUE(stick.is_heard());
  ASSERT_TRUE(host.plan_ahead(8.0));
  cycles(host, 40);
  Stage::get().robot.wall_ahead(1.8);
  stick.left = 0.2f;
  ASSERT_TRUE(cycle_until(host, [this] { return Stage::get().robot.room() < 1.0 && command_.linear.x < 0.05; }));
  cycles(host, 60);
  EXPECT_LE(in_silence(host, log, "Rejects: "), kGrowth);
  EXPECT_LT(command_.linear.x, 0.05);
  EXPECT_TRUE(success_);
  Stage::get().clear();
}

TEST_F(Allocations, NoneWhereEverythingIsRejectedButToSaySo) {
  ros::param::set(ns("Rejected") + "critics", "PathDist, TurnLimit");
  ros::param::set(ns("Rejected") + "TurnLimit/limit", -1.0);
  Host host("Rejected", Host::Listens::no);
  ASSERT_TRUE(host.plan_ahead(5.0));
  cycles(host, 40);
  ASSERT_FALSE(success_);
  int saying = 0;
  const ros::Time begin = ros::Time::now();
  for (int i = 0; i < 100; ++i) saying += cycle(host) != 0 ? 1 : 0;
  // Once a second at most; one more for the second that had begun before.
  EXPECT_LE(saying, (ros::Time::now() - begin).toSec() + 1.0);
}

}  // namespace
}  // namespace hidwa_plugin_tests
