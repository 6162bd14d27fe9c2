// SPDX-License-Identifier: BSD-3-Clause
#include "core/cycle/cycle_start.hpp"

#include <cmath>

#include "core/cycle/input_fault.hpp"
#include "core/motion/late_cycles.hpp"

namespace hidwa_local_planner {
namespace {

// Odometry may lag behind a command that brakes already, and must not take that back.
double slower_of(double reference, double last) {
  return reference * last > 0.0 && std::abs(reference) < std::abs(last) ? reference : last;
}

}  // namespace

double usable_period(const Situation& s) { return plausible_period(s.period) ? s.period : Situation().period; }
double usable_time(const Situation& s) { return plausible_time(s.time) ? s.time : 0.0; }
double usable_age(const Situation& s) { return plausible_age(s.pose_age) ? s.pose_age : 0.0; }

double longest_period(const Situation& s) {
  return s.longest_period > s.period && plausible_period(s.longest_period) ? s.longest_period : s.period;
}

Twist2 brake_command(const CycleStart& start, const VelocityLimits& limits, const Situation& situation) {
  const Twist2 last = start.last_command;
  const Twist2 from{limits.x.start_from(slower_of(start.reference.v, last.v), last.v),
                    limits.theta.start_from(slower_of(start.reference.omega, last.omega), last.omega)};
  return limits.brake(from, late_brake_period(start.elapsed, usable_period(situation), longest_period(situation)));
}

}  // namespace hidwa_local_planner
