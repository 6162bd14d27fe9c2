// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

namespace hidwa_local_planner::input {

/// Who has control in mode `switching`. Each press of the button hands it over (Kalliokoski 2022, section IV-A), and so
/// does a message on the topic take_control.
class ControlHandover {
 public:
  /// The button, as a message says; a press is a change from released to held. `counts`: cycles run and the message is
  /// not an old one, so that the operator sees what the press does.
  void take_button(bool held, bool counts) {
    if (known_ && held && !held_ && counts) manual_ = !manual_;
    known_ = true;
    held_ = held;
  }
  /// In words; the next cycle does it.
  void request(bool manual) { requested_ = manual; }
  /// A cycle begins. `counts`: cycles run.
  void apply_request(bool counts) {
    if (requested_ && counts) manual_ = *requested_;
    requested_.reset();
  }
  /// The operator has control no longer.
  void end() {
    manual_ = false;
    requested_.reset();
  }
  /// Another device is used now: whether its button was held before is not known.
  void forget_button() { known_ = false; }
  /// The clock was set back: whoever has control keeps it.
  void set_back() {
    known_ = false;
    requested_.reset();
  }

  bool manual() const { return manual_; }
  template <typename Self, typename Archive>
  static void archive(Self& self, Archive& io) {
    io(self.manual_, self.known_, self.held_, self.requested_);
  }

 private:
  bool manual_ = false;
  bool known_ = false;
  bool held_ = false;
  std::optional<bool> requested_;  // since the last cycle
};

}  // namespace hidwa_local_planner::input
