// SPDX-License-Identifier: BSD-3-Clause
#include "person.hpp"

#include <algorithm>
#include <cmath>

namespace hidwa_attack {
namespace {

using hidwa_local_planner::Influence;
using hidwa_local_planner::OperatorStateId;

constexpr double kSightOfRobot = 3.0;  // [m]

double bearing(const Pose2& robot, const Spot& target) {
  return std::remainder(std::atan2(target.y - robot.y, target.x - robot.x) - robot.theta, 2.0 * M_PI);
}

}  // namespace

OperatorIntent Person::want(int now, const Pose2& robot, const Parameters& limits) {
  if (now >= until_) change_mind(now, robot, limits);
  OperatorIntent intent;
  if (steering_ == Steering::nobody || way_ == Way::none) return intent;
  if (way_ == Way::stop) {
    intent.influence = Influence::stop;
    intent.state = OperatorStateId::stopped;
    return intent;
  }
  intent.influence = manual_ ? Influence::direct : Influence::shared;
  intent.state = manual_ ? OperatorStateId::manual : OperatorStateId::shared;
  intent.guarded = true;
  intent.u_h = steer(now, robot, limits);
  return intent;
}

void Person::change_mind(int now, const Pose2& robot, const Parameters& limits) {
  way_ = random_.of({Way::nearest, Way::chosen, Way::chosen, Way::beside, Way::beside, Way::beside, Way::slalom,
                     Way::slalom, Way::at_random, Way::frozen, Way::alternating, Way::none, Way::none, Way::stop});
  if (relentless_ && random_.chance(0.7))
    way_ = random_.of({Way::nearest, Way::chosen, Way::chosen, Way::beside, Way::beside, Way::slalom});
  manual_ = random_.chance(0.5);
  if (steering_ != Steering::either) manual_ = steering_ == Steering::manual;
  turns_first_ = random_.chance(0.5);
  until_ = now + (way_ == Way::stop ? random_.whole(200, 800) : random_.whole(1000, 4000));
  beside_ = random_.in(-0.6, 0.6);
  gain_ = random_.in(1.0, 6.0);
  held_ = full(limits);
  target_ = ahead(robot);
}

Twist2 Person::steer(int now, const Pose2& robot, const Parameters& limits) {
  switch (way_) {
    case Way::nearest:
      return aim(robot, nearest(robot), 0.0, limits);
    case Way::chosen:
      return aim(robot, target_, 0.0, limits);
    case Way::beside:
      return aim(robot, target_, beside_, limits);
    case Way::slalom:
      return wind(now, limits);
    case Way::at_random:
      return any(limits);
    case Way::alternating:
      held_.omega = -held_.omega;
      return held_;
    default:
      return held_;
  }
}

// At full speed, also backwards where that is possible and the shorter way.
Twist2 Person::aim(const Pose2& robot, const Spot& target, double beside, const Parameters& limits) const {
  double off = bearing(robot, target) + std::atan2(beside, std::hypot(target.x - robot.x, target.y - robot.y));
  double speed = limits.max_vel_x;
  if (limits.min_vel_x < 0.0 && std::abs(off) > 0.5 * M_PI) {
    off = std::remainder(off + M_PI, 2.0 * M_PI);
    speed = limits.min_vel_x;
  }
  if (turns_first_ && std::abs(off) > 0.7) speed = 0.0;
  return {speed, std::clamp(gain_ * off, -limits.max_vel_theta, limits.max_vel_theta)};
}

Twist2 Person::wind(int now, const Parameters& limits) {
  if (now >= winds_until_) {
    winds_until_ = now + random_.whole(100, 700);
    held_ = {limits.max_vel_x * random_.of({1.0, 1.0, 0.6}), random_.in(-1.0, 1.0) * limits.max_vel_theta};
  }
  return held_;
}

Twist2 Person::any(const Parameters& limits) {
  const double v = random_.in(limits.min_vel_x, limits.max_vel_x);
  return {v, random_.in(-limits.max_vel_theta, limits.max_vel_theta)};
}

Twist2 Person::full(const Parameters& limits) {
  const double v = random_.of({limits.max_vel_x, limits.max_vel_x, limits.min_vel_x});
  return {v, limits.max_vel_theta * random_.of({-1.0, -0.5, 0.0, 0.5, 1.0})};
}

Spot Person::nearest(const Pose2& robot) const {
  Spot found{robot.x + std::cos(robot.theta), robot.y + std::sin(robot.theta)};
  double least = kSightOfRobot * kSightOfRobot;
  for (int j = world_.cell(robot.y - kSightOfRobot); j <= world_.cell(robot.y + kSightOfRobot); ++j) {
    for (int i = world_.cell(robot.x - kSightOfRobot); i <= world_.cell(robot.x + kSightOfRobot); ++i) {
      if (!world_.lethal(i, j)) continue;
      const double dx = world_.middle(i) - robot.x, dy = world_.middle(j) - robot.y;
      if (dx * dx + dy * dy >= least) continue;
      least = dx * dx + dy * dy;
      found = {world_.middle(i), world_.middle(j)};
    }
  }
  if (walkers_.all().empty()) return found;
  const Walker& walker = walkers_.nearest();
  return std::hypot(walker.p.x - robot.x, walker.p.y - robot.y) < std::sqrt(least) + walker.radius ? walker.p : found;
}

// What a glance somewhere ahead hits.
Spot Person::ahead(const Pose2& robot) {
  const double angle = robot.theta + random_.in(-1.2, 1.2);
  Spot at{robot.x, robot.y};
  for (double way = 0.0; way < 6.0; way += 0.5 * world_.resolution()) {
    at = {robot.x + way * std::cos(angle), robot.y + way * std::sin(angle)};
    if (world_.lethal(world_.cell(at.x), world_.cell(at.y))) break;
  }
  return at;
}

}  // namespace hidwa_attack
