// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace hidwa_local_planner::input {

/// For how long lags stay within a spread.
class SteadyLag {
 public:
  /// One more lag [s], of a message `received` [s]. A spread beyond `spread` [s], or nothing received for longer than
  /// `gap` [s], begins anew. Returns for how long it is steady [s].
  double observe(double lag, double received, double spread, double gap);
  /// Something was received [s] that says nothing about the lag.
  void take_silent(double received) { last_ = received; }
  void forget() { begun_ = false; }
  double least() const { return least_; }  // since it began [s]
  double most() const { return most_; }    // since it began [s]

 private:
  bool begun_ = false;
  double least_ = 0.0;  // [s]
  double most_ = 0.0;   // [s]
  double since_ = 0.0;  // [s]
  double last_ = 0.0;   // [s]
};

/// Tells messages that a link held back from live ones, by their stamps.
///
/// The clocks of sender and receiver need not agree: what counts is by how much a message's lag (received -
/// stamp) exceeds the smallest lag seen. Empty stamps (0) say nothing: such messages pass. A repeated stamp
/// (joy_node's autorepeat did not always refresh it) is judged as it was the first time. The smallest lag is
/// forgotten as slowly as two free-running clocks part.
///
/// A link may become slower for good. A lag that is steady within 0.1 s for 2 s becomes the link's present lag, up to
/// `lag_max` more than the smallest. Messages with that lag are live, too. A smaller lag becomes the present one at
/// once.
///
/// Lags that grow by one and the same time may be those of a backlog that is delivered at the pace at which it was
/// sent, or those of a sender whose clock stood still. They are taken for the latter only where no backlog is left:
/// after a gap in the messages and in their stamps that is longer than the excess, in which a backlog would have been
/// worked off, while the lag stayed the same within 0.1 s; or on a new connection.
class BacklogGate {
 public:
  struct Limits {
    double late = 0.5;     // a live message exceeds the link's present lag by this at most [s], > 0
    double lag_max = 0.0;  // the most by which a link may become slower [s]
  };
  enum class Arrival {
    live,
    backlog,      // held back for longer than the limit: to be dropped
    slower_link,  // live: from this message on the link's lag is a larger one
    new_clock     // the sender's or the receiver's clock was set or stood still: the lag is learnt from this message
  };

  /// Judges one message; `stamp`, `received` in [s], `received` never decreasing. `connected`: it is the first one of a
  /// connection.
  Arrival judge(double stamp, double received, const Limits& limits, bool connected = false);
  /// A gap in the stamps longer than this [s] leaves nothing of a backlog with this excess [s].
  static double proving_gap(double excess, const Limits& limits) { return excess + limits.late; }
  /// The receiver's clock was set forward by `step` [s].
  void add_to_lag(double step);

  /// By how much the last judged message exceeded the smallest lag [s].
  double excess() const { return excess_; }
  /// By how much the link's present lag exceeds the smallest [s]; 0 where it never became slower.
  double slowness() const { return known_ ? usual_lag_ - smallest_lag_ : 0.0; }

  void reset() { *this = BacklogGate(); }

 private:
  bool clock_was_set(double lag, double received, double limit);
  bool is_slower(double lag, double received, const Limits& limits);
  bool outlasts_backlog(double gap, double excess_before, const Limits& limits) const;
  void learn(double stamp, double received);

  bool known_ = false;
  double stamp_ = 0.0;                // newest seen [s]
  double smallest_lag_ = 0.0;         // [s], as of received_
  double usual_lag_ = 0.0;            // the link's present one [s], as of received_
  double received_ = 0.0;             // [s]
  double heard_ = 0.0;                // when the newest message with a stamp arrived [s]
  double excess_ = 0.0;               // [s]
  double last_excess_ = 0.0;          // of the newest stamp that was not a repeated one [s]
  Arrival repeated_ = Arrival::live;  // on the newest stamp
  bool went_back_ = false;            // the stamps, within the present backlog
  SteadyLag backlog_lag_;             // of the present backlog, for a clock that was set
  SteadyLag link_lag_;                // of the present backlog, for a link that became slower
};

}  // namespace hidwa_local_planner::input
