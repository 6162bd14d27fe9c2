// SPDX-License-Identifier: BSD-3-Clause
// The poses of a braking manoeuvre, one after the other, each with how far off a base may be there.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "support/naive_legs.hpp"

namespace hidwa_local_planner::test {

/// `growth`: no point of the robot is farther from where this or a former pose has it [m].
struct NaiveTrailPose {
  Pose2 pose;
  double growth = 0.0;
};

/// Follows legs. With ds and dtheta what the ways to the commands differ by so far, and r the robot's radius:
/// growth = ds + r dtheta + the integral of dtheta over the way; none while it goes straight on in one direction.
class NaiveTrail {
 public:
  NaiveTrail(const Pose2& start, double radius) : q_(start), radius_(radius) {}

  /// In steps in which no point of the robot moves more than `spacing` [m]; returns the poses after them.
  std::vector<NaiveTrailPose> follow(const std::vector<NaiveLeg>& legs, double spacing) {
    std::vector<NaiveTrailPose> poses;
    for (const NaiveLeg& leg : legs) {
      spread_.v += leg.spread.v;
      spread_.omega += leg.spread.omega;
      if (leg.duration <= 0.0 || naive_reach(leg, radius_) <= 1e-12) continue;
      forward_ = forward_ || std::max(leg.from.v, leg.to.v) > 0.0;
      backward_ = backward_ || std::min(leg.from.v, leg.to.v) < 0.0;
      const int n = static_cast<int>(std::ceil(naive_reach(leg, radius_) / spacing));
      for (int k = 0; k < n; ++k) {
        step(leg, (k + 0.5) / n, leg.duration / n);
        poses.push_back({q_, growth()});
      }
    }
    return poses;
  }
  const Pose2& pose() const { return q_; }
  double growth() const {
    const bool off_its_line = turn_ > 0.0 || spread_.omega > 0.0 || (forward_ && backward_);
    return off_its_line ? spread_.v + radius_ * spread_.omega + aside_ : 0.0;
  }

 private:
  void step(const NaiveLeg& leg, double t, double dt) {
    const double v = leg.from.v + (leg.to.v - leg.from.v) * t;
    const double omega = leg.from.omega + (leg.to.omega - leg.from.omega) * t;
    q_.x += v * std::cos(q_.theta + omega * dt / 2) * dt;
    q_.y += v * std::sin(q_.theta + omega * dt / 2) * dt;
    q_.theta += omega * dt;
    aside_ += spread_.omega * std::abs(v) * dt;
    turn_ += std::abs(omega) * dt;
  }

  Pose2 q_;
  double radius_;
  Twist2 spread_;
  double aside_ = 0.0, turn_ = 0.0;  // [m, rad]
  bool forward_ = false, backward_ = false;
};

/// One way in which the robot may go on until a command that is sent now takes effect: what is past since the pose was
/// measured, and what is to come.
struct NaiveOutlook {
  std::vector<NaiveLeg> past, pending;

  Twist2 end() const {
    for (const auto* legs : {&pending, &past}) {
      if (!legs->empty()) return legs->back().to;
    }
    return before;
  }
  /// One axis has this velocity all the time instead.
  NaiveOutlook with(double Twist2::*axis, double velocity) const {
    NaiveOutlook other = *this;
    other.before.*axis = velocity;
    for (auto* legs : {&other.past, &other.pending}) {
      for (NaiveLeg& leg : *legs) {
        leg.from.*axis = leg.to.*axis = velocity;
        leg.spread.*axis = 0.0;
      }
    }
    return other;
  }
  bool rests() const {
    const auto zero = [](const Twist2& u) { return std::abs(u.v) <= 1e-9 && std::abs(u.omega) <= 1e-9; };
    const auto no_motion = [&](const NaiveLeg& leg) { return zero(leg.from) && zero(leg.to); };
    return zero(end()) && std::all_of(past.begin(), past.end(), no_motion) &&
           std::all_of(pending.begin(), pending.end(), no_motion);
  }
  double reach(double radius) const {  // [m]
    double way = 0.0;
    for (const auto* legs : {&past, &pending}) {
      for (const NaiveLeg& leg : *legs) way += naive_reach(leg, radius);
    }
    return way;
  }

  Twist2 before;  // where there are no legs at all
  NaiveLag lag;   // of the base
};

inline NaiveOutlook naive_outlook(const NaiveEffects& effects, double pose_age, double latency) {
  return {pose_age > 0.0 ? naive_legs(effects, -pose_age, 0.0) : std::vector<NaiveLeg>{},
          latency > 0.0 ? naive_legs(effects, 0.0, latency) : std::vector<NaiveLeg>{}, effects.velocity(latency),
          effects.lag()};
}

/// A command that is sent now and then braked, from where the pose was measured.
struct NaiveBraking {
  Pose2 origin;
  NaiveOutlook outlook;
  Twist2 command;                    // [m/s, rad/s]
  double period = 0.05, hold = 0.0;  // [s]
};

inline double naive_braking_reach(const Parameters& p, const NaiveBraking& m, double radius) {
  const Twist2 end = m.outlook.end();
  const double v = std::max(std::abs(end.v), std::abs(m.command.v));
  const double omega = std::max(std::abs(end.omega), std::abs(m.command.omega));
  return m.outlook.reach(radius) + (v + radius * omega) * (2 * m.period + m.hold) + v * v / p.braking_x() / 2 +
         radius * omega * omega / p.braking_theta() / 2;
}

/// The poses to come, at most half a cell apart at `radius` [m]; surely: at most a sixteenth, nearer where the robot
/// hardly moves, and half of that is added to the growth.
inline std::vector<NaiveTrailPose> naive_braking_poses(const Parameters& p, const NaiveBraking& m, double radius,
                                                       double cell, bool surely) {
  const auto spacing = [&](double reach) { return surely ? std::max(1e-4, std::min(reach / 8, cell / 16)) : cell / 2; };
  NaiveTrail trail(m.origin, radius);
  trail.follow(m.outlook.past, cell);
  const double first = spacing(m.outlook.reach(radius)), second = spacing(naive_braking_reach(p, m, radius));
  std::vector<NaiveTrailPose> poses = trail.follow(m.outlook.pending, first);
  const std::size_t sent = poses.size();
  for (const NaiveTrailPose& pose :
       trail.follow(naive_brake_legs(p, m.period, m.outlook.end(), m.command, m.hold, false, m.outlook.lag), second)) {
    poses.push_back(pose);
  }
  for (std::size_t k = 0; surely && k < poses.size(); ++k) poses[k].growth += (k < sent ? first : second) / 2;
  return poses;
}

}  // namespace hidwa_local_planner::test
