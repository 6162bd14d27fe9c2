// SPDX-License-Identifier: BSD-3-Clause
#include "hidwa_local_planner/input/input_channel.hpp"

namespace hidwa_local_planner::input {

void InputChannel::configure(double timeout, bool require_neutral) {
  timeout_ = timeout;
  require_neutral_ = require_neutral;
}

void InputChannel::accept(const Wish& wish, double received) {
  check(received);
  if (!wish.active || !require_neutral_) armed_ = true;
  if (armed_) lost_ = false;
  heard_ = true;
  time_ = received;
  deflected_ = wish.active;
  active_ = armed_ && wish.active;
  if (active_) {
    active_time_ = received;
    u_h_ = wish.u_h;
  }
}

void InputChannel::check(double now) {
  if (timeout_ > 0.0 && now - time_ > timeout_) lose();
}

void InputChannel::lose() {
  if (!active_) return;
  active_ = false;
  lost_ = true;
  armed_ = false;
}

void InputChannel::remap(const Wish& wish) {
  if (!active_) return;
  active_ = wish.active;
  deflected_ = wish.active;
  if (active_) u_h_ = wish.u_h;
}

void InputChannel::demand_neutral() {
  active_ = false;
  armed_ = false;
}

void InputChannel::reset() {
  const double timeout = timeout_;
  const bool require_neutral = require_neutral_;
  *this = InputChannel();
  configure(timeout, require_neutral);
}

}  // namespace hidwa_local_planner::input
