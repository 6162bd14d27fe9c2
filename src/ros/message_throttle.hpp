// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

namespace hidwa_local_planner {

/// When to log a condition that lasts for many cycles: at once when it is new, then once a second. Messages are the
/// same if they are equal up to their first digit.
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
  /// The condition is over. False where there was none.
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
