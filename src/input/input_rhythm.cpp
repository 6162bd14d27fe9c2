// SPDX-License-Identifier: BSD-3-Clause
#include "input/input_rhythm.hpp"

#include "core/util/words.hpp"

namespace hidwa_local_planner::input {
namespace {

constexpr double kSteadyEnough = 10.0;  // sending deflected for so long without a silence clears the count [s]

}  // namespace

void InputRhythm::take(double now, bool deflected, double timeout) {
  check(now, timeout);
  if (deflected_ && !counted_) steady_ += now - time_;
  if (steady_ >= kSteadyEnough) silences_ = 0;
  deflected_ = deflected;
  counted_ = false;
  time_ = now;
}

void InputRhythm::check(double now, double timeout) {
  if (!deflected_ || counted_ || timeout <= 0.0 || now - time_ <= timeout) return;
  counted_ = true;
  steady_ = 0.0;
  ++silences_;
}

std::string InputRhythm::advice(double timeout) const {
  if (silences_ == 0 || timeout <= 0.0) return {};
  return "The deflected stick fell silent for more than input_timeout (" + worded(timeout, 3) + " s), " +
         (silences_ == 1 ? "once" : std::to_string(silences_) + " times") +
         ". If it sends only changes, as joy_node does without autorepeat, set joy_node's autorepeat_rate to "
         "20, or "
         "input_timeout to 0; if it repeats by itself, look at the link.";
}

}  // namespace hidwa_local_planner::input
