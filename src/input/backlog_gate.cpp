// SPDX-License-Identifier: BSD-3-Clause
#include "input/backlog_gate.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace hidwa_local_planner::input {
namespace {

// Two free-running quartz clocks part by at most about 100 ppm each.
constexpr double kClockDrift = 2e-4;  // [s/s]
// A backlog is worked off in no time. Messages that stay late by one and the same time for so long, either
// after a step back of their stamps or by more than a link can hold back, say that a clock was set.
constexpr double kSteadyTime = 5.0;       // [s]
constexpr double kLongestBacklog = 60.0;  // [s]
// A link that became slower: its lag may grow no more, and jitter is not growth.
constexpr double kSettledTime = 2.0;    // [s]
constexpr double kSettledSpread = 0.1;  // [s]

constexpr double kAnyGap = std::numeric_limits<double>::infinity();

}  // namespace

double SteadyLag::observe(double lag, double received, double spread, double gap) {
  const double least = std::min(least_, lag);
  const double most = std::max(most_, lag);
  if (!begun_ || most - least > spread || received - last_ > gap) {
    begun_ = true;
    least_ = most_ = lag;
    since_ = received;
  } else {
    least_ = least;
    most_ = most;
  }
  last_ = received;
  return received - since_;
}

BacklogGate::Arrival BacklogGate::judge(double stamp, double received, const Limits& limits, bool connected) {
  excess_ = 0.0;
  if (stamp <= 0.0) return Arrival::live;
  const double silence = received - heard_;
  heard_ = received;
  if (known_ && stamp == stamp_) {
    link_lag_.take_silent(received);
    return repeated_;
  }
  if (!known_) {
    learn(stamp, received);
    return Arrival::live;
  }
  const bool back = stamp < stamp_ - limits.late;
  const double gap = std::min(stamp - stamp_, silence);
  const double lag = received - stamp;
  const double drift = kClockDrift * (received - received_);
  smallest_lag_ = std::min(lag, smallest_lag_ + drift);
  usual_lag_ = std::min(lag, usual_lag_ + drift);
  received_ = received;
  stamp_ = back ? stamp : std::max(stamp_, stamp);
  excess_ = lag - smallest_lag_;
  const double excess_before = std::exchange(last_excess_, excess_);
  if (lag - usual_lag_ <= limits.late && excess_ <= std::max(limits.late, limits.lag_max)) {
    backlog_lag_.forget();
    link_lag_.forget();
    went_back_ = false;
    return repeated_ = Arrival::live;
  }
  went_back_ = went_back_ || back;
  const bool new_clock = clock_was_set(lag, received, limits.late);
  if (is_slower(lag, received, limits)) {
    usual_lag_ = link_lag_.least();
    link_lag_.forget();
    backlog_lag_.forget();
    went_back_ = false;
    repeated_ = Arrival::live;
    return Arrival::slower_link;
  }
  if (!new_clock && !connected && !outlasts_backlog(gap, excess_before, limits)) return repeated_ = Arrival::backlog;
  learn(stamp, received);
  return Arrival::new_clock;
}

bool BacklogGate::clock_was_set(double lag, double received, double limit) {
  const double steady = backlog_lag_.observe(lag, received, limit, kAnyGap);
  return (went_back_ || excess_ > kLongestBacklog) && steady >= kSteadyTime;
}

bool BacklogGate::is_slower(double lag, double received, const Limits& limits) {
  const double steady = link_lag_.observe(lag, received, kSettledSpread, limits.late);
  return steady >= kSettledTime && link_lag_.most() - smallest_lag_ <= limits.lag_max;
}

bool BacklogGate::outlasts_backlog(double gap, double excess_before, const Limits& limits) const {
  return excess_before > limits.lag_max && gap > proving_gap(excess_before, limits) &&
         std::abs(excess_ - excess_before) <= kSettledSpread;
}

void BacklogGate::add_to_lag(double step) {
  if (!known_) return;
  smallest_lag_ += step;
  usual_lag_ += step;
  backlog_lag_.forget();
  link_lag_.forget();
  repeated_ = Arrival::live;
}

void BacklogGate::learn(double stamp, double received) {
  known_ = true;
  last_excess_ = 0.0;
  stamp_ = stamp;
  smallest_lag_ = usual_lag_ = received - stamp;
  received_ = received;
  backlog_lag_.forget();
  link_lag_.forget();
  went_back_ = false;
  repeated_ = Arrival::live;
}

}  // namespace hidwa_local_planner::input
