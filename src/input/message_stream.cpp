// SPDX-License-Identifier: BSD-3-Clause
#include "input/message_stream.hpp"

#include <cmath>
#include <cstddef>
#include <utility>

#include "core/util/words.hpp"

namespace hidwa_local_planner::input {
namespace {

constexpr double kWorthSaying = 0.1;  // [s], of a delay

// Where silence is no loss, another device may steer after so long.
constexpr double kPatience = 1.0;  // [s]

constexpr std::size_t kRememberedDevices = 16;  // devices

// Two nodes take turns where no more lies between their messages.
constexpr double kInTurn = 3.0;  // [s]

// What the link held back arrives within this time after the end of a silence [s].
constexpr double kCatchingUp = 0.2;

}  // namespace

MessageStream::Arrival MessageStream::judge(const OperatorMessage& message, const Use& use, double received,
                                            const BacklogGate::Limits& limits) {
  std::size_t from = find(message);
  const bool known = from < devices_.size();
  if (!known) {
    remember(message);
    from = devices_.size() - 1;
  }
  Device& device = devices_[from];
  BacklogGate::Arrival arrival = BacklogGate::Arrival::live;
  const bool connected = message.connection != device.connection;
  device.connection = message.connection;
  if (limits.late > 0.0) arrival = device.backlog.judge(message.stamp, received, limits, connected);
  excess_ = device.backlog.excess();
  if (arrival == BacklogGate::Arrival::backlog) return Arrival::late;
  const bool same_link = arrival == BacklogGate::Arrival::live;
  device.armed = use.idle || (device.armed && same_link);
  device.was_idle = known && device.idle;
  device.idle = use.idle;
  if (!known || received - device.heard > kInTurn) device.begun = received;
  device.heard = received;
  if (from != in_use_) return choose(from, known, use, received, limits.late > 0.0 ? limits.late : kPatience);
  if (same_link) return Arrival::live;
  return arrival == BacklogGate::Arrival::new_clock ? Arrival::new_clock : Arrival::slower_link;
}

// A node has one device: where it sends for another one, the one before is gone.
MessageStream::Arrival MessageStream::choose(std::size_t from, bool known, const Use& use, double received,
                                             double patience) {
  const std::size_t before = in_use_;
  const bool replaced = devices_[before].sender == devices_[from].sender;
  const bool heard = use.steers && received - devices_[before].heard <= patience;
  const bool says_nothing = use.idle && (use.steers || (use.lost && devices_[from].was_idle));
  if (!replaced && (says_nothing || (known && heard))) return Arrival::beside;
  devices_[before].armed = use.armed;
  in_use_ = from;
  if (known && !replaced) return Arrival::other_device;
  devices_[from].silence = devices_[before].silence;
  if (!use.idle) demand_neutral();
  return Arrival::new_device;
}

// The message that ends the silence is no old one: a stick may send only changes.
bool MessageStream::catching_up(double received, double timeout) {
  Silence& silence = devices_[in_use_].silence;
  const double silent_for = received - std::exchange(silence.heard, received);
  if (timeout <= 0.0) return false;
  if (silent_for <= timeout) return received - silence.ended < kCatchingUp;
  silence.ended = received;
  return false;
}

std::size_t MessageStream::find(const OperatorMessage& message) const {
  const DeviceShape shape = message.shape();
  std::size_t i = 0;
  while (i < devices_.size() && (devices_[i].sender != message.sender || devices_[i].shape.axes != shape.axes ||
                                 devices_[i].shape.buttons != shape.buttons)) {
    ++i;
  }
  return i;
}

// Nodes with a new name at every start must not fill the memory. The oldest goes; the one in use stays.
void MessageStream::remember(const OperatorMessage& message) {
  if (devices_.size() >= kRememberedDevices) {
    const std::size_t oldest = in_use_ == 0 ? 1 : 0;
    devices_.erase(devices_.begin() + static_cast<std::ptrdiff_t>(oldest));
    if (oldest < in_use_) --in_use_;
  }
  devices_.emplace_back();
  devices_.back().sender = message.sender;
  devices_.back().shape = message.shape();
}

void MessageStream::demand_neutral() {
  for (Device& device : devices_) device.armed = false;
}

void MessageStream::forget_lag() {
  for (Device& device : devices_) device.backlog.reset();
}

void MessageStream::add_to_lag(double step) {
  for (Device& device : devices_) device.backlog.add_to_lag(step);
}

std::string MessageStream::advice(const std::string& topic) const {
  std::string text;
  const double slowness = in_use().backlog.slowness();
  if (slowness > kWorthSaying) {
    text = "What comes on " + topic + " arrives " + worded(slowness, 2) +
           " s later than at best: the robot answers the operator with that delay. Check the link.";
  }
  const Device* const other = rival();
  if (other == nullptr) return text;
  if (!text.empty()) text += ' ';
  return text + "Two nodes send on " + topic + ", " + other->sender + " and " + in_use().sender +
         ": while one of them steers, the other does not count. Let only one of them send.";
}

const MessageStream::Device* MessageStream::rival() const {
  const Device& own = in_use();
  for (const Device& other : devices_) {
    const bool in_turn = other.heard > own.begun && own.heard > other.begun;
    if (other.sender != own.sender && in_turn && std::abs(other.heard - own.heard) <= kInTurn) return &other;
  }
  return nullptr;
}

}  // namespace hidwa_local_planner::input
