// SPDX-License-Identifier: BSD-3-Clause
// How many samples the cycles can afford. The step of the control loop takes the counts and knows no clock; whoever
// measures cycles tells the durations here. The same durations give the same counts.
//
// 1. Where three of the last five cycles took longer than the budget, both axes are thinned in proportion, so that a
//    cycle is expected to take 0.7 of the budget. Two outliers in five (a page fault) change nothing.
// 2. After a calm while samples come back in small steps, as long as a step more is expected to take less than 0.8 of
//    the budget: between 0.7 and 0.8 the counts rest.
// 3. Where a return is followed by thinning, the next one waits twice as long: under a constant load the counts settle.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

#include "hidwa_local_planner/core/parameters.hpp"
#include "hidwa_local_planner/core/situation.hpp"

namespace hidwa_local_planner {

class SampleBudget {
 public:
  enum class Event { none, thinning_began, thinning_ended };

  /// The samples to take where there is time. Other ones than before are in force at once, in full.
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
  int calm_ = 0;      // cycles with time for the next level down; an exception costs half a patience
  int patience_ = 0;  // calm cycles before samples come back; grows when they came back too early
  bool came_back_ = false;
};

/// The samples that the parameters ask for.
Sampling configured_samples(const Parameters& parameters);

/// The time that a cycle may take, cycle_budget [s]: half a period where it is 0; negative: without limit.
double cycle_budget(const Parameters& parameters, double period);

/// What thinned samples mean, with the remedy; empty while all are in force. `budget` [s].
std::string thinning_complaint(const Sampling& in_force, const Sampling& full, double budget);

}  // namespace hidwa_local_planner
