// SPDX-License-Identifier: BSD-3-Clause
#include "input/pause_detector.hpp"

#include <algorithm>
#include <cmath>

#include "core/util/words.hpp"

namespace hidwa_local_planner::input {
namespace {

constexpr double kPause = 0.15;  // [s]; three heartbeats

// Nobody notices shorter pauses; longer ones are told of for a while.
constexpr double kNoticed = 0.3;   // [s]
constexpr double kToldFor = 10.0;  // [s]

}  // namespace

double PauseDetector::observe(double now) {
  const double pause = still_for(now);
  last_ = std::max(last_, now);
  ended_ = ended_ || pause > 0.0;
  return pause;
}

void PauseDetector::report(double pause, double now) {
  if (pause < kNoticed) return;
  reported_ = pause;
  reported_at_ = now;
}

std::string PauseDetector::advice(double now) const {
  if (reported_ == 0.0 || now - reported_at_ >= kToldFor) return {};
  return "The planner itself was paused for " + worded(reported_, 2) +
         " s and took no messages: its machine is too busy, the process was suspended, or the clock was set "
         "forward. Reduce the load of the machine.";
}

void PauseDetector::restart() {
  ended_ = false;
  reported_ = 0.0;
  reported_at_ = kNever;
}

void PauseDetector::set_back() {
  restart();
  last_ = kNever;
}

double PauseDetector::still_for(double now) const {
  const double still = now - last_;
  return expected_ && std::isfinite(still) && still > kPause ? still : 0.0;
}

}  // namespace hidwa_local_planner::input
