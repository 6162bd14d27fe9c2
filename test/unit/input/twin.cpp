// SPDX-License-Identifier: BSD-3-Clause
#include "twin.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hidwa_local_planner::input {
namespace {

using State = OperatorStateId;

bool steers(State state) { return state == State::shared || state == State::blocked; }

// |p| <= dead zone: nothing; else |p|^exponent sgn(p) maximum.
double mapped(float axis, const Parameters& p, double maximum) {
  if (std::abs(axis) <= static_cast<float>(p.dead_zone)) return 0.0;
  const double size = std::pow(std::min(1.0, static_cast<double>(std::abs(axis))), p.exponent) * maximum;
  return axis < 0.0F ? -size : size;
}

}  // namespace

Twin::Twin(std::vector<Event> history, const Parameters& parameters) : history_(std::move(history)), p_(parameters) {
  judge_lags();
  find_pauses();
  for (std::size_t e = 0; e < history_.size(); ++e) {
    if (!usable(e)) continue;
    const StickMessage& m = history_[e].message;
    const double omega = mapped(m.axes[0], p_, p_.max_vel_theta);
    const double v = mapped(m.axes[1], p_, p_.max_vel_x);
    Heard heard;
    heard.event = e;
    heard.time = history_[e].time;
    const bool both = p_.linear == LinearPolicy::axis || switching();
    heard.deflected = omega != 0.0 || (both && v != 0.0);
    heard.u_h = {both ? v : p_.max_vel_x, omega};
    heard.toggle = m.buttons[0] == 1;
    heard_.push_back(heard);
  }
  follow_stops();
}

bool Twin::readable(const StickMessage& m) const {
  if (m.axes.size() != 2) return false;
  if (m.buttons.size() != 2 || m.buttons[1] < 0 || m.buttons[1] > 1) return false;
  if (switching() && (m.buttons[0] < 0 || m.buttons[0] > 1)) return false;
  const bool linear_is_read = p_.linear == LinearPolicy::axis || switching() || pull_counts();
  return std::abs(m.axes[0]) <= 1.01F && (!linear_is_read || std::abs(m.axes[1]) <= 1.01F);
}

bool Twin::usable(std::size_t e) const { return is_message(e) && readable(history_[e].message) && !late_[e]; }

// A message is late by what its lag exceeds the link's present one. That is the smallest lag since the link was last
// taken to be slower, that is since lags beyond the limit had stayed within 0.1 s for 2 s. A lag that stays the same
// over a pause in which a backlog of it would have been worked off is that of another clock: the link is learnt anew.
void Twin::judge_lags() {
  struct Lag {
    std::size_t event;
    double time, lag;
  };
  std::vector<Lag> all, usual, refused;  // of every stamp; of the present link; refused in a row and steady
  late_.assign(history_.size(), false);
  double heard = 0.0;   // when the newest readable stamp arrived [s]
  double excess = 0.0;  // of the newest stamp that was not repeated [s]
  for (std::size_t e = 0; e < history_.size(); ++e) {
    const double time = history_[e].time, stamp = history_[e].message.stamp;
    if (!is_message(e) || !readable(history_[e].message) || stamp == 0.0 || p_.input_timeout == 0.0) continue;
    const double gap = time - heard;
    heard = time;
    if (!all.empty() && history_[all.back().event].message.stamp == stamp) {  // a repeated stamp: as the first time
      late_[e] = late_[all.back().event];
      continue;
    }
    const double pause = all.empty() ? 0.0 : std::min(gap, stamp - history_[all.back().event].message.stamp);
    const Lag lag{e, time, time - stamp};
    all.push_back(lag);
    usual.push_back(lag);
    // Clocks part by at most 2e-4, so an old lag may have grown by so much.
    const auto least = [time](const std::vector<Lag>& lags) {
      double value = 1e300;
      for (const Lag& old : lags) value = std::min(value, old.lag + 2e-4 * (time - old.time));
      return value;
    };
    const double excess_before = std::exchange(excess, lag.lag - least(all));
    late_[e] = lag.lag - least(usual) > p_.input_timeout || excess > std::max(p_.input_timeout, p_.input_lag_max);
    if (!late_[e]) {
      refused.clear();
      continue;
    }
    refused.push_back(lag);
    const auto by_lag = [](const Lag& a, const Lag& b) { return a.lag < b.lag; };
    const auto range = std::minmax_element(refused.begin(), refused.end(), by_lag);
    if (range.second->lag - range.first->lag > 0.1 || gap > p_.input_timeout) refused.assign(1, lag);
    const double steady_least = std::min_element(refused.begin(), refused.end(), by_lag)->lag;
    const double steady_most = std::max_element(refused.begin(), refused.end(), by_lag)->lag;
    const bool slower = time - refused.front().time >= 2.0 && steady_most - least(all) <= p_.input_lag_max;
    const bool other_clock = excess_before > p_.input_lag_max && pause > excess_before + p_.input_timeout &&
                             std::abs(excess - excess_before) <= 0.1;
    if (!slower && !other_clock) continue;
    late_[e] = false;
    slower_.push_back(e);
    usual.assign(1, slower ? Lag{e, time, steady_least} : lag);
    refused.clear();
    if (slower) continue;
    all.assign(1, lag);
    excess = 0.0;
  }
}

// Signs of life are cycles, messages and the words of the thread that takes them, which must have been heard once.
void Twin::find_pauses() {
  bool expected = false;
  std::optional<double> last;
  for (std::size_t e = 0; e < history_.size(); ++e) {
    const Event& event = history_[e];
    const bool listens = event.kind == Event::Kind::listens;
    expected = expected || listens;
    if (!listens && event.kind != Event::Kind::cycle && !is_message(e)) continue;
    if (expected && last && event.time - *last > 0.15) pauses_.push_back({e, event.time - *last});
    last = event.time;
  }
}

Twin::Pauses Twin::pauses_between(std::size_t after, std::size_t up_to) const {
  Pauses pauses;
  for (const Pause& pause : pauses_) {
    if (pause.event <= after || pause.event > up_to) continue;
    pauses.longest = std::max(pauses.longest, pause.length);
    pauses.sum += pause.length;
  }
  return pauses;
}

std::optional<std::size_t> Twin::last_heard(std::size_t before_event) const {
  std::optional<std::size_t> last;
  for (std::size_t i = 0; i < heard_.size(); ++i) {
    if (heard_[i].event < before_event) last = i;
  }
  return last;
}

// A silence longer than the timeout somewhere between two messages, other than by the planner's own pauses.
bool Twin::broken(std::size_t first, std::size_t last) const {
  if (p_.input_timeout == 0.0) return false;
  for (std::size_t i = first; i < last; ++i) {
    const double silence = heard_[i + 1].time - heard_[i].time;
    if (silence - pauses_between(heard_[i].event, heard_[i + 1].event).sum > p_.input_timeout) return true;
  }
  return false;
}

std::optional<std::size_t> Twin::centred_before(std::size_t heard) const {
  for (std::size_t i = heard + 1; i-- > 0;) {
    if (!heard_[i].deflected) return i;
  }
  return std::nullopt;
}

// Deflected, and since the stick was last seen centred without a loss and by the same link.
bool Twin::counts(std::size_t heard) const {
  if (!heard_[heard].deflected) return false;
  if (!p_.require_neutral) return true;
  const std::optional<std::size_t> centred = centred_before(heard);
  return centred && !broken(*centred + 1, heard) && !slower_between(*centred, heard);
}

bool Twin::slower_between(std::size_t first, std::size_t last) const {
  return std::any_of(slower_.begin(), slower_.end(),
                     [&](std::size_t event) { return event > heard_[first].event && event <= heard_[last].event; });
}

// In some cycle since the message it had been silent for too long, not counting the longest pause until then.
bool Twin::silent(std::size_t heard, std::size_t event) const {
  if (p_.input_timeout == 0.0) return false;
  for (std::size_t e = heard_[heard].event; e <= event; ++e) {
    if (history_[e].kind != Event::Kind::cycle) continue;
    const double silence = history_[e].time - heard_[heard].time;
    if (silence - pauses_between(heard_[heard].event, e).longest > p_.input_timeout) return true;
  }
  return false;
}

Twin::Device Twin::device(std::size_t event) const {
  const std::optional<std::size_t> last = last_heard(event);
  if (!last || !heard_[*last].deflected) return Device::quiet;
  if (counts(*last)) return silent(*last, event) ? Device::lost : Device::active;
  // Deflected again after a loss, by a slower link, or since the start.
  for (std::size_t i = *last; i > 0 && heard_[i].deflected; --i) {
    if (!counts(i)) continue;
    const bool lost = !slower_between(i, i + 1) || silent(i, heard_[i + 1].event);
    return lost ? Device::lost : Device::quiet;
  }
  return Device::quiet;
}

bool Twin::pull_counts() const {
  const bool reverse = p_.linear == LinearPolicy::axis && p_.min_vel_x < 0.0;
  return p_.stop_pull > 0.0 && !switching() && !reverse;
}

// Any message stops; one that is usable lets go. A word lets go as well, of what no message asked for in the last
// second.
void Twin::follow_stops() {
  bool said = false, button = false, pulled = false, seen_otherwise = false, dismissed = false;
  double asked = 0.0;  // [s]
  for (std::size_t e = 0; e < history_.size(); ++e) {
    const Event& event = history_[e];
    stopped_.push_back(said || button || pulled);
    if (event.kind == Event::Kind::say_stop) {
      said = event.said;
      dismissed = dismissed || !event.said;
    }
    if (event.kind == Event::Kind::cycle && dismissed && event.time - asked > 1.0) {
      button = pulled = dismissed = false;
      stopped_.back() = said;
    }
    dismissed = dismissed && (button || pulled);
    if (!is_message(e)) continue;
    const StickMessage& m = event.message;
    const bool lets_go = usable(e);
    const bool presses = m.buttons.size() > 1 && m.buttons[1] == 1;
    const bool has_pull = pull_counts() && m.axes.size() > 1 && std::isfinite(m.axes[1]);
    const double back = has_pull ? -static_cast<double>(m.axes[1]) : 0.0;
    const bool pulls = has_pull && back >= (pulled ? 0.75 : 1.0) * p_.stop_pull;
    seen_otherwise = seen_otherwise || (has_pull && !pulls) || !p_.require_neutral;
    const bool pull_stops_it = pulls && seen_otherwise;
    if (presses || pull_stops_it) {
      asked = event.time;
      dismissed = false;
    }
    button = presses || (button && !lets_go);
    pulled = pull_stops_it || (pulled && !lets_go);
  }
}

// Shortly after a message that ended a silence.
bool Twin::held_up(std::size_t heard) const {
  if (p_.input_timeout == 0.0) return false;
  for (std::size_t i = heard + 1; i-- > 0;) {
    const bool ended_silence = i == 0 || heard_[i].time - heard_[i - 1].time > p_.input_timeout;
    if (ended_silence) return i < heard && heard_[heard].time - heard_[i].time < 0.2;
  }
  return false;
}

std::optional<std::size_t> Twin::cycle_before(std::size_t event) const {
  for (std::size_t e = event; e-- > 0;) {
    if (history_[e].kind == Event::Kind::cycle) return e;
  }
  return std::nullopt;
}

bool Twin::press(std::size_t heard) const {
  if (heard == 0 || !heard_[heard].toggle || heard_[heard - 1].toggle || held_up(heard)) return false;
  const std::optional<std::size_t> cycle = cycle_before(heard_[heard].event);
  return cycle && heard_[heard].time - history_[*cycle].time < 1.0;
}

// Who has control in the cycle at `event`: the last word that a cycle took, then every press.
bool Twin::manual(std::size_t event) const {
  if (!switching()) return false;
  bool answer = false;
  std::size_t since = 0;
  for (std::size_t e = event; e-- > 0 && since == 0;) {
    if (history_[e].kind != Event::Kind::say_control) continue;
    std::size_t taker = e;
    while (history_[taker].kind != Event::Kind::cycle) ++taker;
    const std::optional<std::size_t> before = cycle_before(e);
    if (!before || history_[taker].time - history_[*before].time >= 1.0) continue;
    answer = history_[e].said;
    since = taker;
  }
  for (std::size_t i = 0; i < heard_.size(); ++i) {
    if (heard_[i].event > since && heard_[i].event < event && press(i)) answer = !answer;
  }
  return answer;
}

bool Twin::latched(const std::vector<Cycle>& past, std::size_t event) const {
  if (past.empty() || p_.method == Method::paper) return false;
  for (std::size_t e = past.back().event; e < event; ++e) {
    if (history_[e].kind == Event::Kind::new_goal) return false;
  }
  return past.back().feedback.goal_latched;
}

bool Twin::blocked(const std::vector<Cycle>& past, std::size_t event, double now) const {
  for (std::size_t e = event; e-- > 0;) {
    if (history_[e].kind == Event::Kind::new_goal) return false;
    if (history_[e].kind != Event::Kind::cycle) continue;
    for (const Cycle& cycle : past) {
      if (cycle.event != e) continue;
      if (!steers(cycle.state) || !cycle.feedback.operator_command_rejected || !cycle.feedback.stands) return false;
      if (now - cycle.time >= p_.blocked_time) return true;
    }
  }
  return false;
}

// v_h of the hold that runs in a cycle, if one does.
std::optional<double> Twin::held_velocity(const std::vector<Cycle>& past, std::size_t event, double now) const {
  // The last cycle that steered; the one after it began the hold.
  std::size_t last = past.size();
  while (last > 0 && !steers(past[last - 1].state)) --last;
  if (last == 0) return std::nullopt;
  const bool first_after = last == past.size();
  const std::size_t begin_event = first_after ? event : past[last].event;
  if (device(begin_event) == Device::lost && p_.on_input_lost != OnInputLost::hold) return std::nullopt;
  for (std::size_t i = last; i < past.size(); ++i) {
    const std::vector<Cycle> before(past.begin(), past.begin() + static_cast<std::ptrdiff_t>(i));
    if (past[i].state == State::stopped || latched(before, past[i].event)) return std::nullopt;
    if (p_.method == Method::hidwa && past[i].feedback.operator_command_rejected) return std::nullopt;
  }
  if (latched(past, event)) return std::nullopt;
  const std::size_t newest = last_heard(begin_event).value();
  std::size_t active = newest;
  while (!counts(active)) --active;
  const double ended = p_.input_timeout > 0.0 ? heard_[active].time : heard_[newest].time;
  if (now - ended >= p_.delta) return std::nullopt;
  const bool robots = p_.linear == LinearPolicy::current;
  return robots ? past[last - 1].feedback.command.v : heard_[active].u_h.v;
}

std::vector<OperatorIntent> Twin::intents() const {
  std::vector<Cycle> past;
  std::vector<OperatorIntent> answer;
  for (std::size_t e = 0; e < history_.size(); ++e) {
    if (history_[e].kind != Event::Kind::cycle) continue;
    const double now = history_[e].time;
    const State before = past.empty() ? State::autonomy : past.back().state;
    const Device now_device = device(e);
    const bool goal = latched(past, e);
    OperatorIntent intent;
    const bool in_control = manual(e);
    const bool matters = steers(before) || before == State::manual || before == State::lost || before == State::stopped;
    const bool loses = now_device == Device::lost && matters && (in_control || !switching());
    const bool shares = now_device == Device::active && !goal && !switching();
    const std::optional<double> hold = shares || switching() ? std::nullopt : held_velocity(past, e, now);
    if (stopped_[e]) {
      intent.state = State::stopped;
      intent.influence = Influence::stop;
    } else if (loses) {
      intent.state = State::lost;
      if (in_control || p_.on_input_lost == OnInputLost::stop) intent.influence = Influence::stop;
    } else if (in_control) {
      intent.state = State::manual;
      intent.influence = Influence::direct;
      intent.guarded = p_.guard == Guard::nearest;
      if (now_device == Device::active) intent.u_h = heard_[last_heard(e).value()].u_h;
    } else if (shares) {
      intent.state = blocked(past, e, now) ? State::blocked : State::shared;
      intent.influence = Influence::shared;
      intent.u_h = heard_[last_heard(e).value()].u_h;
      if (p_.linear == LinearPolicy::current) intent.u_h.v = past.empty() ? 0.0 : past.back().feedback.command.v;
    } else if (hold) {
      intent.state = State::hold;
    }
    const bool lost = intent.state == State::lost && !in_control;
    const bool straight = intent.state == State::hold || (lost && p_.on_input_lost == OnInputLost::hold);
    if (straight && hold) {
      intent.influence = Influence::shared;
      intent.u_h = {*hold, 0.0};
    }
    answer.push_back(intent);
    past.push_back({e, now, intent.state, history_[e].feedback});
  }
  return answer;
}

std::uint32_t Twin::dropped() const {
  std::uint32_t messages = 0;
  for (const Event& event : history_) messages += event.kind == Event::Kind::message ? 1U : 0U;
  return messages - static_cast<std::uint32_t>(heard_.size());
}

}  // namespace hidwa_local_planner::input
