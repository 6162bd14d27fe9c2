// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>

namespace hidwa_local_planner::input {

/// Whether a message may be one that the link held back during a silence: what follows the end of a silence at once. A
/// press of a button in it is an old one. The message that ends the silence is none of these: a stick may send only
/// changes.
class CatchUpWatch {
 public:
  /// A message arrived at `received` [s]; a silence is longer than `timeout` [s], 0: there is none.
  bool catching_up(double received, double timeout) {
    if (timeout <= 0.0) {
      last_ = received;
      return false;
    }
    const bool ends_silence = received - last_ > timeout;
    if (ends_silence) silence_ended_ = received;
    last_ = received;
    return !ends_silence && received - silence_ended_ < kCatchingUp;
  }

 private:
  static constexpr double kCatchingUp = 0.2;  // [s]
  static constexpr double kNever = -std::numeric_limits<double>::infinity();

  double last_ = kNever;           // message [s]
  double silence_ended_ = kNever;  // [s]
};

}  // namespace hidwa_local_planner::input
