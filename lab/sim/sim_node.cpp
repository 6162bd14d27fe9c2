// SPDX-License-Identifier: BSD-3-Clause
// hidwa_sim_node: the simulated robot in its map, with its clock.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <exception>

#include <geometry_msgs/Twist.h>
#include <ros/ros.h>
#include <rosgraph_msgs/Clock.h>
#include <std_msgs/UInt32.h>
#include <tf2_ros/static_transform_broadcaster.h>
#include <tf2_ros/transform_broadcaster.h>

#include "node_messages.hpp"
#include "node_parameters.hpp"
#include "node_people.hpp"
#include "pacer.hpp"

namespace hidwa_local_planner {
namespace sim {
namespace {

constexpr double kStep = 0.01;                         // [s], simulated time from /clock to /clock
constexpr std::int64_t kStepNanoseconds = 10'000'000;  // the same
constexpr double kFirstStamp = 1.0;                    // [s]; 0 would mean "no time" to the listeners
constexpr std::int64_t kLateSteps = 10;                // [steps] from one command to the next; beyond, it is late
constexpr std::int64_t kSilentSteps = 100;             // [steps] without a command; beyond, the host sends none

/// True every 1/rate seconds of simulated time, rounded to whole steps.
class Every {
 public:
  explicit Every(double rate) : steps_(std::max<std::int64_t>(1, std::llround(1.0 / (rate * kStep)))) {}
  bool operator()(std::int64_t step) const { return step % steps_ == 0; }

 private:
  std::int64_t steps_;
};

class SimNode {
 public:
  explicit SimNode(const SimNodeParameters& parameters)
      : p_(parameters),
        world_(p_.world),
        random_(p_.world.seed + 1),
        odom_due_(p_.odom_rate),
        truth_due_(p_.ground_truth_rate),
        scan_due_(p_.scan_rate),
        scan_message_(scan_message(p_.laser, p_.laser_frame, 1.0 / p_.scan_rate)),
        people_(node_, p_.map_frame, p_.tell_truth) {
    if (!p_.follow_clock) clock_ = node_.advertise<rosgraph_msgs::Clock>("/clock", 10);
    odom_ = node_.advertise<nav_msgs::Odometry>("odom", 10);
    truth_ = node_.advertise<nav_msgs::Odometry>("ground_truth", 100);
    scan_ = node_.advertise<sensor_msgs::LaserScan>("scan", 10);
    contacts_ = node_.advertise<std_msgs::UInt32>("contacts", 10, true);
    crossed_ = node_.advertise<std_msgs::UInt32>("regions_crossed", 10, true);
    regions_ = node_.advertise<visualization_msgs::MarkerArray>("regions", 1, true);
    command_ = node_.subscribe<geometry_msgs::Twist>(
        "cmd_vel", 10,
        [this](const geometry_msgs::Twist::ConstPtr& m) {
          world_.command(velocity_of(*m));
          commanded_ = step_;
        },
        ros::VoidConstPtr(), ros::TransportHints().tcpNoDelay());
    static_tf_.sendTransform(transform_message(stamp(), p_.base_frame, p_.laser_frame, p_.laser_pose, p_.laser_height));
    publish_counts();
  }

  void run() {
    Pacer pacer;
    if (p_.follow_clock) join_clock();
    while (ros::ok()) {
      publish();
      if (p_.follow_clock) {
        wait_for_clock(stamp() + ros::Duration(kStep));
      } else {
        pacer.wait(kStep / rate());
      }
      ros::spinOnce();
      const int contacts = world_.contacts();
      const int crossed = world_.regions().crossed();
      world_.advance(kStep);
      ++step_;
      if (contacts != world_.contacts() || crossed != world_.regions().crossed()) publish_counts();
    }
  }

 private:
  // Another node makes the time: this robot begins at the one that it finds.
  static void wait_for_clock(const ros::Time& time) {
    while (ros::ok() && ros::Time::now() < time) ros::WallDuration(0.001).sleep();
  }

  void join_clock() {
    wait_for_clock(ros::Time(kFirstStamp));
    step_ = (ros::Time::now() - ros::Time(kFirstStamp)).toNSec() / kStepNanoseconds;
  }

  // Simulated seconds a second. Where a busy machine does not keep up with a higher one, commands come late; until the
  // next command time passes as in reality.
  double rate() const {
    const std::int64_t since = step_ - commanded_;
    return since > kLateSteps && since < kSilentSteps ? std::min(p_.rate, 1.0) : p_.rate;
  }

  ros::Time stamp() const { return ros::Time(kFirstStamp) + ros::Duration().fromNSec(step_ * kStepNanoseconds); }

  void publish() {
    if (clock_) {
      rosgraph_msgs::Clock clock;
      clock.clock = stamp();
      clock_.publish(clock);
    }
    if (odom_due_(step_)) publish_odometry();
    if (truth_due_(step_)) {
      truth_.publish(odometry_message(stamp(), p_.map_frame, p_.base_frame, world_.pose(), world_.velocity()));
    }
    if (scan_due_(step_)) {
      publish_scan();
      people_.publish(stamp(), world_.movers());
    }
    people_.publish_touches(world_.watch());
  }

  void publish_odometry() {
    const Odometry& odometry = world_.odometry();
    odom_.publish(odometry_message(stamp(), p_.odom_frame, p_.base_frame, odometry.pose(), odometry.velocity()));
    // Perfect localisation: map -> odom takes up the whole drift of the odometry.
    const Pose map_to_odom = compose(world_.pose(), inverse(odometry.pose()));
    tf_.sendTransform({transform_message(stamp(), p_.map_frame, p_.odom_frame, map_to_odom),
                       transform_message(stamp(), p_.odom_frame, p_.base_frame, odometry.pose())});
  }

  void publish_scan() {
    if (scan_.getNumSubscribers() == 0) return;
    people_.scan(world_.map(), p_.laser, compose(world_.pose(), p_.laser_pose), world_.movers(), random_,
                 scan_message_.ranges);
    scan_message_.header.stamp = stamp();
    scan_.publish(scan_message_);
  }

  void publish_counts() {
    std_msgs::UInt32 count;
    count.data = static_cast<std::uint32_t>(world_.contacts());
    contacts_.publish(count);
    count.data = static_cast<std::uint32_t>(world_.regions().crossed());
    crossed_.publish(count);
    regions_.publish(region_markers(stamp(), p_.map_frame, world_.regions()));
    if (world_.in_contact())
      ROS_WARN("contact %d at (%.3f, %.3f)", world_.contacts(), world_.pose().x, world_.pose().y);
  }

  SimNodeParameters p_;
  World world_;
  Random random_;  // of the laser
  Every odom_due_;
  Every truth_due_;
  Every scan_due_;
  sensor_msgs::LaserScan scan_message_;
  std::int64_t step_ = 0;
  std::int64_t commanded_ = -kSilentSteps;  // the step in which the last command came

  ros::NodeHandle node_;
  NodePeople people_;
  ros::Publisher clock_, odom_, truth_, scan_, contacts_, crossed_, regions_;
  ros::Subscriber command_;
  tf2_ros::TransformBroadcaster tf_;
  tf2_ros::StaticTransformBroadcaster static_tf_;
};

}  // namespace
}  // namespace sim
}  // namespace hidwa_local_planner

int main(int argc, char** argv) {
  ros::init(argc, argv, "hidwa_sim");
  const ros::NodeHandle private_node("~");  // outlives the error below: the log ends with the last handle
  try {
    hidwa_local_planner::sim::SimNode node(hidwa_local_planner::sim::read_parameters(private_node));
    node.run();
  } catch (const std::exception& e) {
    ROS_FATAL("%s", e.what());
    return 1;
  }
  return 0;
}
