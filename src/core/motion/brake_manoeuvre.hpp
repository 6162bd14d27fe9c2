// SPDX-License-Identifier: BSD-3-Clause
// What happens when a command is sent and the next ones brake, and how far off a real base may be.
//
// 1. The pending motion comes first.
// 2. The command is reached within a period (AxisRamp) and then held until the first command to brake takes effect.
// 3. Both axes brake at their limits. The last command to brake asks for less than a period's worth, and may be carried
//    out evenly over a period: the tail.
//
// A base may reach every command in its own way between two ends (AxisRamp). Let p_n, theta_n be the motion that is
// rolled out and p, theta any other, and let
//   ds = integral of |v - v_n|,  dtheta = integral of |omega - omega_n|.
// Compared at equal times, |theta - theta_n| <= dtheta and |p - p_n| <= ds + integral of |v_n| |theta - theta_n|. A
// point of the robot at radius r moves by r times the difference of headings more. So no point of it is farther from
// where the rolled-out motion has it than
//   growth = ds + r dtheta + integral of |v_n| dtheta.
// The ways to a command part when it takes effect, those to rest when less than a period's worth of braking is left.
// While nothing has turned and v has not changed its sign, the other motion is on the same line, only behind, since v_n
// is the farthest: an earlier pose is the same, and the growth is 0. So it is at rest.
//
// Where there is no room for the growth, the other ends are rolled out too (Lag): of a base that gets less far on one
// axis or on both. The other ways lie between these four. One that lags has no growth.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "core/motion/command_ramp.hpp"
#include "core/motion/pending_motion.hpp"
#include "core/motion/velocity_limits.hpp"
#include "core/util/rotation.hpp"
#include "hidwa_local_planner/core/types.hpp"

namespace hidwa_local_planner {

struct BrakeManoeuvre {
  Pose2 start;                   // where `pending` begins, costmap frame
  const PendingMotion& pending;  // until the command takes effect
  Twist2 command;                // [m/s, rad/s]
  double period = 0.05;          // of the control cycle [s]
  double hold = 0.0;             // longer than a period until the first command to brake takes effect [s]

  /// How far from its start a point `radius` [m] from the robot's centre can get [m], without the growth.
  double reach(const VelocityLimits& limits, double radius = 0.0) const {
    const double v = std::max(std::abs(pending.end().v), std::abs(command.v));
    const double omega = radius > 0.0 ? std::max(std::abs(pending.end().omega), std::abs(command.omega)) : 0.0;
    return pending.reach(radius) + (v + radius * omega) * (2.0 * period + hold) + limits.x.distance_to_rest(v) +
           radius * limits.theta.distance_to_rest(omega);
  }
};

/// The last part of braking: this much [unit/s] is braked evenly over a period. No other remainder gets farther.
inline double brake_tail(const AxisLimits& axis, double velocity, double period) {
  return std::min(std::abs(velocity), 0.5 * axis.braking * period);
}

/// How far apart the ways to brake the tail get, at most [unit].
inline double tail_spread(const AxisLimits& axis, double velocity, double period) {
  const double tail = brake_tail(axis, velocity, period);
  return 0.5 * tail * (period - tail / axis.braking);
}

/// Rolls manoeuvres out pose by pose, from one pose on.
class ManoeuvreRoller {
 public:
  /// No point within `radius` [m] of the robot's centre moves more than `spacing` [m] between two poses, which are no
  /// more than `longest_step` [s] apart.
  ManoeuvreRoller(const VelocityLimits& limits, double radius, double spacing, const TurnedPose& start,
                  double longest_step = std::numeric_limits<double>::infinity())
      : limits_(&limits), radius_(radius), spacing_(spacing), longest_step_(longest_step), at_(start) {}

  /// Calls visit(TurnedPose) for the poses after the start until it returns false, the last one at rest, none when it
  /// does not move at all. Returns what the last visit did.
  template <typename Visit>
  bool roll(const BrakeManoeuvre& manoeuvre, Visit&& visit) {
    return roll_on(manoeuvre.pending, visit) && roll_to_rest(manoeuvre, visit);
  }

  /// Its first part, the same whatever the command is. What is past is not visited.
  template <typename Visit>
  bool roll_on(const PendingMotion& pending, Visit&& visit) {
    roll_past(pending);
    for (std::size_t i = pending.past(); i < pending.legs().size(); ++i) {
      const PendingMotion::Leg& leg = pending.legs()[i];
      part(leg.spread);
      if (!stretch(leg.end, leg.duration, visit)) return false;
    }
    return true;
  }
  void roll_past(const PendingMotion& pending) {
    u_ = pending.begin();
    for (std::size_t i = 0; i < pending.past(); ++i) {
      const PendingMotion::Leg& leg = pending.legs()[i];
      part(leg.spread);
      stretch(leg.end, leg.duration, [](const TurnedPose&) { return true; });
    }
    time_ = 0.0;
  }
  /// From here on.
  void set_spacing(double spacing) { spacing_ = spacing; }

  /// The rest of it, from where the first part ends.
  template <typename Visit>
  bool roll_to_rest(const BrakeManoeuvre& manoeuvre, Visit&& visit) {
    u_ = manoeuvre.pending.end();
    const Lag& lag = manoeuvre.pending.lag();
    const CommandRamp ramp(*limits_, u_, manoeuvre.command, manoeuvre.period, lag);
    const double length = manoeuvre.period + manoeuvre.hold;
    part(ramp.spread(length));
    double from = 0.0;
    for (const double corner : ramp.corners(length)) {
      if (!stretch(ramp.at(corner), corner - from, visit)) return false;
      from = corner;
    }
    return roll_brake(manoeuvre.period, visit, lag);
  }

  /// Likewise with a base that reaches the command evenly over the period, where its limits allow that.
  template <typename Visit>
  bool roll_evenly_to_rest(const BrakeManoeuvre& manoeuvre, Visit&& visit) {
    u_ = manoeuvre.pending.end();
    const CommandRamp ramp(*limits_, u_, manoeuvre.command, manoeuvre.period);
    return stretch(ramp.at(manoeuvre.period), manoeuvre.period, visit) &&
           stretch(ramp.at(manoeuvre.period + manoeuvre.hold), manoeuvre.hold, visit) &&
           roll_brake(manoeuvre.period, visit);
  }

  /// The last pose.
  const TurnedPose& at() const { return at_; }
  /// When it is there [s]: 0 is where the first part begins, or where what is past of it ends.
  double time() const { return time_; }
  /// The step that led there.
  struct Step {
    double duration = 0.0;  // [s]
    double fastest = 0.0;   // no point within the radius moves faster [m/s]
  };
  const Step& step() const { return step_; }
  /// How far a point within the radius may be from where the last pose has it, at the same time [m].
  double drift() const { return spread_.v + radius_ * spread_.omega + sideways_; }
  /// How far a point within the radius may be from where some pose so far has it [m].
  double growth() const {
    const bool straight = !turned_ && spread_.omega <= 0.0 && !(forward_ && backward_);
    return straight ? 0.0 : spread_.v + radius_ * spread_.omega + sideways_;
  }

 private:
  // The ways of the robot part by so much.
  void part(const Twist2& spread) {
    spread_.v += spread.v;
    spread_.omega += spread.omega;
  }

  // An axis on its way to rest: at its limit, then the tail. One that lags has no tail.
  struct AxisBrake {
    AxisBrake(const AxisLimits& axis, double begin, double period, bool lags)
        : velocity(begin),
          tail(lags ? 0.0 : std::copysign(brake_tail(axis, begin, period), begin)),
          steady((std::abs(begin) - std::abs(tail)) / axis.braking),
          rest(begin == 0.0 || lags ? steady : steady + period) {}
    double at(double t) const {
      if (t >= rest) return 0.0;
      return t < steady ? velocity + (tail - velocity) * t / steady : tail * (rest - t) / (rest - steady);
    }
    double velocity, tail;  // [unit/s]
    double steady, rest;    // until when at its limit, and until it rests [s]
  };

  // From `begin` [s] on the last command to brake may be carried out in its own way.
  struct Tail {
    double begin, spread;
    double parts_until(double end) { return end > begin ? std::exchange(spread, 0.0) : 0.0; }
  };

  // Each axis at its own limit: one of them may rest before the other.
  template <typename Visit>
  bool roll_brake(double period, Visit&& visit, const Lag& lag = {}) {
    const AxisBrake v(limits_->x, u_.v, period, lag.v), omega(limits_->theta, u_.omega, period, lag.omega);
    const Twist2 spread =
        lag.any() ? Twist2{}
                  : Twist2{tail_spread(limits_->x, u_.v, period), tail_spread(limits_->theta, u_.omega, period)};
    Tail tail_v{v.steady - 0.5 * period, spread.v}, tail_omega{omega.steady - 0.5 * period, spread.omega};
    std::array<double, 4> corners{v.steady, v.rest, omega.steady, omega.rest};
    std::sort(corners.begin(), corners.end());
    double from = 0.0;
    for (const double corner : corners) {
      part({tail_v.parts_until(corner), tail_omega.parts_until(corner)});
      if (!stretch({v.at(corner), omega.at(corner)}, corner - from, visit)) return false;
      from = corner;
    }
    return true;
  }

  // One stretch of `duration` [s] in which both axes change evenly from the current velocity to `end`.
  template <typename Visit>
  bool stretch(const Twist2& end, double duration, Visit&& visit) {
    if (duration <= 0.0) return true;
    const double fastest =
        std::max(std::abs(u_.v), std::abs(end.v)) + radius_ * std::max(std::abs(u_.omega), std::abs(end.omega));
    const Twist2 begin = u_;
    u_ = end;
    if (fastest * duration <= 1e-12) {
      time_ += duration;
      return true;
    }
    forward_ = forward_ || begin.v > 0.0 || end.v > 0.0;
    backward_ = backward_ || begin.v < 0.0 || end.v < 0.0;
    const int steps = static_cast<int>(std::ceil(std::max(fastest * duration / spacing_, duration / longest_step_)));
    const double dt = duration / steps;
    step_ = {dt, fastest};
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
      sideways_ += std::abs(v) * dt * spread_.omega;
      turned_ = turned_ || turn != 0.0;
      time_ += dt;
      if (!visit(static_cast<const TurnedPose&>(at_))) return false;
    }
    return true;
  }

  const VelocityLimits* limits_;
  double radius_, spacing_, longest_step_;
  double time_ = 0.0;  // [s]
  Step step_;
  TurnedPose at_;
  Twist2 u_;
  Twist2 spread_;                                             // so far [m, rad]
  double sideways_ = 0.0;                                     // what a way in another direction leads off [m]
  bool turned_ = false, forward_ = false, backward_ = false;  // it moved so
};

}  // namespace hidwa_local_planner
