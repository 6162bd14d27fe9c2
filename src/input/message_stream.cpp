// SPDX-License-Identifier: BSD-3-Clause
#include "hidwa_local_planner/input/message_stream.hpp"

namespace hidwa_local_planner::input {

MessageStream::Verdict MessageStream::judge(const Envelope& envelope, double timeout) {
  const bool other = device_.changed(envelope.sender, envelope.axes, envelope.buttons);
  if (other) backlog_.reset();
  if (timeout > 0.0) {
    const BacklogGate::Verdict verdict = backlog_.judge(envelope.stamp, envelope.received, timeout);
    if (verdict == BacklogGate::Verdict::backlog) return Verdict::late;
    if (verdict == BacklogGate::Verdict::new_clock) return Verdict::new_clock;
  }
  return other ? Verdict::new_device : Verdict::live;
}

std::string MessageStream::advice(const std::string& topic) const {
  if (!device_.contested()) return {};
  return "Two nodes take turns on " + topic + ", " + device_.rival() + " and " + device_.sender() +
         ": each counts as a new device after the other. Let only one of them send.";
}

void MessageStream::reset() {
  device_.reset();
  backlog_.reset();
}

}  // namespace hidwa_local_planner::input
