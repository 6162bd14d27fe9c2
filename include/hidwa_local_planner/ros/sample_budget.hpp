// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

#include "hidwa_local_planner/core/planner.hpp"

namespace hidwa_local_planner {

/// How many samples the cycles can afford. Thins both axes in proportion as soon as three of the last five
/// cycles were too long, so that one page fault changes nothing; brings samples back step by step after a
/// calm while, when even a step more would leave room. Knows no clock: the same durations give the same
/// samples.
class SampleBudget {
 public:
  enum class Event { none, thinning_began, thinning_ended };

  /// Takes the samples wanted. Other ones than before are in force at once, in full.
  void configure(const Sampling& full);
  /// A cycle with the samples in force took `duration` [s] of `budget` [s]; a negative budget never thins.
  Event observe(double duration, double budget);

  const Sampling& in_force() const { return in_force_; }
  const Sampling& full() const { return full_; }
  bool thinned() const { return level_ > 0; }

 private:
  int last_level() const;
  Sampling at(int level) const;
  double candidates(int level) const;
  Event move_to(int level);
  Event thin(double typical, double budget);
  Event restore(double duration, double budget);

  Sampling full_;
  Sampling in_force_;
  int level_ = 0;  // 0: all samples; each further level has one pair fewer on the axis that has more to lose
  std::array<double, 5> recent_{};  // durations with the samples in force, a ring [s]
  std::size_t next_ = 0;
  int calm_ = 0;      // cycles with room for the next level down; an exception costs half a patience
  int patience_ = 0;  // calm cycles before samples come back; grows when they came back too early
  bool came_back_ = false;
};

/// What thinned samples mean, with the remedy; empty while all are in force. `budget` [s].
std::string thinning_complaint(const Sampling& in_force, const Sampling& full, double budget);

}  // namespace hidwa_local_planner
