// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/motion/velocity_limits.hpp"
#include "hidwa_local_planner/core/parameters.hpp"
#include "hidwa_local_planner/core/types.hpp"

namespace hidwa_local_planner {

/// What a reading of one axis of odometry is to a cycle.
enum class OdometryReading {
  agrees,        // with the commands
  maybe_slower,  // than they explain: a fault, or else a wall or a hardware stop holds the robot
  slower,        // than they explain, and so were readings before it: something holds the robot
  doubted,       // faster than they explain, or the other way: a fault, until it has agreed with itself for some time
  faster         // that, and it has: something pushes the robot, or it rolls
};

/// Judges one axis of odometry, reading by reading.
class AxisBelief {
 public:
  /// Fast readings are believed once they have agreed with each other for so long [s]. If later ones do not agree, the
  /// last believed one counts for as long again.
  static constexpr double kLongEnough = 0.3;
  /// Slow readings are believed once so many in a row agree with each other.
  static constexpr int kEnough = 3;

  /// `heard`: when the reading came [s], since a cycle may find the same again. `explained`: what the commands explain;
  /// `tolerance` [unit/s] beyond it still agrees. `axis`: how fast a velocity may change.
  OdometryReading judge(double now, double heard, double measured, const Interval& explained, double tolerance,
                        const AxisLimits& axis);
  bool sure() const { return sure_; }
  /// The velocity that is believed where judge() said `faster` [unit/s].
  double believed() const { return believed_; }
  /// The velocity that is believed where odometry reads `measured` between two cycles; `last` where that is doubted.
  double believed(double measured, const Interval& explained, double tolerance, double last) const;
  void forget() { *this = AxisBelief(); }

  template <typename Self, typename Archive>
  static void archive(Self& self, Archive& io) {
    io(self.fast_, self.since_, self.last_, self.last_time_, self.sure_, self.believed_, self.believed_time_,
       self.slow_);
  }

 private:
  bool note_slow(double heard, double measured, double tolerance, const AxisLimits& axis);

  bool fast_ = false;                            // the last reading was
  double since_ = 0.0;                           // they agree with each other [s]
  double last_ = 0.0, last_time_ = 0.0;          // the last fast or slow one [unit/s], [s]
  bool sure_ = false;                            // one was believed
  double believed_ = 0.0, believed_time_ = 0.0;  // [unit/s], [s]
  int slow_ = 0;                                 // so many slow ones agreed with each other, up to kEnough
};

/// Both axes.
struct OdometryBelief {
  AxisBelief v, omega;

  void forget() { *this = OdometryBelief(); }
  template <typename Self, typename Archive>
  static void archive(Self& self, Archive& io) {
    io(self.v, self.omega);
  }
};

/// How far beyond what the commands explain a reading still agrees, by axis [m/s, rad/s]. `last`: the last command.
Twist2 reading_tolerance(const Parameters& parameters, const Twist2& last);

}  // namespace hidwa_local_planner
