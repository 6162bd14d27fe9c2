// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "hidwa_local_planner/input/operator_message.hpp"

namespace hidwa_local_planner::input {

/// Notices another device on the topic: another sender, or another number of axes or buttons.
class DeviceWatch {
 public:
  /// True when this message comes from another device than the one before it.
  bool changed(const std::string& sender, const DeviceShape& shape) {
    watch_rivals(sender);
    const bool same = !known_ || (sender == sender_ && shape.axes == shape_.axes && shape.buttons == shape_.buttons);
    if (!known_ || !same) {
      sender_ = sender;
      shape_ = shape;
      known_ = true;
    }
    return !same;
  }
  /// Two senders take turns. Each is a new device after the other, so neither can be relied on.
  bool contested() const { return contested_; }
  const std::string& sender() const { return sender_; }
  const std::string& rival() const { return rival_; }  // who sent before the present sender
  void reset() { *this = DeviceWatch(); }

 private:
  // So many messages in a row make a sender the only one.
  static constexpr int kAlone = 100;

  void watch_rivals(const std::string& sender) {
    if (!known_ || sender == sender_) {
      if (alone_ < kAlone) ++alone_;
      if (alone_ == kAlone) contested_ = false;
      return;
    }
    contested_ = sender == rival_ && alone_ < kAlone;
    rival_ = sender_;
    alone_ = 1;
  }

  bool known_ = false;
  std::string sender_;
  DeviceShape shape_;
  std::string rival_;
  int alone_ = 0;  // messages in a row from the present sender, up to kAlone
  bool contested_ = false;
};

}  // namespace hidwa_local_planner::input
