// SPDX-License-Identifier: BSD-3-Clause
// Messages of other packages, byte by byte as their definitions lay them out.
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>
#include <boost/make_shared.hpp>

#include "ros/moving_obstacle_input.hpp"
#include "support/shape.hpp"
#include "support/wire_bytes.hpp"

namespace hidwa_local_planner {
namespace {

// A clock that nobody has set.
LoopTime at(double seconds) { return {seconds, ros::Time(seconds)}; }

using Bytes = test::WireBytes;

constexpr char kPeople[] = "people_msgs/People";
constexpr char kPeopleSum[] = "18722f4b8db20cc2369740732357847b";
constexpr char kArray[] = "costmap_converter/ObstacleArrayMsg";
constexpr char kArraySum[] = "8a1bdcde72c65ca7d3ce8ebf52d43516";

class DetectorMessages : public ::testing::Test {
 protected:
  void SetUp() override { ros::Time::init(); }
  void receive(Bytes bytes, const std::string& type, const std::string& sum) {
    input_.receive(test::shape_of(bytes.all(), type, sum), at(10.0));
    input_.read(10.1, 0.5, tf_, "odom", obstacles_);
  }
  void receive_array(const Bytes& bytes) { receive(bytes, kArray, kArraySum); }
  // One obstacle of 0.1 m at (1, 1) that drives, with these variances and covariance of its velocity.
  double deviation_for(double xx, double xy, double yy) {
    receive_array(Bytes().header("odom", 10).count(1).obstacle(1, {{1.0, 1.0}}, 0.1, 0.5, 0.0, {xx, xy, yy}));
    return obstacles_.empty() ? std::numeric_limits<double>::quiet_NaN() : obstacles_[0].velocity_deviation;
  }
  tf2::BufferCore tf_;
  MovingObstacleInput input_;
  MovingObstacleEstimates obstacles_;
};

TEST_F(DetectorMessages, People) {
  Bytes bytes;
  bytes.header("odom", 10).count(2).person("anna", 3.0, 1.0, 0.5, -0.25).person("bo", -2.0, 0.0, 0.0, 0.0);
  receive(bytes, kPeople, kPeopleSum);
  ASSERT_EQ(obstacles_.size(), 2U);
  EXPECT_EQ(obstacles_[0].position, Point(3.0, 1.0));
  EXPECT_EQ(obstacles_[0].velocity, Point(0.5, -0.25));
  EXPECT_EQ(obstacles_[0].radius, 0.3);
  EXPECT_EQ(obstacles_[0].position_deviation, 0.05);
  EXPECT_EQ(obstacles_[0].velocity_deviation, 0.15);
  EXPECT_NEAR(obstacles_[0].age, 0.1, 1e-9);
  EXPECT_NE(obstacles_[0].id, obstacles_[1].id);
  EXPECT_EQ(obstacles_[1].position, Point(-2.0, 0.0));  // who stands may walk on
  const std::uint32_t anna = obstacles_[0].id;
  receive(Bytes().header("odom", 10).count(1).person("anna", 3.0, 1.0, 0.5, 0.0), kPeople, kPeopleSum);
  EXPECT_EQ(obstacles_[0].id, anna);
  EXPECT_EQ(input_.status().fault, "");
}

TEST_F(DetectorMessages, ADiscHoldsThePolygon) {
  // Middle (2, 2); a corner is sqrt(2) away, and 0.25 m more.
  const std::vector<Point> square{{1.0, 1.0}, {3.0, 1.0}, {3.0, 3.0}, {1.0, 3.0}};
  receive_array(Bytes().header("odom", 10).count(1).obstacle(7, square, 0.25, 0.5, 0.25, {1.0, 0.0, 1.0}));
  ASSERT_EQ(obstacles_.size(), 1U);
  EXPECT_EQ(obstacles_[0].id, 7U);
  EXPECT_EQ(obstacles_[0].position, Point(2.0, 2.0));
  EXPECT_EQ(obstacles_[0].velocity, Point(0.5, 0.25));
  EXPECT_NEAR(obstacles_[0].radius, std::sqrt(2.0) + 0.25, 1e-9);
  EXPECT_EQ(obstacles_[0].velocity_deviation, 0.15);
}

TEST_F(DetectorMessages, WallsAreLeftToTheCostmapAndWhatHasNoPlaceIsRefused) {
  Bytes bytes;
  bytes.header("odom", 10).count(3);
  bytes.obstacle(1, {{5.0, 0.0}, {5.0, 4.0}}, 0.0, 0.0, 0.0, {1.0, 0.0, 1.0});  // stands
  bytes.obstacle(2, {}, 0.3, 1.0, 0.0, {1.0, 0.0, 1.0});                        // lies nowhere
  bytes.obstacle(-1, {{2.0, -1.0}}, 0.5, 0.0, 1.0, {1.0, 0.0, 1.0});
  receive_array(bytes);
  ASSERT_EQ(obstacles_.size(), 1U);
  EXPECT_EQ(obstacles_[0].id, 4294967295U);
  EXPECT_EQ(obstacles_[0].radius, 0.5);
  EXPECT_EQ(input_.status().refused, 1U);
}

TEST_F(DetectorMessages, TheDeviationComesFromTheCovariance) {
  EXPECT_NEAR(deviation_for(0.04, 0.0, 0.01), 0.2, 1e-9);
  EXPECT_NEAR(deviation_for(0.01, 0.0, 0.09), 0.3, 1e-9);
  // [[0.05, 0.04], [0.04, 0.05]]: 0.05 + 0.04 = 0.09 along the diagonal.
  EXPECT_NEAR(deviation_for(0.05, 0.04, 0.05), 0.3, 1e-9);
  EXPECT_EQ(deviation_for(0.0, 0.0, 0.0), 0.15);
  EXPECT_EQ(deviation_for(-1.0, 0.0, -1.0), 0.15);
  EXPECT_EQ(deviation_for(1.0, 0.0, 1.0), 0.15);
  EXPECT_EQ(deviation_for(4.0, 0.0, 1.0), 2.0);
  EXPECT_TRUE(std::isnan(deviation_for(std::numeric_limits<double>::quiet_NaN(), 0.0, 1.0)));
}

TEST_F(DetectorMessages, OursComesAsItIs) {
  MovingObstacles ours;
  ours.header.frame_id = "odom";
  ours.header.stamp.fromSec(10.0);
  ours.obstacles.resize(1);
  ours.obstacles[0].radius = 0.4;
  const ros::SerializedMessage wire = ros::serialization::serializeMessage(ours);
  receive({}, kPeople, kPeopleSum);  // of no length: refused
  EXPECT_TRUE(obstacles_.empty());
  EXPECT_NE(input_.status().fault.find("cannot be read"), std::string::npos) << input_.status().fault;
  const std::vector<std::uint8_t> bytes(wire.message_start, wire.buf.get() + wire.num_bytes);
  input_.receive(test::shape_of(bytes, ros::message_traits::datatype(ours), ros::message_traits::md5sum(ours)),
                 at(10.0));
  input_.read(10.1, 0.5, tf_, "odom", obstacles_);
  ASSERT_EQ(obstacles_.size(), 1U);
  EXPECT_EQ(obstacles_[0].radius, 0.4);
  EXPECT_EQ(input_.status().fault, "");
}

// The message before counts until it is too old.
TEST_F(DetectorMessages, WhatCannotBeReadIsNamedAndForgetsNobody) {
  Bytes good;
  good.header("odom", 10).count(1).person("anna", 3.0, 1.0, 0.5, 0.0);
  receive(good, kPeople, kPeopleSum);
  ASSERT_EQ(obstacles_.size(), 1U);
  Bytes cut;
  cut.header("odom", 10).count(1000).person("anna", 3.0, 1.0, 0.5, 0.0);
  const struct {
    Bytes bytes;
    const char *type, *sum, *word;
  } cases[] = {{cut, kPeople, kPeopleSum, "cannot be read"},
               {good, kPeople, "0123456789abcdef0123456789abcdef", "cannot be read"},
               {good, "people_msgs/PositionMeasurementArray", "59c860d40aa739ec920eb3ad24ae019e", "send "},
               {good, "hidwa_local_planner/MovingObstacles", kPeopleSum, "cannot be read"}};
  for (const auto& one : cases) {
    receive(one.bytes, one.type, one.sum);
    EXPECT_EQ(obstacles_.size(), 1U) << one.type;
    const MovingObstacleInput::Status status = input_.status();
    EXPECT_NE(status.fault.find(one.word), std::string::npos) << status.fault;
    EXPECT_NE(status.fault.find(one.type), std::string::npos) << status.fault;
  }
  EXPECT_EQ(input_.status().refused, 4U);
  receive(good, kPeople, kPeopleSum);
  EXPECT_EQ(input_.status().fault, "");
}

TEST_F(DetectorMessages, EveryBeginningIsReadOrRefused) {
  Bytes people, array;
  people.header("odom", 10).count(1).person("anna", 3.0, 1.0, 0.5, -0.25);
  array.header("odom", 10).count(1).obstacle(7, {{1.0, 1.0}, {2.0, 2.0}}, 0.2, 0.5, 0.0, {1.0, 0.0, 1.0});
  for (const auto& [bytes, type, sum] :
       {std::make_tuple(people, kPeople, kPeopleSum), std::make_tuple(array, kArray, kArraySum)}) {
    std::vector<std::uint8_t> all = Bytes(bytes).all();
    for (std::size_t length = 0; length < all.size(); ++length) {
      input_.forget();
      input_.receive(test::shape_of({all.begin(), all.begin() + static_cast<std::ptrdiff_t>(length)}, type, sum),
                     at(10.0));
      input_.read(10.1, 0.5, tf_, "odom", obstacles_);
      ASSERT_TRUE(obstacles_.empty()) << type << ' ' << length;
      ASSERT_NE(input_.status().fault, "");
    }
  }
}

}  // namespace
}  // namespace hidwa_local_planner
