// SPDX-License-Identifier: BSD-3-Clause
#include "hidwa_local_planner/input/backlog_gate.hpp"

#include <algorithm>
#include <cmath>

namespace hidwa_local_planner::input {
namespace {

// Two free-running quartz clocks part by at most about 100 ppm each.
constexpr double kClockDrift = 2e-4;  // [s/s]
// A backlog is worked off in no time. Messages that stay late by one and the same time for so long, either
// after a step back of their stamps or by more than a link can hold back, say that a clock was set.
constexpr double kSteadyTime = 5.0;       // [s]
constexpr double kLongestBacklog = 60.0;  // [s]

}  // namespace

BacklogGate::Verdict BacklogGate::judge(double stamp, double received, double limit) {
  excess_ = 0.0;
  if (stamp <= 0.0) return Verdict::live;
  if (known_ && stamp == stamp_) return repeated_;
  if (!known_) {
    learn(stamp, received);
    return Verdict::live;
  }
  const bool back = stamp < stamp_ - limit;
  const double lag = received - stamp;
  smallest_lag_ = std::min(lag, smallest_lag_ + kClockDrift * (received - received_));
  received_ = received;
  stamp_ = back ? stamp : std::max(stamp_, stamp);
  excess_ = lag - smallest_lag_;
  if (excess_ <= limit) {
    steady_ = false;
    went_back_ = false;
    return repeated_ = Verdict::live;
  }
  went_back_ = went_back_ || back;
  if (!clock_was_set(lag, received, limit)) return repeated_ = Verdict::backlog;
  learn(stamp, received);
  return Verdict::new_clock;
}

bool BacklogGate::clock_was_set(double lag, double received, double limit) {
  if (!steady_ || std::abs(lag - steady_lag_) > limit) {
    steady_ = true;
    steady_lag_ = lag;
    steady_since_ = received;
  }
  return (went_back_ || excess_ > kLongestBacklog) && received - steady_since_ >= kSteadyTime;
}

void BacklogGate::learn(double stamp, double received) {
  known_ = true;
  stamp_ = stamp;
  smallest_lag_ = received - stamp;
  received_ = received;
  steady_ = false;
  went_back_ = false;
  repeated_ = Verdict::live;
}

}  // namespace hidwa_local_planner::input
