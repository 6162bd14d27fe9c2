// SPDX-License-Identifier: BSD-3-Clause
// One kind of input device, as the operator state machine sees it. The machine holds a list of sources and knows no
// kind of device; docs/understand/contributing.md says how to add one.
//
// The machine does the rest, alike for every source: late messages (MessageStream), another sender, the timeout,
// require_neutral, the stop and who has control. A source only says what its messages mean.
#pragma once

#include <optional>
#include <string>

#include "hidwa_local_planner/core/parameters.hpp"
#include "hidwa_local_planner/core/util/archive.hpp"
#include "input/operator_command.hpp"
#include "input/operator_message.hpp"
#include "input/stop_reading.hpp"

namespace hidwa_local_planner::input {

/// The buttons that mean the same whatever device has them. One that is not configured is not held.
struct Buttons {
  bool toggle = false;  // hands control over, in mode switching
  bool clutch = false;  // lets a source count that needs it
};

/// What a message says at first, before its lateness is known.
struct ParsedMessage {
  std::string fault;                // why it cannot be used, with the remedy; empty where it can
  std::optional<StopReading> stop;  // counts even in a faulty or late message; none: the device has no stop
  bool idle = false;                // without a fault: it asks for nothing, as from a device that nobody touches
};

/// What a message says that was taken.
struct SourceReading {
  std::string fault;                       // what steered is gone, in words: the input is lost at once; else empty
  std::optional<OperatorCommand> command;  // none: the message says nothing about it
  std::optional<Buttons> buttons;          // none: the device has no such buttons
};

/// What kind of device a source is.
struct SourceKind {
  std::string name;           // short and unique: the subscriptions of src/ros find the source by it
  bool has_buttons = false;   // its messages are taken for their buttons also while another source steers
  bool needs_clutch = false;  // its command counts only while the clutch is held, a button of another source
};

/// Where a source's messages come from.
struct SourceTopic {
  std::string parameter;  // that names it: "joy_topic"
  std::string topic;      // to subscribe to; empty where the messages come another way
  std::string label;      // for people: the topic, or the frames
};

class OperatorSource {
 public:
  virtual ~OperatorSource() = default;

  virtual SourceKind kind() const = 0;
  virtual SourceTopic topic(const Parameters& parameters) const = 0;
  /// Whether it steers by these parameters, unless a later one in the list does too.
  virtual bool can_steer(const Parameters& parameters) const = 0;
  /// Whether two sets of parameters listen to the same device. Another one must be seen neutral.
  virtual bool same_device(const Parameters& a, const Parameters& b) const { return topic(a).label == topic(b).label; }
  /// Whether two sets of parameters read its messages alike. Where they do not, the device must be seen neutral.
  virtual bool same_mapping(const Parameters&, const Parameters&) const { return true; }

  /// Takes valid parameters, at any time. `steers`: this source gives the operator command.
  virtual void configure(const Parameters& parameters, bool steers) = 0;

  /// Whether the message is of this source's kind. The functions that take a message are called with no other.
  virtual bool takes(const OperatorMessage& message) const = 0;
  /// Parses the message; once for each.
  virtual ParsedMessage parse(const OperatorMessage& message) = 0;
  /// Takes the message that was parsed last, without a fault, and is not late. `now`: when it arrived, never decreasing
  /// [s].
  virtual SourceReading take(const OperatorMessage& message, double now) = 0;
  /// The buttons of a message of another source arrived at `now` [s]. The command, where they change it.
  virtual std::optional<OperatorCommand> take_buttons(const Buttons&, double) { return std::nullopt; }

  /// What the newest messages ask for by the parameters in force.
  virtual OperatorCommand command() const = 0;
  /// Whether a part of the device is silent for too long at `now` [s], though other messages of the source go on.
  virtual bool gone(double) const { return false; }
  /// Forgets what came before: the input was lost, or another device sends now.
  virtual void lose() {}
  /// The planner itself did not listen for `pause` [s], until now: that is no silence of the device.
  virtual void exclude_pause(double) {}
  /// What the operator has to do before the source counts, in a sentence; else empty.
  virtual std::string advice() const { return {}; }
  /// As at the start; the parameters stay.
  virtual void reset() = 0;

  /// What command(), gone() and advice() depend on besides the parameters.
  virtual void save(ArchiveWriter& state) const = 0;
  virtual void load(ArchiveReader& state) = 0;
};

/// A source of messages of one type. What the source knows lies in `State`, which names its members in archive().
template <typename Message, typename State>
class SourceOf : public OperatorSource {
 public:
  void configure(const Parameters& parameters, bool steers) override {
    parameters_ = parameters;
    steers_ = steers;
  }
  bool takes(const OperatorMessage& message) const final { return dynamic_cast<const Message*>(&message) != nullptr; }
  ParsedMessage parse(const OperatorMessage& message) final { return parsed(typed(message)); }
  SourceReading take(const OperatorMessage& message, double now) final { return taken(typed(message), now); }
  void reset() final { state_ = State(); }
  void save(ArchiveWriter& state) const final { state(state_); }
  void load(ArchiveReader& state) final { state(state_); }

 protected:
  /// See parse() and take().
  virtual ParsedMessage parsed(const Message&) { return {}; }
  virtual SourceReading taken(const Message& message, double now) = 0;

  const Parameters& parameters() const { return parameters_; }
  bool steers() const { return steers_; }

  State state_;

 private:
  static const Message& typed(const OperatorMessage& message) { return static_cast<const Message&>(message); }

  Parameters parameters_;
  bool steers_ = false;
};

}  // namespace hidwa_local_planner::input
