// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace hidwa_local_planner::input {

/// Who has control in SW: each press of the button hands it over (Kalliokoski 2022, section IV-A).
class ControlSwitch {
 public:
  /// The button, as a message says; a press is a change from released to held. `counts`: somebody is there to
  /// see it.
  void take(bool held, bool counts) {
    if (known_ && held && !held_ && counts) manual_ = !manual_;
    known_ = true;
    held_ = held;
  }
  void say(bool manual) { manual_ = manual; }
  /// What the button of another device was is not known.
  void forget_button() { known_ = false; }
  void reset() { *this = ControlSwitch(); }

  bool manual() const { return manual_; }
  template <typename Self, typename Archive>
  static void archive(Self& self, Archive& io) {
    io(self.manual_, self.known_, self.held_);
  }

 private:
  bool manual_ = false;
  bool known_ = false;
  bool held_ = false;
};

}  // namespace hidwa_local_planner::input
