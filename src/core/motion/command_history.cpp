// SPDX-License-Identifier: BSD-3-Clause
#include "core/motion/command_history.hpp"

#include <algorithm>
#include <cmath>

#include "core/motion/command_ramp.hpp"
#include "core/motion/same_time.hpp"

namespace hidwa_local_planner {
namespace {

// Makes legs of a velocity over time, given by its corners; time is counted from where the legs begin.
class Player {
 public:
  Player(const Twist2& u, PendingMotion& pending) : u_(u), pending_(pending) { pending_.begin(u); }

  // The velocity changes evenly to `u` at `time` [s], from the last corner on; before the beginning it has done so
  // already.
  void corner(double time, const Twist2& u) {
    if (time <= kSameTime) {
      at_ = std::min(time, 0.0);
      u_ = u;
      pending_.begin(u);
      return;
    }
    if (at_ < 0.0) pass_begin(time, u);
    if (!(u == u_)) {
      leg_to(at_, u_);
      leg_to(time, u);
    }
    at_ = time;
    u_ = u;
  }
  // From the last corner on the robot may be so far off.
  void spread(const Twist2& by) {
    if (by == Twist2{}) return;
    leg_to(at_, u_);
    spread_.v += by.v;
    spread_.omega += by.omega;
  }
  // What was even up to the end is one leg.
  void finish(double end) {
    at_ = end;
    leg_to(at_, u_);
  }

 private:
  void pass_begin(double time, const Twist2& u) {
    const double gone = -at_ / (time - at_);
    u_ = {u_.v + gone * (u.v - u_.v), u_.omega + gone * (u.omega - u_.omega)};
    at_ = 0.0;
    pending_.begin(u_);
  }
  void leg_to(double time, const Twist2& u) {
    if (time - done_ <= kSameTime) return;
    pending_.add(u, time - done_, spread_);
    spread_ = {};
    done_ = time;
  }

  double at_ = 0.0, done_ = 0.0;  // [s]: the last corner, the end of the last leg
  Twist2 u_, spread_;
  PendingMotion& pending_;
};

}  // namespace

void CommandHistory::observe(double now, double period, double span, const Twist2& command,
                             const VelocityLimits& limits) {
  if (!seen_ || !std::isfinite(*seen_) || !std::isfinite(now)) forget();
  if (seen_ && now < *seen_) shift(now - period - *seen_);
  Sent newest{seen_.value_or(now), command, command};
  if (!sent_.empty() && now == *seen_) {
    newest.time = sent_.back().time;
    newest.from = sent_.back().from;
    sent_.pop_back();
  } else if (seen_) {
    elapsed_ = now - *seen_;
  }
  if (!sent_.empty()) {
    const Sent& before = sent_.back();
    newest.from = CommandRamp(limits, before.from, before.command, period).at(newest.time - before.time);
  }
  if (sent_.size() == kMost) sent_.erase(sent_.begin());
  sent_.push_back(newest);
  // A command is in force until the next one is sent.
  const double begin = now - span + kSameTime;
  while (sent_.size() > 1 && sent_[1].time <= begin) sent_.erase(sent_.begin());
  seen_ = now;
}

void CommandHistory::shift(double by) {
  for (Sent& sent : sent_) sent.time += by;
  *seen_ += by;
}

void CommandHistory::forget() {
  sent_.clear();
  seen_.reset();
  elapsed_ = 0.0;
}

Interval CommandHistory::range(double Twist2::*axis) const {
  Interval all{last().*axis, last().*axis};
  for (const Sent& sent : sent_) {
    all.lo = std::min({all.lo, sent.command.*axis, sent.from.*axis});
    all.hi = std::max({all.hi, sent.command.*axis, sent.from.*axis});
  }
  return all;
}

void CommandHistory::play(const VelocityLimits& limits, double period, double latency, double age,
                          PendingMotion& pending, const Lag& lag) const {
  const double begin = seen_.value_or(0.0) - age;  // [s]
  const double end = latency + age;
  const auto effect = [&](std::size_t i) { return i < sent_.size() ? sent_[i].time + latency - begin : end; };
  Twist2 reached = sent_.empty() ? Twist2{} : sent_.front().from;
  Player player(reached, pending);
  for (std::size_t i = 0; i < sent_.size(); ++i) {
    const double start = effect(i), length = effect(i + 1) - start;
    const Twist2 from{lag.v ? reached.v : sent_[i].from.v, lag.omega ? reached.omega : sent_[i].from.omega};
    const CommandRamp ramp(limits, from, sent_[i].command, period, lag);
    player.corner(start, from);
    if (start + period > 0.0) player.spread(ramp.spread(length));
    for (const double corner : ramp.corners(length)) player.corner(start + corner, ramp.at(corner));
    reached = ramp.at(length);
  }
  player.finish(end);
  pending.set_lag(lag);
}

}  // namespace hidwa_local_planner
