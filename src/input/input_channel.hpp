// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "input/operator_command.hpp"

namespace hidwa_local_planner::input {

/// The newest operator command and whether it still counts: knows silence and the neutral device, no states.
///
/// While the operator gives input, silence longer than the timeout is a loss. While the device is neutral
/// silence means nothing. After a start, a loss and on demand the input counts only once it was seen inactive
/// (centred, or the enable button released), unless that is not required.
///
/// While the planner itself was paused, no message could be taken. So the longest pause since the last message does not
/// count as silence. Only the longest: a loss is noticed at most one pause later. A loss that the pauses since the last
/// message explain was not the operator's doing. The next message ends it; no neutral is needed.
class InputChannel {
 public:
  /// timeout 0: a silent stick is still where it was, it is never lost.
  void configure(double timeout, bool require_neutral);  // [s]
  /// A usable message arrived; `received` [s] never decreasing.
  void accept(const OperatorCommand& command, double received);
  /// The planner stood still for `pause` [s], until now.
  void exclude_pause(double pause);
  /// Notices a loss up to `now` [s].
  void check(double now);
  /// What steers is known to be gone, without waiting for silence to last.
  void lose();
  /// The same message asks for another command: parameters changed.
  void remap(const OperatorCommand& command);
  /// The input must be seen inactive once (again) before it counts. `seen`: another device gives it from now on, which
  /// was seen inactive already. A loss goes on until the input counts.
  void demand_neutral(bool seen = false);
  /// As at the start.
  void reset();

  bool received_any() const { return received_any_; }
  double time() const { return time_; }       // of the last message [s]
  bool active() const { return active_; }     // input that counts
  const Twist2& u_h() const { return u_h_; }  // of the newest input that counted
  bool armed() const { return armed_; }       // seen inactive since that was demanded
  bool lost() const { return lost_; }         // active input fell silent and has not come back
  /// The input is lost at `now` [s], and it is the planner that did not listen.
  bool lost_by_pauses(double now) const { return fell_silent_ && now - time_ - pauses_ <= timeout_; }
  /// The input is lost at `now` [s] by its sender's silence, which goes on.
  bool fell_silent(double now) const { return fell_silent_ && !lost_by_pauses(now); }
  bool waits_for_neutral() const { return deflected_ && !armed_; }
  /// When the input that counted last ended [s]. A sender that repeats itself: its last active message. One
  /// that sends only changes (timeout 0) was active until the message that ended it.
  double ended_at() const { return timeout_ > 0.0 ? active_time_ : time_; }

  template <typename Self, typename Archive>
  static void archive(Self& self, Archive& io) {
    io(self.received_any_, self.armed_, self.deflected_, self.active_, self.lost_, self.fell_silent_, self.time_,
       self.active_time_, self.longest_pause_, self.pauses_, self.u_h_);
  }

 private:
  double timeout_ = 0.0;  // [s]
  bool require_neutral_ = true;
  bool received_any_ = false;
  bool armed_ = false;      // seen inactive since it was demanded
  bool deflected_ = false;  // the last message was active, whether it counted or not
  bool active_ = false;
  bool lost_ = false;
  bool fell_silent_ = false;    // lost by silence, and no message came since
  double time_ = 0.0;           // [s]
  double active_time_ = 0.0;    // of the last message that counted as active [s]
  double longest_pause_ = 0.0;  // of the planner itself since the last message [s]
  double pauses_ = 0.0;         // all of them [s]
  Twist2 u_h_;
};

}  // namespace hidwa_local_planner::input
