// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <deque>

#include "hidwa_local_planner/core/types.hpp"
#include "random.hpp"

namespace hidwa_attack {

using hidwa_local_planner::Pose2;
using hidwa_local_planner::Twist2;

/// What a base can do on one axis [unit/s^2].
struct AxisPower {
  double acc = 1.0;  // away from rest
  double dec = 1.0;  // towards it
};

/// How long a change of velocity takes at the limits [s].
double time_between(const AxisPower& power, double from, double to);
/// The velocity after `dt` [s] at the limits, never beyond `to`.
double after(const AxisPower& power, double from, double to, double dt);

/// One axis on its way to a command.
class AxisDrive {
 public:
  explicit AxisDrive(const AxisPower& power) : power_(power) {}
  /// Begins to reach `to` within `period` [s], where the limits allow. `share` 0: at once at the limits, 1: evenly over
  /// the period, between: that mixture of both.
  void begin(double to, double period, double share);
  void step(double dt);
  double now() const { return now_; }

 private:
  double wanted() const;

  AxisPower power_;
  double from_ = 0.0, to_ = 0.0, now_ = 0.0;         // [unit/s]
  double since_ = 0.0, period_ = 0.0, share_ = 0.0;  // [s], [s], [0, 1]
};

/// How commands are reached. `either`: each command and axis evenly or at the limit, nothing between.
enum class Reaching { evenly, at_limit, anyhow, either };

/// A base that takes each command up after a pure delay and drives a unicycle's way.
class Base {
 public:
  struct Make {
    AxisPower x, theta;
    double period = 0.05;         // within which it reaches commands [s]
    int latency = 100;            // [ms]
    bool latency_varies = false;  // each command's own is between 0 and that; none overtakes another
    Reaching reaching = Reaching::evenly;
    double slip = 0.0;  // what is driven is off from what the wheels do by up to this share
  };
  Base(const Make& make, const Pose2& start, std::uint64_t seed)
      : make_(make), x_(make.x), theta_(make.theta), pose_(start), random_(seed) {}

  /// `now` [ms].
  void send(int now, const Twist2& command);
  /// Drives from `now` [ms] for one millisecond.
  void step(int now);
  const Pose2& pose() const { return pose_; }
  Twist2 velocity() const { return {x_.now(), theta_.now()}; }

 private:
  void take_up(const Twist2& command);
  double share();
  void slip(int now);

  struct Pending {
    int effect = 0;  // [ms]
    Twist2 command;
  };
  Make make_;
  AxisDrive x_, theta_;
  Pose2 pose_;
  Random random_;
  double slips_x_ = 1.0, slips_theta_ = 1.0;
  std::deque<Pending> pending_;
};

}  // namespace hidwa_attack
