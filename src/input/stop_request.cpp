// SPDX-License-Identifier: BSD-3-Clause
#include "input/stop_request.hpp"

#include <algorithm>

#include "core/util/words.hpp"

namespace hidwa_local_planner::input {
namespace {

// A pull that has begun lasts until the stick has come back by a quarter: no flutter at the threshold.
constexpr double kStillPulled = 0.75;

// Nodes with a new name at every start must not fill the memory. A sender that stops is never forgotten.
constexpr std::size_t kRemembered = 16;

std::string named(const std::string& sender) { return sender.empty() ? "a device without a name" : sender; }

}  // namespace

void StopRequest::take(const std::string& device, const std::string& name, const StopReading& reading, bool in_order,
                       const Parameters& parameters, double time) {
  Sender& from = find(device, name);
  const bool known = from.axes + from.buttons > 0;
  const bool other_device = known && (from.axes != reading.shape.axes || from.buttons != reading.shape.buttons);
  if (in_order && other_device) from.armed = from.pulled;
  const double threshold = parameters.stop_pull * (from.pulled ? kStillPulled : 1.0);
  const bool back = reading.back && *reading.back >= threshold;
  const bool seen_otherwise = reading.back ? !back : in_order;
  if (seen_otherwise || !parameters.require_neutral) from.armed = true;
  const bool pulled = back && from.armed;
  if (reading.button || pulled) {
    from.asked_at = time;
    from.dismissed = false;
  }
  from.button = reading.button || (from.button && !in_order);
  from.pulled = pulled || (from.pulled && !in_order);
  if (!in_order) return;
  from.axes = static_cast<std::uint32_t>(reading.shape.axes);
  from.buttons = static_cast<std::uint32_t>(reading.shape.buttons);
}

void StopRequest::dismiss() {
  for (Sender& sender : senders_) sender.dismissed = sender.stops();
}

std::string StopRequest::end_dismissed(double now, double silence) {
  std::string ended;
  for (Sender& sender : senders_) {
    if (!sender.dismissed || !sender.unasked(now, silence)) continue;
    ended += (ended.empty() ? "The stop of " : " The stop of ") + named(sender.name) + ", which asked for it last " +
             worded(now - sender.asked_at, 3) + " s ago, has ended: the topic stop or a change of mode released it.";
    sender.button = sender.pulled = sender.dismissed = false;
  }
  return ended;
}

void StopRequest::demand_neutral() {
  for (Sender& sender : senders_) sender.armed = sender.pulled;
}

void StopRequest::set_back(double now) {
  for (Sender& sender : senders_) sender.asked_at = std::min(sender.asked_at, now);
}

bool StopRequest::requested() const {
  return requested_ || std::any_of(senders_.begin(), senders_.end(), [](const Sender& s) { return s.stops(); });
}

std::string StopRequest::advice(double now, double silence) const {
  for (const Sender& sender : senders_) {
    if (!sender.unasked(now, silence)) continue;
    return "The stop of " + named(sender.name) +
           " goes on, though no message of it came lately: release it there. If the device is gone, send false on the "
           "topic stop, or change the mode.";
  }
  return {};
}

StopRequest::Sender& StopRequest::find(const std::string& device, const std::string& name) {
  const auto known = std::find_if(senders_.begin(), senders_.end(),
                                  [&](const Sender& s) { return s.device == device && s.name == name; });
  if (known != senders_.end()) return *known;
  if (senders_.size() >= kRemembered) {
    const auto idle = std::find_if(senders_.begin(), senders_.end(), [](const Sender& s) { return !s.stops(); });
    if (idle != senders_.end()) senders_.erase(idle);
  }
  senders_.emplace_back();
  senders_.back().device = device;
  senders_.back().name = name;
  return senders_.back();
}

}  // namespace hidwa_local_planner::input
