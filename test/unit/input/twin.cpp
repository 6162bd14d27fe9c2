// SPDX-License-Identifier: BSD-3-Clause
#include "twin.hpp"

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

Twin::Twin(std::vector<Event> history, const Parameters& parameters)
    : history_(std::move(history)), p_(parameters) {
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
    heard.stop = m.buttons[1] == 1;
    heard.pulled = -static_cast<double>(m.axes[1]);
    heard_.push_back(heard);
  }
}

bool Twin::readable(const StickMessage& m) const {
  if (m.axes.size() != 2 || !std::isfinite(m.axes[0]) || !std::isfinite(m.axes[1])) return false;
  if (m.buttons.size() != 2 || m.buttons[1] < 0 || m.buttons[1] > 1) return false;
  if (switching() && (m.buttons[0] < 0 || m.buttons[0] > 1)) return false;
  const bool linear_is_read = p_.linear == LinearPolicy::axis || switching() || pull_counts();
  return std::abs(m.axes[0]) <= 1.01F && (!linear_is_read || std::abs(m.axes[1]) <= 1.01F);
}

bool Twin::usable(std::size_t e) const {
  return history_[e].kind == Event::Kind::message && readable(history_[e].message) && !held_back(e);
}

bool Twin::held_back(std::size_t e) const {
  const double stamp = history_[e].message.stamp;
  if (stamp == 0.0 || p_.input_timeout == 0.0) return false;
  double least = 1e300;
  for (std::size_t i = 0; i <= e; ++i) {
    if (history_[i].kind != Event::Kind::message || !readable(history_[i].message)) continue;
    if (history_[i].message.stamp == 0.0) continue;
    const double lag = history_[i].time - history_[i].message.stamp;
    // Clocks part by at most 2e-4, so an old lag may have grown by so much.
    least = std::min(least, lag + 2e-4 * (history_[e].time - history_[i].time));
    if (i < e && history_[i].message.stamp == stamp)
      return held_back(i);  // a repeated stamp: as the first time
  }
  return history_[e].time - stamp - least > p_.input_timeout;
}

std::optional<std::size_t> Twin::last_heard(std::size_t before_event) const {
  std::optional<std::size_t> last;
  for (std::size_t i = 0; i < heard_.size(); ++i) {
    if (heard_[i].event < before_event) last = i;
  }
  return last;
}

// A silence longer than the timeout somewhere between two messages.
bool Twin::broken(std::size_t first, std::size_t last) const {
  if (p_.input_timeout == 0.0) return false;
  for (std::size_t i = first; i < last; ++i) {
    if (heard_[i + 1].time - heard_[i].time > p_.input_timeout) return true;
  }
  return false;
}

std::optional<std::size_t> Twin::centred_before(std::size_t heard) const {
  for (std::size_t i = heard + 1; i-- > 0;) {
    if (!heard_[i].deflected) return i;
  }
  return std::nullopt;
}

// Deflected, and without a loss since the stick was last seen centred.
bool Twin::counts(std::size_t heard) const {
  if (!heard_[heard].deflected) return false;
  if (!p_.require_neutral) return true;
  const std::optional<std::size_t> centred = centred_before(heard);
  return centred && !broken(*centred + 1, heard);
}

Twin::Device Twin::device(std::size_t event, double now) const {
  const std::optional<std::size_t> last = last_heard(event);
  if (!last || !heard_[*last].deflected) return Device::quiet;
  const bool silent = p_.input_timeout > 0.0 && now - heard_[*last].time > p_.input_timeout;
  if (counts(*last)) return silent ? Device::lost : Device::active;
  return centred_before(*last) ? Device::lost
                               : Device::quiet;  // deflected again after a loss, or since the start
}

bool Twin::pull_counts() const {
  const bool reverse = p_.linear == LinearPolicy::axis && p_.min_vel_x < 0.0;
  return p_.stop_pull > 0.0 && !switching() && !reverse;
}

// Since the stick was last back by a quarter of the threshold it was once beyond it, and before that it was
// seen not to be.
bool Twin::pulled(std::size_t heard) const {
  if (!pull_counts()) return false;
  for (std::size_t i = heard + 1; i-- > 0 && heard_[i].pulled >= 0.75 * p_.stop_pull;) {
    if (heard_[i].pulled < p_.stop_pull) continue;
    if (!p_.require_neutral) return true;
    for (std::size_t k = 0; k < i; ++k) {
      if (heard_[k].pulled < p_.stop_pull) return true;
    }
  }
  return false;
}

bool Twin::stopped(std::size_t event) const {
  for (std::size_t e = event; e-- > 0;) {
    if (history_[e].kind != Event::Kind::say_stop) continue;
    if (history_[e].said) return true;
    break;
  }
  const std::optional<std::size_t> last = last_heard(event);
  return last && (heard_[*last].stop || pulled(*last));
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
  if (past.empty() || p_.operator_in_goal_window) return false;
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
      if (!steers(cycle.state) || !cycle.feedback.own_command_refused || !cycle.feedback.at_rest)
        return false;
      if (now - cycle.time >= p_.blocked_time) return true;
    }
  }
  return false;
}

// v_h of the hold that runs in a cycle, if one does.
std::optional<double> Twin::held_velocity(const std::vector<Cycle>& past, std::size_t event,
                                          double now) const {
  // The last cycle that steered; the one after it began the hold.
  std::size_t last = past.size();
  while (last > 0 && !steers(past[last - 1].state)) --last;
  if (last == 0) return std::nullopt;
  const bool first_after = last == past.size();
  const std::size_t begin_event = first_after ? event : past[last].event;
  const double begin_time = first_after ? now : past[last].time;
  if (device(begin_event, begin_time) == Device::lost && p_.on_input_lost != OnInputLost::hold)
    return std::nullopt;
  for (std::size_t i = last; i < past.size(); ++i) {
    const std::vector<Cycle> before(past.begin(), past.begin() + static_cast<std::ptrdiff_t>(i));
    if (past[i].state == State::stopped || latched(before, past[i].event)) return std::nullopt;
    if (p_.hold_ends_when_refused && past[i].feedback.own_command_refused) return std::nullopt;
  }
  if (latched(past, event)) return std::nullopt;
  const std::size_t newest = last_heard(begin_event).value();
  std::size_t active = newest;
  while (!counts(active)) --active;
  const double ended = p_.input_timeout > 0.0 ? heard_[active].time : heard_[newest].time;
  if (now - ended >= p_.delta) return std::nullopt;
  const bool robots = p_.hold_linear == HoldLinear::robot || p_.linear == LinearPolicy::current;
  return robots ? past[last - 1].feedback.command.v : heard_[active].u_h.v;
}

std::vector<OperatorIntent> Twin::intents() const {
  std::vector<Cycle> past;
  std::vector<OperatorIntent> answer;
  for (std::size_t e = 0; e < history_.size(); ++e) {
    if (history_[e].kind != Event::Kind::cycle) continue;
    const double now = history_[e].time;
    const State before = past.empty() ? State::autonomy : past.back().state;
    const Device now_device = device(e, now);
    const bool goal = latched(past, e);
    OperatorIntent intent;
    const bool in_control = manual(e);
    const bool matters =
        steers(before) || before == State::manual || before == State::lost || before == State::stopped;
    const bool loses = now_device == Device::lost && matters && (in_control || !switching());
    const bool shares = now_device == Device::active && !goal && !switching();
    const std::optional<double> hold = shares || switching() ? std::nullopt : held_velocity(past, e, now);
    if (stopped(e)) {
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
      if (p_.linear == LinearPolicy::current)
        intent.u_h.v = past.empty() ? 0.0 : past.back().feedback.command.v;
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
