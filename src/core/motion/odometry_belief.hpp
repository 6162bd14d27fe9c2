// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/motion/velocity_limits.hpp"
#include "hidwa_local_planner/core/parameters.hpp"
#include "hidwa_local_planner/core/types.hpp"

namespace hidwa_local_planner {

/// What a reading of one axis of odometry is to a cycle.
enum class OdometryReading {
  agrees,   // with the commands
  slower,   // than they explain: always believed, a wall or a hardware stop may hold the robot
  doubted,  // faster than they explain, or the other way: a fault, until it has agreed with itself for some time
  faster    // that, and it has: something pushes the robot, or it rolls
};

/// Judges one axis of odometry, reading by reading.
class AxisBelief {
 public:
  /// Fast readings are believed once they have agreed with each other for so long [s]. If later ones do not agree, the
  /// last believed one counts for as long again.
  static constexpr double kLongEnough = 0.3;

  /// `explained`: what the commands explain; `tolerance` [unit/s] beyond it still agrees. `axis`: how fast a velocity
  /// may change.
  OdometryReading judge(double now, double measured, const Interval& explained, double tolerance,
                        const AxisLimits& axis);
  bool sure() const { return sure_; }
  /// The velocity that is believed where judge() said `faster` [unit/s].
  double believed() const { return believed_; }
  void forget() { *this = AxisBelief(); }

  template <typename Self, typename Archive>
  static void archive(Self& self, Archive& io) {
    io(self.fast_, self.since_, self.last_, self.last_time_, self.sure_, self.believed_, self.believed_time_);
  }

 private:
  bool fast_ = false;                            // the last reading was
  double since_ = 0.0;                           // they agree with each other [s]
  double last_ = 0.0, last_time_ = 0.0;          // the last fast one [unit/s], [s]
  bool sure_ = false;                            // one was believed
  double believed_ = 0.0, believed_time_ = 0.0;  // [unit/s], [s]
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

/// Whether a reading is faster than the commands explain, or goes the other way.
bool faster_than_explained(double measured, const Interval& explained, double tolerance);

}  // namespace hidwa_local_planner
