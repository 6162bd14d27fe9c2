// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "hidwa_local_planner/core/parameters.hpp"
#include "hidwa_local_planner/core/types.hpp"
#include "hidwa_local_planner/core/under_way.hpp"
#include "hidwa_local_planner/core/velocity_limits.hpp"

namespace hidwa_local_planner {

/// The commands that odometry may still show: a command takes effect after the latency and is reached a period later.
/// Allocates nothing after its construction.
class CommandHistory {
 public:
  CommandHistory() { sent_.reserve(kMost); }

  /// A cycle of `period` [s] at `now` [s] finds that `command` was sent last: in the cycle before, as far as is known.
  /// What was sent longer ago than `latency` [s] and a period is forgotten, except what was in force then. All that was
  /// sent before is forgotten where time goes back, and where `command` lies farther from it than `limits` allow in a
  /// period: the robot cannot have followed that, so that its odometry must show where it is. A second cycle of the same
  /// time takes the place of the first.
  void observe(double now, double period, double latency, const Twist2& command, const VelocityLimits& limits);
  void forget();

  std::size_t size() const { return sent_.size(); }
  /// The last command; zero before the first cycle.
  Twist2 last() const { return sent_.empty() ? Twist2{} : sent_.back().command; }
  /// The smallest and the largest of them, by axis.
  Interval range(double Twist2::* axis) const;
  /// What the robot does from the last cycle on until that cycle's own command takes effect: it reaches each of them
  /// within `period` [s] after that took effect, before the next one does, see CommandRamp.
  void play(const VelocityLimits& limits, double period, double latency, UnderWay& under_way) const;

  template <typename Self, typename Archive>
  static void archive(Self& self, Archive& io) {
    io(self.sent_, self.seen_);
  }

 private:
  // As many cycles as the longest latency has at 100 Hz, and some. Beyond them the oldest is forgotten.
  static constexpr std::size_t kMost = 256;

  struct Sent {
    double time = 0.0;  // [s]; of the first one, which nobody knows: when it was found
    Twist2 command;

    template <typename Self, typename Archive>
    static void archive(Self& self, Archive& io) {
      io(self.time, self.command);
    }
  };
  std::vector<Sent> sent_;      // oldest first
  std::optional<double> seen_;  // the last cycle [s]
};

/// Whether a cycle starts from the last command: odometry agrees. It does where on each axis it lies within the tolerance
/// of a velocity between the commands that it may still show.
bool goes_on(const Parameters& parameters, const Twist2& measured, const CommandHistory& commands);

/// Where a cycle starts from: the last command while odometry agrees, else odometry.
Twist2 velocity_reference(const Parameters& parameters, const Twist2& measured, const CommandHistory& commands);

}  // namespace hidwa_local_planner
