// SPDX-License-Identifier: BSD-3-Clause
#include "hidwa_local_planner/input/stop_request.hpp"

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

void StopRequest::hear(const std::string& sender, const StopReading& reading, bool in_order,
                       const Parameters& parameters, double time) {
  Source& source = source_of(sender);
  const bool known = source.axes + source.buttons > 0;
  const bool other_device = known && (source.axes != reading.axes || source.buttons != reading.buttons);
  if (in_order && other_device) source.armed = source.pulled;
  const double threshold = parameters.stop_pull * (source.pulled ? kStillPulled : 1.0);
  const bool back = reading.back && *reading.back >= threshold;
  const bool seen_otherwise = reading.back ? !back : in_order;
  if (seen_otherwise || !parameters.require_neutral) source.armed = true;
  const bool pulled = back && source.armed;
  if (reading.button || pulled) {
    source.asked_at = time;
    source.dismissed = false;
  }
  source.button = reading.button || (source.button && !in_order);
  source.pulled = pulled || (source.pulled && !in_order);
  if (!in_order) return;
  source.axes = reading.axes;
  source.buttons = reading.buttons;
}

void StopRequest::dismiss() {
  for (Source& source : sources_) source.dismissed = source.stops();
}

std::string StopRequest::check(double now, double silence) {
  std::string ended;
  for (Source& source : sources_) {
    if (!source.dismissed || !source.unasked(now, silence)) continue;
    ended += (ended.empty() ? "The stop of " : " The stop of ") + named(source.sender) + ", which asked for it last " +
             worded(now - source.asked_at, 3) +
             " s ago, has ended: it was let go by the topic stop or by a change of mode.";
    source.button = source.pulled = source.dismissed = false;
  }
  return ended;
}

void StopRequest::demand_neutral() {
  for (Source& source : sources_) source.armed = source.pulled;
}

void StopRequest::set_back(double now) {
  for (Source& source : sources_) source.asked_at = std::min(source.asked_at, now);
}

bool StopRequest::requested() const {
  return said_ || std::any_of(sources_.begin(), sources_.end(), [](const Source& s) { return s.stops(); });
}

std::string StopRequest::advice(double now, double silence) const {
  for (const Source& source : sources_) {
    if (!source.unasked(now, silence)) continue;
    return "The stop of " + named(source.sender) +
           " goes on though it was not heard of lately: let go of it there, or, where the device is gone, say false "
           "on the topic stop or change the mode.";
  }
  return {};
}

StopRequest::Source& StopRequest::source_of(const std::string& sender) {
  const auto known =
      std::find_if(sources_.begin(), sources_.end(), [&](const Source& s) { return s.sender == sender; });
  if (known != sources_.end()) return *known;
  if (sources_.size() >= kRemembered) {
    const auto idle = std::find_if(sources_.begin(), sources_.end(), [](const Source& s) { return !s.stops(); });
    if (idle != sources_.end()) sources_.erase(idle);
  }
  sources_.emplace_back();
  sources_.back().sender = sender;
  return sources_.back();
}

}  // namespace hidwa_local_planner::input
