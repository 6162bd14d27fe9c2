// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "input/backlog_gate.hpp"
#include "input/operator_message.hpp"

namespace hidwa_local_planner::input {

/// One topic's messages: which devices send them, and whether the link held them back.
///
/// Devices are told apart by sender and shape, and remembered. One of them is in use. While it steers, no other that is
/// known or idle takes its place. Where it was lost, none does that is idle as it was before: that says nothing new.
class MessageStream {
 public:
  enum class Arrival {
    live,
    late,          // held back: to be dropped
    beside,        // live, and of a device that is not in use: it changes nothing
    new_device,    // live, and the first of a device that was not known; it is in use from now on
    other_device,  // live, and of a device that is known and in use from now on
    slower_link,   // live, and the first since the link is known to be slower
    new_clock      // live, and the first since a clock was set or stood still
  };
  /// What a message meets.
  struct Use {
    bool idle = false;    // the message asks for nothing
    bool steers = false;  // what the device in use asks for counts
    bool lost = false;    // it did, and fell silent
    bool armed = false;   // the device in use was seen neutral
  };
  /// A silence of the link, as the messages show it that were taken.
  struct Silence {
    static constexpr double kNever = -std::numeric_limits<double>::infinity();
    double heard = kNever;  // the newest message [s]
    double ended = kNever;  // the last silence [s]
  };
  struct Device {
    std::string sender;
    DeviceShape shape;
    BacklogGate backlog;
    Silence silence;
    bool armed = false;     // seen neutral since that was demanded; while it is in use others know better
    bool idle = false;      // its newest message asked for nothing
    bool was_idle = false;  // nor did the one before
    double heard = 0.0;     // [s]
    double begun = 0.0;     // since then it was never silent for long [s]
    std::shared_ptr<const void> connection;  // of its newest message
  };

  /// Judges a message; `received`: when it arrived, never decreasing [s]; limits.late 0: none is too late.
  Arrival judge(const OperatorMessage& message, const Use& use, double received, const BacklogGate::Limits& limits);
  /// The device in use; at the start one without a name.
  const Device& in_use() const { return in_use_ < devices_.size() ? devices_[in_use_] : none_; }
  /// A message of the device in use was taken. Whether it may be one that the link held back during a silence of more
  /// than `timeout` [s] (0: there is none): then a press of a button in it is an old one.
  bool catching_up(double received, double timeout);
  /// Each device must be seen neutral once (again).
  void demand_neutral();
  /// By how much the last message was later than the link was at best [s].
  double excess() const { return excess_; }
  /// Two nodes that take turns, and a link that became slower, in words, with the remedy; else empty.
  std::string advice(const std::string& topic) const;
  /// Each device's lag is learnt anew.
  void forget_lag();
  /// The clock was set forward by `step` [s]: each lag seems larger by it.
  void add_to_lag(double step);
  void reset() { *this = MessageStream(); }

 private:
  std::size_t find(const OperatorMessage& message) const;
  Arrival choose(std::size_t from, bool known, const Use& use, double received, double patience);
  void remember(const OperatorMessage& message);
  /// Of another node, and its messages come in turn with those of the device in use; null: there is none.
  const Device* rival() const;

  std::vector<Device> devices_;
  Device none_;
  std::size_t in_use_ = 0;
  double excess_ = 0.0;  // of the message judged last [s]
};

}  // namespace hidwa_local_planner::input
