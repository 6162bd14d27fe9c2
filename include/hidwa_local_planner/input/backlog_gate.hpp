// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace hidwa_local_planner::input {

/// Tells messages that a link held back from live ones, by their stamps.
///
/// The clocks of sender and receiver need not agree: what counts is by how much a message's lag (received -
/// stamp) exceeds the smallest lag seen. Empty stamps (0) say nothing: such messages pass. A repeated stamp
/// (joy_node's autorepeat did not always refresh it) is judged as it was the first time. The smallest lag is
/// forgotten as slowly as two free-running clocks part.
class BacklogGate {
 public:
  enum class Verdict {
    live,
    backlog,   // held back for longer than the limit: to be dropped
    new_clock  // the sender's or the receiver's clock was set: the lag is learnt again from this message
  };

  /// Judges one message; `stamp`, `received`, `limit` in [s], `received` never decreasing, limit > 0.
  Verdict judge(double stamp, double received, double limit);

  /// By how much the last judged message exceeded the smallest lag [s].
  double excess() const { return excess_; }

  void reset() { *this = BacklogGate(); }

 private:
  bool clock_was_set(double lag, double received, double limit);
  void learn(double stamp, double received);

  bool known_ = false;
  double stamp_ = 0.0;                // newest seen [s]
  double smallest_lag_ = 0.0;         // [s], as of received_
  double received_ = 0.0;             // [s]
  double excess_ = 0.0;               // [s]
  Verdict repeated_ = Verdict::live;  // on the newest stamp
  bool went_back_ = false;            // the stamps, within the present backlog
  bool steady_ = false;               // the present backlog has had a lag
  double steady_lag_ = 0.0;           // that it still has [s]
  double steady_since_ = 0.0;         // [s]
};

}  // namespace hidwa_local_planner::input
