// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <vector>

#include "sim/contact.hpp"
#include "sim/drive_prediction.hpp"
#include "sim/grid_route.hpp"
#include "sim/laser.hpp"
#include "sim/operator.hpp"
#include "sim/world.hpp"

namespace hidwa_local_planner {
namespace sim {

/// A plain stand-in for the planner, for tests of the simulation alone: pure pursuit of a route made anew
/// every second; the stick turns the robot at full speed; after a release it goes straight on for `hold`
/// seconds; arcs that would hit something within 1.7 s are refused.
class StandIn {
 public:
  StandIn(const OccupancyMap& map, const Polygon& footprint, const GridRoute& routes, const RobotHabits& habits)
      : map_(map), footprint_(footprint), routes_(routes), habits_(habits) {}

  const Route& plan() const { return plan_; }

  /// Makes the route anew where a second has passed; returns whether it did.
  bool replan(double now, const Pose& pose) {
    if (now < next_plan_) return false;
    plan_ = routes_.from({pose.x, pose.y});
    position_ = 0;
    next_plan_ = now + 1.0;
    return true;
  }

  Velocity command(double now, const Pose& pose, const Stick& stick) {
    const double asked = asked_omega(stick.left, habits_);
    if (asked != 0.0) {
      released_ = now;
      return nearest_free(pose, asked);
    }
    if (now < released_ + habits_.hold_time) {
      if (is_free(pose, habits_.max_vel_x, 0.0)) return {habits_.max_vel_x, 0.0};
      released_ = -std::numeric_limits<double>::infinity();
    }
    return pursue(pose);
  }

 private:
  bool is_free(const Pose& pose, double v, double omega) const {
    Pose at = pose;
    for (double t = 0.0; t < habits_.refusal_time; t += 0.1) {
      at = moved(at, {v * 0.1, omega * 0.1});
      if (overlaps_occupied(map_, transformed(footprint_, at))) return false;
    }
    return true;
  }

  Velocity nearest_free(const Pose& pose, double asked) {
    for (double off = 0.0; off <= 2.0 * habits_.max_vel_theta; off += 0.05) {
      for (const double omega : {asked + off, asked - off}) {
        if (std::abs(omega) <= habits_.max_vel_theta && is_free(pose, habits_.max_vel_x, omega)) {
          return {habits_.max_vel_x, omega};
        }
      }
    }
    return pursue(pose);
  }

  Velocity pursue(const Pose& pose) {
    if (plan_.empty()) return Velocity();
    position_ = nearest_index(plan_, position_, 2.0, pose.x, pose.y);
    std::size_t aim = position_;
    const auto distance = [&](std::size_t i) { return std::hypot(plan_[i].x() - pose.x, plan_[i].y() - pose.y); };
    while (aim + 1 < plan_.size() && distance(aim) < habits_.pursuit) ++aim;
    const double turn = normalized(std::atan2(plan_[aim].y() - pose.y, plan_[aim].x() - pose.x) - pose.theta);
    if (std::abs(turn) > 0.9) return {0.0, std::copysign(habits_.max_vel_theta, turn)};
    const double omega = 2.0 * habits_.max_vel_x * std::sin(turn) / std::max(distance(aim), 0.1);
    return {habits_.max_vel_x, std::clamp(omega, -habits_.max_vel_theta, habits_.max_vel_theta)};
  }

  const OccupancyMap& map_;
  Polygon footprint_;
  const GridRoute& routes_;
  RobotHabits habits_;
  Route plan_;
  std::size_t position_ = 0;
  double next_plan_ = -std::numeric_limits<double>::infinity();  // [s]
  double released_ = -std::numeric_limits<double>::infinity();   // [s]
};

struct DriveResult {
  bool arrived = false;
  double active = 0.0;         // [s], stick out of its dead zone
  std::vector<Pose> path;      // every 0.05 s
  std::vector<double> sticks;  // likewise, left
};

/// Drives the stand-in at 20 Hz, a scan each time included, until the goal is 0.3 m away or `patience` [s]
/// are over. `on_plan` is told each new plan.
inline DriveResult drive(World& world, const GridRoute& routes, const Eigen::Vector2d& goal, const RobotHabits& habits,
                         Operator& person, const std::function<void(const Route&)>& on_plan, double patience) {
  StandIn planner(world.map(), world.footprint(), routes, habits);
  DriveResult result;
  const RayCaster caster(world.map());
  Random noise(1);
  std::vector<float> ranges;
  while (world.time() < patience && !result.arrived) {
    if (planner.replan(world.time(), world.pose())) on_plan(planner.plan());
    const Stick stick = person.update({world.time(), world.pose(), world.velocity()});
    world.command(planner.command(world.time(), world.pose(), stick));
    scan(caster, LaserSpec(), world.pose(), noise, ranges);
    world.advance(0.05);
    result.path.push_back(world.pose());
    result.sticks.push_back(stick.left);
    result.active += asked_omega(stick.left, habits) != 0.0 ? 0.05 : 0.0;
    result.arrived = std::hypot(goal.x() - world.pose().x, goal.y() - world.pose().y) < 0.3;
  }
  return result;
}

}  // namespace sim
}  // namespace hidwa_local_planner
