// SPDX-License-Identifier: BSD-3-Clause
#include "ros/moving_obstacle_input.hpp"

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <boost/make_shared.hpp>

namespace hidwa_local_planner {
namespace {

// A clock that nobody has set.
LoopTime at(double seconds) { return {seconds, ros::Time(seconds)}; }

MovingObstacle obstacle(double x, double y, double vx, double vy) {
  MovingObstacle one;
  one.id = 3;
  one.position.x = x;
  one.position.y = y;
  one.velocity.x = vx;
  one.velocity.y = vy;
  one.radius = 0.3;
  return one;
}

MovingObstacles::Ptr message(const std::string& frame, double stamp) {
  auto made = boost::make_shared<MovingObstacles>();
  made->header.frame_id = frame;
  made->header.stamp.fromSec(stamp);
  return made;
}

class MovingObstacleInputs : public ::testing::Test {
 protected:
  void SetUp() override { ros::Time::init(); }
  // The laser lies at (1, 2) in odom and looks along odom's y axis.
  void place_laser(double stamp) {
    geometry_msgs::TransformStamped transform;
    transform.header.frame_id = "odom";
    transform.header.stamp.fromSec(stamp);
    transform.child_frame_id = "laser";
    transform.transform.translation.x = 1.0;
    transform.transform.translation.y = 2.0;
    transform.transform.rotation.z = transform.transform.rotation.w = std::sqrt(0.5);
    tf_.setTransform(transform, "test");
  }
  /// As a message of now.
  void receive(const std::string& frame, double now, const std::vector<MovingObstacle>& obstacles) {
    const MovingObstacles::Ptr made = message(frame, now);
    made->obstacles = obstacles;
    input_.receive(made, at(now));
  }
  const MovingObstacleEstimates& read(double now) {
    input_.read(now, 0.5, tf_, "odom", obstacles_);
    return obstacles_;
  }
  tf2::BufferCore tf_;
  MovingObstacleInput input_;
  MovingObstacleEstimates obstacles_;
};

TEST_F(MovingObstacleInputs, NothingYetIsNoFault) {
  EXPECT_TRUE(read(10.0).empty());
  EXPECT_EQ(input_.status().fault, "");
}

TEST_F(MovingObstacleInputs, PlacesAreBroughtToTheCostmapAndVelocitiesTurned) {
  place_laser(10.0);
  const auto made = message("laser", 10.0);
  made->obstacles.push_back(obstacle(3.0, 1.0, 0.5, 0.2));
  made->obstacles.back().points.resize(1);
  made->obstacles.back().points[0].x = 3.0F;
  input_.receive(made, at(10.05));
  ASSERT_EQ(read(10.2).size(), 1U);
  // A quarter to the left: (x, y) becomes (-y, x), and then (1, 2) more.
  EXPECT_NEAR(obstacles_[0].position.x(), 1.0 - 1.0, 1e-9);
  EXPECT_NEAR(obstacles_[0].position.y(), 2.0 + 3.0, 1e-9);
  EXPECT_NEAR(obstacles_[0].velocity.x(), -0.2, 1e-9);
  EXPECT_NEAR(obstacles_[0].velocity.y(), 0.5, 1e-9);
  EXPECT_NEAR(obstacles_[0].age, 10.2 - 10.0, 1e-6);
  ASSERT_EQ(obstacles_[0].points.size(), 1U);
  EXPECT_NEAR(obstacles_[0].points[0].y(), 2.0 + 3.0, 1e-6);
}

ObservedSector sector(const std::string& frame, double from, double to) {
  ObservedSector one;
  one.frame_id = frame;
  one.angle_min = from;
  one.angle_max = to;
  one.range = 10.0;
  return one;
}

TEST_F(MovingObstacleInputs, SectorsAreBroughtToTheRobotAndCountUntilOthersAreTold) {
  place_laser(10.0);
  geometry_msgs::TransformStamped down;  // turned about its x axis by half a turn: left is right
  down.header.frame_id = "odom";
  down.header.stamp.fromSec(10.0);
  down.child_frame_id = "down";
  down.transform.translation.x = -0.2;
  down.transform.rotation.x = 1.0;
  tf_.setTransform(down, "test");
  const auto made = message("odom", 10.0);
  made->sensor_sectors = {sector("laser", -0.5, 1.5), sector("/down", 0.2, 0.4), sector("nowhere", -1.0, 1.0),
                          sector("laser", 1.0, 0.5)};
  input_.receive(made, at(10.0));
  SensorSectors sectors;
  input_.read_sectors(tf_, "odom", sectors);
  ASSERT_EQ(sectors.size(), 4U);
  EXPECT_NEAR(sectors[0].pose.x, 1.0, 1e-9);
  EXPECT_NEAR(sectors[0].pose.theta, 0.5 * M_PI + 0.5,
              1e-9);  // the laser faces left, and the sector's middle is at 0.5
  EXPECT_NEAR(sectors[0].width, 2.0, 1e-9);
  EXPECT_NEAR(sectors[1].pose.theta, -0.3, 1e-9);
  EXPECT_NEAR(sectors[1].pose.x, -0.2, 1e-9);
  EXPECT_TRUE(sectors[2] == SensorSector());  // its place is not known: it sees nothing
  EXPECT_TRUE(sectors[3] == SensorSector());
  EXPECT_TRUE(read(20.0).empty());  // long after, what moves does not count
  input_.read_sectors(tf_, "odom", sectors);
  EXPECT_EQ(sectors.size(), 4U);
  input_.receive(message("odom", 20.0), at(20.0));
  input_.read_sectors(tf_, "odom", sectors);
  EXPECT_TRUE(sectors.empty());
}

TEST_F(MovingObstacleInputs, WhereTfIsLateTheNewestTransformIsTaken) {
  place_laser(9.9);
  receive("laser", 10.0, {obstacle(3.0, 1.0, 0.0, 0.0)});
  EXPECT_EQ(read(10.1).size(), 1U);
}

TEST_F(MovingObstacleInputs, WithoutATransformNothingCountsAndItSaysSo) {
  receive("nowhere", 10.0, {obstacle(3.0, 1.0, 0.0, 0.0)});
  EXPECT_TRUE(read(10.1).empty());
  EXPECT_NE(input_.status().fault.find("nowhere"), std::string::npos) << input_.status().fault;
}

TEST_F(MovingObstacleInputs, WhatIsOldDoesNotCount) {
  receive("odom", 10.0, {obstacle(3.0, 1.0, 0.0, 0.0)});
  EXPECT_EQ(read(10.4).size(), 1U);
  EXPECT_TRUE(read(10.6).empty());
  EXPECT_NE(input_.status().fault.find("0.60 s old"), std::string::npos) << input_.status().fault;
}

TEST_F(MovingObstacleInputs, NonsenseIsRefusedAndTheRestCounts) {
  MovingObstacle too_small = obstacle(1.0, 1.0, 0.0, 0.0), unsure = obstacle(1.0, 1.0, 0.0, 0.0);
  too_small.radius = -0.1;
  unsure.velocity_deviation = std::numeric_limits<double>::quiet_NaN();
  receive("odom", 10.0,
          {obstacle(3.0, 1.0, 0.0, 0.0), obstacle(std::numeric_limits<double>::quiet_NaN(), 1.0, 0.0, 0.0), too_small,
           obstacle(1.0, 1.0, 0.0, std::numeric_limits<double>::infinity()), unsure});
  EXPECT_EQ(read(10.1).size(), 1U);
  EXPECT_EQ(input_.status().refused, 4U);
  EXPECT_EQ(input_.status().count, 1U);
  EXPECT_NE(input_.status().fault, "");
}

TEST_F(MovingObstacleInputs, TooManyAreNoList) {
  receive("odom", 10.0, std::vector<MovingObstacle>(MovingObstacleInput::kMost + 1, obstacle(3.0, 1.0, 0.0, 0.0)));
  EXPECT_TRUE(read(10.1).empty());
  EXPECT_NE(input_.status().fault, "");
}

TEST_F(MovingObstacleInputs, AnEmptyMessageSaysThatNothingMoves) {
  receive("odom", 10.0, {obstacle(3.0, 1.0, 0.0, 0.0)});
  EXPECT_EQ(read(10.1).size(), 1U);
  receive("odom", 10.1, {});
  EXPECT_TRUE(read(10.2).empty());
  EXPECT_EQ(input_.status().fault, "");
}

}  // namespace
}  // namespace hidwa_local_planner
