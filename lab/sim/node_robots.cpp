// SPDX-License-Identifier: BSD-3-Clause
#include "node_robots.hpp"

#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <nav_msgs/Odometry.h>
#include <ros/subscriber.h>

namespace hidwa_local_planner {
namespace sim {
namespace {

constexpr std::uint32_t kFirstId = 1000;  // people's are below

class WithRobots : public People {
 public:
  WithRobots(std::shared_ptr<People> people, const std::vector<std::string>& topics, double radius)
      : people_(std::move(people)), robots_(topics.size()), known_(topics.size(), false) {
    for (std::size_t i = 0; i < topics.size(); ++i) {
      robots_[i].id = kFirstId + static_cast<std::uint32_t>(i);
      robots_[i].radius = radius;
      listeners_.push_back(node_.subscribe<nav_msgs::Odometry>(
          topics[i], 1, [this, i](const nav_msgs::Odometry::ConstPtr& message) { take(i, *message); },
          ros::VoidConstPtr(), ros::TransportHints().tcpNoDelay()));
    }
  }

  void advance(double time, const RobotSeen& robot) override {
    movers_.clear();
    if (people_) {
      people_->advance(time, robot);
      movers_ = people_->movers();
    }
    for (std::size_t i = 0; i < robots_.size(); ++i) {
      if (known_[i]) movers_.push_back(robots_[i]);
    }
  }

 private:
  void take(std::size_t i, const nav_msgs::Odometry& message) {
    const geometry_msgs::Quaternion& q = message.pose.pose.orientation;
    const double yaw = std::atan2(2.0 * (q.w * q.z + q.x * q.y), 1.0 - 2.0 * (q.y * q.y + q.z * q.z));
    const double v = message.twist.twist.linear.x;
    robots_[i].position = {message.pose.pose.position.x, message.pose.pose.position.y};
    robots_[i].velocity = {v * std::cos(yaw), v * std::sin(yaw)};
    robots_[i].heading = yaw;
    known_[i] = true;
  }

  std::shared_ptr<People> people_;  // or null
  std::vector<Mover> robots_;
  std::vector<bool> known_;
  ros::NodeHandle node_;
  std::vector<ros::Subscriber> listeners_;
};

}  // namespace

std::shared_ptr<People> with_robots(const ros::NodeHandle& node, std::shared_ptr<People> people) {
  std::vector<std::string> topics;
  if (node.hasParam("robots") && !node.getParam("robots", topics)) {
    throw std::runtime_error("parameter ~robots must be a list of topics");
  }
  const double radius = node.param("robots_radius", 0.3);
  if (!(radius > 0.0 && std::isfinite(radius))) throw std::runtime_error("parameter ~robots_radius must be positive");
  if (topics.empty()) return people;
  return std::make_shared<WithRobots>(std::move(people), topics, radius);
}

}  // namespace sim
}  // namespace hidwa_local_planner
