// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <deque>

#include "drive/setup.hpp"
#include "input/gesture_source.hpp"
#include "input/operator_state_machine.hpp"
#include "input/stick_reading.hpp"

namespace hidwa_local_planner {
namespace drive {

/// The link from the simulated operator to the planner: what they see, what their device reads, and its messages, each
/// of which arrives `setup.link_delay` after it was sent.
class OperatorLink {
 public:
  /// Both must outlive it.
  OperatorLink(const DriveSetup& setup, input::OperatorStateMachine& machine) : setup_(setup), machine_(machine) {}

  /// The operator looks, and their device sends what it reads.
  void send(const sim::Observation& seen);

  /// Hands over what has arrived by `now` [s].
  void deliver(double now);

 private:
  struct Sent {
    input::StickMessage stick;
    input::HandMessage hand;  // in mode gesture only
  };

  const DriveSetup& setup_;
  input::OperatorStateMachine& machine_;
  std::deque<Sent> in_transit_;
};

}  // namespace drive
}  // namespace hidwa_local_planner
