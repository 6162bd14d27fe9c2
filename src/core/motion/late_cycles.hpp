// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

namespace hidwa_local_planner {

/// How much braking a cycle may do, as a time [s]: the time since the cycle before, `elapsed` [s]; at least one control
/// `period` [s], and at most the `longest` of the last seconds (PeriodWatch).
inline double late_brake_period(double elapsed, double period, double longest) {
  return std::max(period, std::min(elapsed, longest));
}

/// How much later than one period after a command the first command to brake may take effect [s]. Several cycles in a
/// row may be late. Since each brakes as above, together they delay the braking no more than the latest one does alone.
inline double latest_hold(double period, double longest) { return 2.0 * std::max(0.0, longest - period); }

/// How far apart the times until the latest hold [s] are at which a late command to brake is looked at [s]: half a
/// period. A very short period, or a very late cycle, makes no more of them than can be looked at.
inline double late_times_apart(double latest, double period) { return std::max({0.5 * period, 0.01, latest / 200.0}); }

/// In how many parts these times lie, no more than `apart` [s] from each other; 0: it is punctual, that is late by less
/// than a tenth of a period.
inline double late_parts(double latest, double apart, double period) {
  return latest > 0.1 * period ? std::ceil(latest / apart) : 0.0;
}

/// When a late command to brake is looked at: as late as it may come, on time, and between these where `closely`.
class LateTimes {
 public:
  LateTimes(double latest, double period, bool closely)
      : latest_(latest), parts_(late_parts(latest, closely ? late_times_apart(latest, period) : latest, period)) {}

  /// How far apart they are [s]; where it is punctual, how late it may be.
  double apart() const { return parts_ > 0.0 ? latest_ / parts_ : latest_; }
  /// Whether visit(hold) is true for all of them, the latest first. hold: how late it comes [s].
  template <typename Visit>
  bool all_of(Visit&& visit) const {
    for (double part = parts_; part >= 0.0; part -= 1.0) {
      if (!visit(parts_ > 0.0 ? latest_ * part / parts_ : latest_)) return false;
    }
    return true;
  }

 private:
  double latest_, parts_;
};

}  // namespace hidwa_local_planner
