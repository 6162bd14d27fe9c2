// SPDX-License-Identifier: BSD-3-Clause
#include "hidwa_local_planner/input/message_stream.hpp"

#include "core/util/words.hpp"

namespace hidwa_local_planner::input {
namespace {

constexpr double kWorthSaying = 0.1;  // [s], of a delay

}  // namespace

MessageStream::Arrival MessageStream::judge(const OperatorMessage& message, double received,
                                            const BacklogGate::Limits& limits) {
  const bool other = device_.changed(message.sender, message.shape());
  if (other) backlog_.reset();
  if (limits.late > 0.0) {
    switch (backlog_.judge(message.stamp, received, limits)) {
      case BacklogGate::Arrival::backlog:
        return Arrival::late;
      case BacklogGate::Arrival::slower_link:
        return Arrival::slower_link;
      case BacklogGate::Arrival::new_clock:
        return Arrival::new_clock;
      case BacklogGate::Arrival::live:
        break;
    }
  }
  return other ? Arrival::new_device : Arrival::live;
}

std::string MessageStream::advice(const std::string& topic) const {
  std::string text;
  if (backlog_.slowness() > kWorthSaying) {
    text = "What comes on " + topic + " arrives " + worded(backlog_.slowness(), 2) +
           " s later than at best: the robot answers the operator with that delay. Check the link.";
  }
  if (!device_.contested()) return text;
  if (!text.empty()) text += ' ';
  return text + "Two nodes take turns on " + topic + ", " + device_.rival() + " and " + device_.sender() +
         ": each message counts as one of a new device. Let only one of them send.";
}

void MessageStream::reset() {
  device_.reset();
  backlog_.reset();
}

}  // namespace hidwa_local_planner::input
