// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace hidwa_local_planner::input {

/// Notices two nodes that send on one topic.
class DeviceWatch {
 public:
  /// A message of this sender came.
  void note(const std::string& sender) {
    if (!known_ || sender == sender_) {
      if (alone_ < kAlone) ++alone_;
      if (alone_ == kAlone) contested_ = false;
    } else {
      contested_ = sender == rival_ && alone_ < kAlone;
      rival_ = sender_;
      alone_ = 1;
    }
    sender_ = sender;
    known_ = true;
  }
  /// Two senders take turns.
  bool contested() const { return contested_; }
  const std::string& sender() const { return sender_; }
  const std::string& rival() const { return rival_; }  // who sent before the present sender

 private:
  // After this many messages in a row a sender is the only one.
  static constexpr int kAlone = 100;

  bool known_ = false;
  std::string sender_;
  std::string rival_;
  int alone_ = 0;  // messages in a row from the present sender, up to kAlone
  bool contested_ = false;
};

}  // namespace hidwa_local_planner::input
