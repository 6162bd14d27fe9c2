// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "core/motion/command_ramp.hpp"
#include "core/motion/pending_motion.hpp"
#include "core/motion/velocity_limits.hpp"
#include "hidwa_local_planner/core/types.hpp"

namespace hidwa_local_planner {

/// The commands that odometry may still show, and the motion of a base that carries them out within its limits. A
/// command takes effect after the latency. The base reaches it within a period, or as fast as the limits allow: see
/// AxisRamp. Allocates nothing after its construction.
class CommandHistory {
 public:
  CommandHistory() { sent_.reserve(kMost); }

  /// A cycle of `period` [s] at `now` [s] begins; `command` was sent last, in the cycle before. What was sent longer
  /// ago than `span` [s] is forgotten, except what was in force then. Where time goes back a period has passed. A
  /// second cycle of the same time takes the place of the first.
  void observe(double now, double period, double span, const Twist2& command, const VelocityLimits& limits);
  void forget();

  std::size_t size() const { return sent_.size(); }
  /// The last command; zero before the first cycle.
  Twist2 last() const { return sent_.empty() ? Twist2{} : sent_.back().command; }
  /// Between the last two cycles [s]; 0 where there are no two.
  double elapsed() const { return elapsed_; }
  /// The smallest and the largest velocity that odometry may show, by axis.
  Interval range(double Twist2::*axis) const;
  /// What the robot does from `age` [s] before the last cycle on until that cycle's own command takes effect. A base
  /// that lags does so since the first of the commands.
  void play(const VelocityLimits& limits, double period, double latency, double age, PendingMotion& pending,
            const Lag& lag = {}) const;

  template <typename Self, typename Archive>
  static void archive(Self& self, Archive& io) {
    io(self.sent_, self.seen_, self.elapsed_);
  }

 private:
  void shift(double by);  // all times [s]

  // As many cycles as the longest latency has at 100 Hz, and some. Beyond them the oldest is forgotten.
  static constexpr std::size_t kMost = 256;

  struct Sent {
    double time = 0.0;  // [s]; of the first one, which nobody knows: when it was found
    Twist2 command;
    Twist2 from;  // the velocity of the base when it takes effect [m/s, rad/s]

    template <typename Self, typename Archive>
    static void archive(Self& self, Archive& io) {
      io(self.time, self.command, self.from);
    }
  };
  std::vector<Sent> sent_;      // oldest first
  std::optional<double> seen_;  // the last cycle [s]
  double elapsed_ = 0.0;        // [s]
};

}  // namespace hidwa_local_planner
