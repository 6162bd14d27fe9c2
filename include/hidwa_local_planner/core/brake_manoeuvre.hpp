// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "hidwa_local_planner/core/command_ramp.hpp"
#include "hidwa_local_planner/core/rotation.hpp"
#include "hidwa_local_planner/core/types.hpp"
#include "hidwa_local_planner/core/under_way.hpp"
#include "hidwa_local_planner/core/velocity_limits.hpp"

namespace hidwa_local_planner {

/// What happens when a command is sent and the next one already brakes: what is under way for the latency, one period's
/// ramp to the command (CommandRamp), then both axes at their braking limits until rest.
struct BrakeManoeuvre {
  Pose2 start;                // costmap frame
  const UnderWay& under_way;  // ends where the ramp to the command begins
  Twist2 command;             // [m/s, rad/s]
  double period = 0.05;       // [s]

  /// How far from its start the robot's centre can get [m].
  double reach(const VelocityLimits& limits) const {
    const double fastest = std::max(std::abs(under_way.end().v), std::abs(command.v));
    return under_way.reach() + fastest * period + limits.x.distance_to_rest(command.v);
  }
};

/// A pose and its heading's cosine and sine.
struct TurnedPose {
  Pose2 pose;
  Rotation heading;
};

/// Rolls manoeuvres out pose by pose, from one pose on.
class ManoeuvreRoller {
 public:
  /// No point within `radius` [m] of the robot's centre moves more than `spacing` [m] between two poses.
  ManoeuvreRoller(const VelocityLimits& limits, double radius, double spacing, const TurnedPose& start)
      : limits_(limits), radius_(radius), spacing_(spacing), at_(start) {}

  /// Calls visit(TurnedPose) for the poses after the start until it returns false, the last one at rest, none when it
  /// does not move at all. Returns what the last visit did.
  template <typename Visit>
  bool roll(const BrakeManoeuvre& manoeuvre, Visit&& visit) {
    return roll_on(manoeuvre.under_way, visit) && roll_to_rest(manoeuvre, visit);
  }

  /// Its first part, the same whatever the command is.
  template <typename Visit>
  bool roll_on(const UnderWay& under_way, Visit&& visit) {
    u_ = under_way.begin();
    for (const UnderWay::Leg& leg : under_way.legs()) {
      if (!stretch(leg.end, leg.duration, visit)) return false;
    }
    return true;
  }

  /// The rest of it, from where the first part ends.
  template <typename Visit>
  bool roll_to_rest(const BrakeManoeuvre& manoeuvre, Visit&& visit) {
    u_ = manoeuvre.under_way.end();
    return roll_ramp(CommandRamp(limits_, u_, manoeuvre.command, manoeuvre.period), visit) && brake(visit);
  }

  /// Likewise with a base that reaches the command evenly over the period.
  template <typename Visit>
  bool roll_evenly_to_rest(const BrakeManoeuvre& manoeuvre, Visit&& visit) {
    u_ = manoeuvre.under_way.end();
    return stretch(manoeuvre.command, manoeuvre.period, visit) && brake(visit);
  }

  /// The last pose.
  const TurnedPose& at() const { return at_; }

 private:
  template <typename Visit>
  bool brake(Visit&& visit) {
    // Both axes to rest, each at its own limit: one of them may rest before the other.
    const double first = std::min(limits_.x.time_to_rest(u_.v), limits_.theta.time_to_rest(u_.omega));
    const Twist2 then{limits_.x.ramp(u_.v, 0.0, first), limits_.theta.ramp(u_.omega, 0.0, first)};
    if (!stretch(then, first, visit)) return false;
    const double rest = std::max(limits_.x.time_to_rest(u_.v), limits_.theta.time_to_rest(u_.omega));
    return stretch({}, rest, visit);
  }

  // Evenly where that is no more than half the spacing off.
  template <typename Visit>
  bool roll_ramp(const CommandRamp& ramp, Visit&& visit) {
    const double period = ramp.corners().back();
    if (ramp.ahead(radius_) <= 0.5 * spacing_) return stretch(ramp.at(period), period, visit);
    double from = 0.0;
    for (const double corner : ramp.corners()) {
      if (!stretch(ramp.at(corner), corner - from, visit)) return false;
      from = corner;
    }
    return true;
  }
  // One stretch of `duration` [s] in which both axes change evenly from the current velocity to `end`.
  template <typename Visit>
  bool stretch(const Twist2& end, double duration, Visit&& visit) {
    if (duration <= 0.0) return true;
    const double fastest = std::max(std::abs(u_.v), std::abs(end.v)) +
                           radius_ * std::max(std::abs(u_.omega), std::abs(end.omega));
    const Twist2 begin = u_;
    u_ = end;
    if (fastest * duration <= 1e-12) return true;
    const int steps = static_cast<int>(std::ceil(fastest * duration / spacing_));
    const double dt = duration / steps;
    for (int k = 0; k < steps; ++k) {
      const double middle = (k + 0.5) / steps;
      const double v = begin.v + middle * (end.v - begin.v);
      const double turn = (begin.omega + middle * (end.omega - begin.omega)) * dt;
      const Rotation half = Rotation::of(0.5 * turn);
      const Rotation direction = at_.heading.turned(half);
      at_.pose.x += v * direction.c * dt;
      at_.pose.y += v * direction.s * dt;
      at_.pose.theta += turn;
      at_.heading = direction.turned(half);
      if (!visit(static_cast<const TurnedPose&>(at_))) return false;
    }
    return true;
  }

  const VelocityLimits& limits_;
  double radius_, spacing_;
  TurnedPose at_;
  Twist2 u_;
};

/// The poses of a manoeuvre after its start, see ManoeuvreRoller.
void roll_out(const BrakeManoeuvre& manoeuvre, const VelocityLimits& limits, double radius, double spacing,
              std::vector<Pose2>& poses);

}  // namespace hidwa_local_planner
