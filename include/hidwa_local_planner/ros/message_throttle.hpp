// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

namespace hidwa_local_planner {

/// When to say what goes on for many cycles: at once when it is new, then once a second. Messages that differ
/// from their first figure on are the same.
class MessageThrottle {
 public:
  /// True when `message` is due at `now` [s]. Remembers it then, in the memory of the one before.
  bool due(double now, std::string_view message) {
    const std::string_view kind = message.substr(0, message.find_first_of("0123456789"));
    if (kind == said_ && now - said_at_ < 1.0) return false;
    said_ = kind;
    said_at_ = now;
    return true;
  }
  /// Whatever it was is over. False when there was nothing.
  bool end() {
    const bool said = !said_.empty();
    said_.clear();
    return said;
  }

 private:
  std::string said_;
  double said_at_ = 0.0;  // [s]
};

}  // namespace hidwa_local_planner
