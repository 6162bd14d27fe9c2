// SPDX-License-Identifier: BSD-3-Clause
#include "ros/host/cycle_clock.hpp"

#include <cmath>

#include "control/pause.hpp"
#include "core/util/words.hpp"

namespace hidwa_local_planner {
namespace {

constexpr int kIntervals = 40;      // measured before a rate is judged
constexpr double kTolerance = 0.3;  // of the nominal rate

}  // namespace

CycleClock::Tick CycleClock::tick(double now, double period, const std::optional<double>& last) {
  Tick tick;
  const double interval = last ? now - *last : 0.0;
  tick.interval = interval;
  tick.period = period;
  tick.jumped_back = last && interval < 0.0;
  tick.paused = !last || tick.jumped_back || is_pause(interval, period);
  if (period != period_) {
    period_ = period;
    complained_ = false;
    sum_ = 0.0;
    count_ = 0;
  }
  if (tick.paused) {
    sum_ = 0.0;
    count_ = 0;
  } else {
    sum_ += interval;
    ++count_;
    watch_.observe(now, interval);
  }
  return tick;
}

bool host_was_away(const CycleClock::Tick& tick, double silence) {
  return tick.jumped_back ? is_pause(silence, tick.period) : tick.paused;
}

std::string CycleClock::complaint() {
  if (complained_ || count_ < kIntervals) return "";
  const double mean = sum_ / count_;  // [s]
  sum_ = 0.0;
  count_ = 0;
  if (mean <= 0.0 || std::abs(period_ / mean - 1.0) <= kTolerance) return "";
  complained_ = true;
  return format(
      "the host calls at %.1f Hz, but the control period is %.3f s (%.1f Hz): set controller_frequency to the rate "
      "that the host reaches, or reduce its load",
      1.0 / mean, period_, 1.0 / period_);
}

}  // namespace hidwa_local_planner
