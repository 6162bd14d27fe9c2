// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "hidwa_local_planner/input/backlog_gate.hpp"
#include "hidwa_local_planner/input/device_watch.hpp"
#include "hidwa_local_planner/input/operator_message.hpp"

namespace hidwa_local_planner::input {

/// One topic's messages: who sends them, and whether the link held them back.
class MessageStream {
 public:
  enum class Arrival {
    live,
    late,         // held back: to be dropped
    new_device,   // live, and the first of another device
    slower_link,  // live, and the first since the link is known to be slower
    new_clock     // live, and the first since a clock was set
  };

  /// Judges a message; `received`: when it arrived, never decreasing [s]; limits.late 0: none is too late.
  Arrival judge(const OperatorMessage& message, double received, const BacklogGate::Limits& limits);
  /// By how much the last message was later than the link was at best [s].
  double excess() const { return backlog_.excess(); }
  /// Two nodes that take turns, and a link that became slower, in words, with the remedy; else empty.
  std::string advice(const std::string& topic) const;
  void forget_lag() { backlog_.reset(); }
  void reset();

 private:
  DeviceWatch device_;
  BacklogGate backlog_;
};

}  // namespace hidwa_local_planner::input
