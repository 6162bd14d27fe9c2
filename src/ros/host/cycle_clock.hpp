// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "control/period_watch.hpp"

namespace hidwa_local_planner {

/// Watches when the host calls: pauses, time that jumps back, and a rate that is not the nominal one.
class CycleClock {
 public:
  struct Tick {
    bool jumped_back = false;  // time went backwards
    bool paused = false;       // the host was in control since the last call, or this is the first one
    double interval = 0.0;     // since the last call [s]; 0 where there is none
    double period = 0.0;       // nominal, of this cycle [s]
  };
  /// A call at `now` [s] with the nominal `period` [s]; `last`: when the cycle before was [s], see ControlLoop.
  Tick tick(double now, double period, const std::optional<double>& last);
  /// A sentence with the remedy when the measured rate differs from the nominal one by more than 30 %; said
  /// once.
  std::string complaint();
  /// The longest control period of late, the nominal one at least [s]; see PeriodWatch.
  double longest_period(double period) const { return watch_.longest(period); }

 private:
  PeriodWatch watch_;
  double period_ = 0.0;  // nominal [s]
  double sum_ = 0.0;     // of the counted intervals [s]
  int count_ = 0;
  bool complained_ = false;
};

/// Whether others may have driven since the last call. Without a pause they have not. Simulated time that jumps back,
/// as in a bag that begins anew, looks like a pause: then `silence` [s], measured on the wall, tells.
bool host_was_away(const CycleClock::Tick& tick, double silence);

}  // namespace hidwa_local_planner
