// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace hidwa_local_planner::input {

/// Watches whether a deflected stick keeps sending. One that sends only changes (joy_node without autorepeat)
/// looks like a cut link whenever it is held still: the operator should be told which settings suit it.
class InputRhythm {
 public:
  /// A message arrived at `now` [s].
  void take(double now, bool deflected, double timeout);
  /// Nothing arrived until `now` [s]; counts a silence longer than `timeout` [s] once. timeout 0: never.
  void check(double now, double timeout);
  /// The planner itself did not listen for `pause` [s].
  void exclude_pause(double pause) { time_ += pause; }
  /// A sentence with the remedy; empty where nothing is to be said.
  std::string advice(double timeout) const;
  void reset() { *this = InputRhythm(); }

 private:
  bool deflected_ = false;
  bool counted_ = false;  // the present silence
  double time_ = 0.0;     // of the last message [s]
  double steady_ = 0.0;   // time deflected without a silence [s]
  int silences_ = 0;
};

}  // namespace hidwa_local_planner::input
