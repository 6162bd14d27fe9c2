// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <deque>

#include "drive/setup.hpp"
#include "hidwa_local_planner/input/operator_state_machine.hpp"

namespace hidwa_local_planner {
namespace drive {

/// The way from the person to the planner: what they see, what their device says of it, and the messages of
/// it, each of which arrives `setup.link_delay` after it was sent.
class OperatorLink {
 public:
  /// Both must outlive it.
  OperatorLink(const DriveSetup& setup, input::OperatorStateMachine& listener) : setup_(setup), listener_(listener) {}

  /// The person looks, and their device sends what it reads.
  void send(const sim::Observation& seen);

  /// Hands over what has arrived by `now` [s].
  void deliver(double now);

 private:
  struct Sent {
    input::StickMessage stick;
    input::HandMessage hand;  // in mode gesture only
  };

  const DriveSetup& setup_;
  input::OperatorStateMachine& listener_;
  std::deque<Sent> under_way_;
};

}  // namespace drive
}  // namespace hidwa_local_planner
