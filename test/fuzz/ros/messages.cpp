// SPDX-License-Identifier: BSD-3-Clause
// Messages as they come over the wire: what can be read of them is taken with finite values, or refused in words.
#include <cstdint>
#include <vector>

#include <geometry_msgs/TransformStamped.h>
#include <nav_msgs/Odometry.h>
#include <nav_msgs/Path.h>
#include <ros/serialization.h>
#include <ros/time.h>
#include <tf2/buffer_core.h>

#include "core/motion/velocity_limits.hpp"
#include "fuzz/input.hpp"
#include "fuzz/require.hpp"
#include "ros/moving_obstacle_input.hpp"
#include "ros/odometry_input.hpp"
#include "ros/plan_message.hpp"
#include "support/shape.hpp"

namespace hidwa_local_planner::fuzz {
namespace {

// What roscpp's own reading refuses never gets to the planner.
template <typename Message>
bool read(std::vector<std::uint8_t>& bytes, Message& message) {
  try {
    ros::serialization::IStream stream(bytes.data(), static_cast<std::uint32_t>(bytes.size()));
    ros::serialization::deserialize(stream, message);
    return true;
  } catch (const std::exception&) {  // of ros::serialization, or no memory for a length that lies
    return false;
  }
}

// [s] by both clocks.
LoopTime at(double seconds) { return {seconds, ros::Time(seconds)}; }

void take_plan(std::vector<std::uint8_t>& bytes) {
  nav_msgs::Path path;
  if (!read(bytes, path)) return;
  const PlanMessage plan = read_plan(path.poses);
  require(plan.poses.empty() == !plan.fault.empty(), "neither a plan nor a fault, or both");
  for (const Pose2& pose : plan.poses) require(is_finite(pose), "a pose of a plan is not a number");
}

void take_odometry(std::vector<std::uint8_t>& bytes) {
  nav_msgs::Odometry odometry;
  if (!read(bytes, odometry)) return;
  OdometryInput input;
  for (int k = 0; k < 3; ++k) input.receive(odometry, at(10.0 + 0.02 * k));
  const OdometryInput::Reading reading = input.read(10.1, 0.5);
  require(reading.velocity.has_value() != !reading.fault.empty(), "neither a velocity nor a fault, or both");
  if (reading.velocity) require(is_finite(*reading.velocity), "the velocity is not a number");
  const std::optional<Twist2> settled = input.settled(10.1, 0.5, Parameters(), VelocityLimits::from({}));
  if (settled) require(is_finite(*settled), "the velocity is not a number");
}

void require_movers(MovingObstacleInput& input, const tf2::BufferCore& tf, double now) {
  MovingObstacleEstimates movers;
  input.read(now, 0.5, tf, "odom", movers);
  require(movers.size() <= MovingObstacleInput::kMost, "too many moving obstacles");
  for (const MovingObstacleEstimate& mover : movers) {
    require(mover.position.allFinite() && mover.velocity.allFinite() && std::isfinite(mover.radius),
            "a mover is not a number");
    require(mover.points.size() <= MovingObstacleInput::kMostPoints, "too many points");
    for (const Point& point : mover.points) require(point.allFinite(), "a point is not a number");
  }
}

// Of another package: whatever it holds, it is read or refused.
void take_detected(const std::vector<std::uint8_t>& bytes, const char* type, const char* md5) {
  MovingObstacleInput input;
  input.receive(test::shape_of(bytes, type, md5), at(10.0));
  require_movers(input, tf2::BufferCore(), 10.0);
}

void take_movers(std::vector<std::uint8_t>& bytes, bool turned) {
  const auto message = boost::make_shared<MovingObstacles>();
  if (!read(bytes, *message)) return;
  tf2::BufferCore tf;
  geometry_msgs::TransformStamped transform;
  transform.header.frame_id = "odom";
  transform.header.stamp = message->header.stamp;
  transform.child_frame_id = "laser";
  transform.transform.translation.x = 1.0;
  transform.transform.rotation.z = transform.transform.rotation.w = std::sqrt(0.5);
  try {
    tf.setTransform(transform, "fuzz", turned);
  } catch (const std::runtime_error&) {  // tf2 adds to the last times that there are
    return;
  }
  MovingObstacleInput input;
  input.receive(message, at(10.0));
  for (const double now : {10.0, message->header.stamp.toSec()}) require_movers(input, tf, now);
}

}  // namespace
}  // namespace hidwa_local_planner::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace hidwa_local_planner::fuzz;
  ros::Time::init();
  Input input(data, size);
  const int kind = input.integer(0, 5);
  const std::string text = input.rest();
  std::vector<std::uint8_t> bytes(text.begin(), text.end());
  if (bytes.empty()) return 0;  // of none, roscpp adds to null and copies from it
  if (kind == 0) take_plan(bytes);
  if (kind == 1) take_odometry(bytes);
  if (kind == 2 || kind == 3) take_movers(bytes, kind == 2);
  if (kind == 4) take_detected(bytes, "people_msgs/People", "18722f4b8db20cc2369740732357847b");
  if (kind == 5) take_detected(bytes, "costmap_converter/ObstacleArrayMsg", "8a1bdcde72c65ca7d3ce8ebf52d43516");
  return 0;
}
