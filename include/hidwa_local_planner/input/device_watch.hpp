// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>

#include "hidwa_local_planner/input/stick_message.hpp"

namespace hidwa_local_planner::input {

/// Notices another device on the topic: another sender, or another number of axes or buttons.
class DeviceWatch {
 public:
  /// True when this message comes from another device than the one before it.
  bool changed(const StickMessage& message) {
    const bool same = !known_ || (message.sender == sender_ && message.axes.size() == axes_ &&
                                  message.buttons.size() == buttons_);
    if (!known_ || !same) {
      sender_ = message.sender;
      axes_ = message.axes.size();
      buttons_ = message.buttons.size();
      known_ = true;
    }
    return !same;
  }
  void reset() { known_ = false; }

 private:
  bool known_ = false;
  std::string sender_;
  std::size_t axes_ = 0;
  std::size_t buttons_ = 0;
};

}  // namespace hidwa_local_planner::input
