// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "core/cycle/cycle.hpp"
#include "core/motion/comfort_turn.hpp"
#include "core/motion/rollout.hpp"
#include "core/motion/samples.hpp"

namespace hidwa_local_planner {

/// The candidates of a cycle: samples of the dynamic window (Sampler), and what the robot does with each (Rollout).
/// They come in tiles of equal turn. A candidate's number is its place among the samples.
class Candidates {
 public:
  /// Once per evaluation. `window_limits`: of the dynamic window. While the operator steers, the operator command is a
  /// candidate, too, and so is its blend with autonomy's choice. They are rolled out for `sim_time` [s].
  void make(const Cycle& cycle, const VelocityLimits& window_limits, const Steering& steering,
            const ComfortTurn& comfort, double sim_time);

  std::size_t count() const { return rollout_.candidate_count(); }
  /// What the candidate asks for [m/s, rad/s].
  const Twist2& sample(std::size_t candidate) const { return sampler_.samples()[candidate].u; }
  const Rollout& rollout() const { return rollout_; }
  /// It is the operator command itself, brought into the dynamic window.
  bool is_operator_command(std::size_t candidate) const;
  /// The candidate that is the operator command; where none is, the one nearest to it. -1 where there is none at all.
  int operator_command(const Twist2& u_h) const;

 private:
  int nearest_to(const Twist2& u) const;

  Sampler sampler_;
  Rollout rollout_;
};

}  // namespace hidwa_local_planner
