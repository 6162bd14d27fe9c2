// SPDX-License-Identifier: BSD-3-Clause
#include "input/input_channel.hpp"

#include <algorithm>

namespace hidwa_local_planner::input {

void InputChannel::configure(double timeout, bool require_neutral) {
  timeout_ = timeout;
  require_neutral_ = require_neutral;
}

void InputChannel::accept(const OperatorCommand& command, double received) {
  check(received);
  if (!command.active || !require_neutral_ || lost_by_pauses(received)) armed_ = true;
  fell_silent_ = false;
  longest_pause_ = pauses_ = 0.0;
  if (armed_) lost_ = false;
  received_any_ = true;
  time_ = received;
  deflected_ = command.active;
  active_ = armed_ && command.active;
  if (active_) {
    active_time_ = received;
    u_h_ = command.u_h;
  }
}

void InputChannel::exclude_pause(double pause) {
  longest_pause_ = std::max(longest_pause_, pause);
  pauses_ += pause;
}

void InputChannel::check(double now) {
  if (!active_ || timeout_ <= 0.0 || now - time_ - longest_pause_ <= timeout_) return;
  lose();
  fell_silent_ = true;
}

void InputChannel::lose() {
  if (!active_) return;
  active_ = false;
  lost_ = true;
  armed_ = false;
}

void InputChannel::remap(const OperatorCommand& command) {
  if (!active_) return;
  active_ = command.active;
  deflected_ = command.active;
  if (active_) u_h_ = command.u_h;
}

void InputChannel::demand_neutral(bool seen) {
  active_ = false;
  armed_ = seen;
  fell_silent_ = false;
}

void InputChannel::reset() {
  const double timeout = timeout_;
  const bool require_neutral = require_neutral_;
  *this = InputChannel();
  configure(timeout, require_neutral);
}

}  // namespace hidwa_local_planner::input
