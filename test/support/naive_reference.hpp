// SPDX-License-Identifier: BSD-3-Clause
// Where a cycle starts from and what it believes of odometry, the slow way: all cycles that ever were are searched.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "hidwa_local_planner/core/planner.hpp"
#include "support/naive_effects.hpp"
#include "support/naive_trail.hpp"

namespace hidwa_local_planner::test {

/// A cycle, as far as the reference is concerned.
struct NaiveCycle {
  double time = 0.0, period = 0.0;  // [s]
  Twist2 last_command;
  Twist2 measured;        // [m/s, rad/s]
  double pose_age = 0.0;  // [s]
};

inline NaiveCycle naive_cycle(const Situation& s) { return {s.time, s.period, s.last_command, s.velocity, s.pose_age}; }

/// What odometry may show of one axis.
struct NaiveExplained {
  double lo, hi, tolerance;  // [unit/s]

  bool fast(double measured) const {
    return measured > std::max(hi, 0.0) + tolerance || measured < std::min(lo, 0.0) - tolerance;
  }
  bool agrees(double measured) const { return measured >= lo - tolerance && measured <= hi + tolerance; }
};

/// The same cycles on a clock that nobody sets: where time went back, a period had passed.
inline std::vector<NaiveCycle> naive_steady(std::vector<NaiveCycle> cycles) {
  for (std::size_t i = cycles.size() - 1; i > 0; --i) {
    if (cycles[i].time >= cycles[i - 1].time) continue;
    const double set = cycles[i].time - cycles[i].period - cycles[i - 1].time;
    for (std::size_t k = 0; k < i; ++k) cycles[k].time += set;
  }
  return cycles;
}

/// The twin of CommandHistory, for one set of parameters and times that are numbers. The last cycle is the one that
/// asks.
class NaiveHistory {
 public:
  NaiveHistory(const Parameters& p, const std::vector<NaiveCycle>& told)
      : p_(p), now_(told.back()), effects_(p, now_.period, {}, {}) {
    const std::vector<NaiveCycle> cycles = naive_steady(told);
    std::vector<NaiveEffect> list;
    for (std::size_t i = 0; i < cycles.size(); ++i) {
      if (i + 1 < cycles.size() && cycles[i + 1].time == cycles[i].time) continue;  // told anew
      std::size_t before = i;  // the last cycle at another time: its command is what this one found
      while (before > 0 && cycles[before].time == cycles[i].time) --before;
      list.push_back({cycles[before].time + p.control_latency - now_.time, cycles[i].last_command});
    }
    effects_ = {p, now_.period, cycles.front().last_command, list};
  }
  const NaiveEffects& effects() const { return effects_; }

  /// Which of the effects odometry may still show: from the one on that was in force a latency, a period and the pose's
  /// age ago.
  std::size_t first_shown() const {
    const std::vector<NaiveEffect>& list = effects_.list();
    const double begin = -now_.period - now_.pose_age + 1e-6;  // it takes effect a latency after it was sent
    std::size_t first = 0;
    while (first + 1 < list.size() && list[first + 1].time <= begin) ++first;
    return first;
  }
  std::size_t shown() const { return effects_.list().size() - first_shown(); }

  NaiveExplained explained(double Twist2::*axis) const {
    const Twist2 last = now_.last_command;
    NaiveExplained all{last.*axis, last.*axis, 0.2};
    for (std::size_t i = first_shown(); i < effects_.list().size(); ++i) {
      for (const double u : {effects_.list()[i].command.*axis, effects_.from(i).*axis}) {
        all.lo = std::min(all.lo, u);
        all.hi = std::max(all.hi, u);
      }
    }
    if (axis == &Twist2::v) return all;
    // Inside its dead band a robot stands though it is told to turn.
    const double dead_band = p_.min_in_place_vel_theta;
    all.tolerance = 0.5 + (std::abs(last.omega) <= dead_band ? std::abs(last.omega) : 0.0);
    return all;
  }

 private:
  Parameters p_;
  NaiveCycle now_;
  NaiveEffects effects_;
};

/// What to make of each reading of one axis: of all readings so far.
class NaiveBelief {
 public:
  /// Within `change` [unit/s] and as much as the limit allows, `fastest_change` [unit/s^2], one reading follows
  /// another.
  struct Reading {
    double time, measured;
    bool fast, slow;
    double change, fastest_change;
  };

  explicit NaiveBelief(const std::vector<Reading>& readings) : readings_(readings) {
    for (std::size_t k = 0; k < readings_.size(); ++k) {
      const int trusted = last_trusted(k);
      trusted_.push_back(readings_[k].fast && (agrees_for_long(k) || (trusted >= 0 && follows(k, at(trusted)))));
    }
  }
  /// The last reading is fast and believed, or so is one a moment before it.
  bool sure() const { return readings_.back().fast && (trusted_.back() || last_trusted(readings_.size() - 1) >= 0); }
  double believed() const {
    return trusted_.back() ? readings_.back().measured : readings_[at(last_trusted(readings_.size() - 1))].measured;
  }

  /// The last three readings or more are slow, and each follows the one before it. One that is found again at the same
  /// time is no other.
  bool held() const {
    std::vector<std::size_t> run;
    for (std::size_t k = 0; k < readings_.size(); ++k) {
      const bool again = !run.empty() && readings_[k].time == readings_[run.back()].time;
      if (readings_[k].slow && again) continue;
      if (!readings_[k].slow || (!run.empty() && !follows(k, run.back()))) run.clear();
      if (readings_[k].slow) run.push_back(k);
    }
    return run.size() >= 3;
  }

 private:
  static std::size_t at(int k) { return static_cast<std::size_t>(k); }
  bool follows(std::size_t k, std::size_t before) const {
    const Reading& now = readings_[k];
    const double passed = std::max(now.time - readings_[before].time, 0.0);
    return std::abs(now.measured - readings_[before].measured) <= now.change + now.fastest_change * passed;
  }
  // Since 0.3 s or more all were fast, and each followed the one before.
  bool agrees_for_long(std::size_t k) const {
    std::size_t first = k;
    while (first > 0 && readings_[first - 1].fast && follows(first, first - 1)) --first;
    return readings_[k].time - readings_[first].time >= 0.3;
  }
  // Before number k, no more than 0.3 s, and none in between that was not fast; -1 where there is none.
  int last_trusted(std::size_t k) const {
    for (int j = static_cast<int>(k) - 1; j >= 0 && readings_[at(j)].fast; --j) {
      if (trusted_[at(j)]) return readings_[k].time - readings_[at(j)].time <= 0.3 ? j : -1;
    }
    return -1;
  }

  std::vector<Reading> readings_;
  std::vector<bool> trusted_;
};

/// Where the last of some cycles starts from, what it believes, and how the robot may go on.
class NaiveReference {
 public:
  NaiveReference(const Parameters& p, const std::vector<NaiveCycle>& cycles)
      : p_(p),
        cycles_(cycles),
        history_(p, cycles),
        reference_(cycles.back().last_command),
        believed_(cycles.back().measured) {
    const double age = cycles.back().pose_age, latency = p.control_latency;
    ways_.push_back(naive_outlook(history_.effects(), age, latency));
    // As many shorter latencies as there are periods in it, six at most, from none on.
    const double shorter = ways_[0].rests() ? 0.0 : std::min(std::ceil(latency / cycles.back().period), 6.0);
    for (double n = 0.0; n < shorter; n += 1.0) {
      const double quick = latency * n / shorter;
      unlikely_.push_back(naive_outlook(history_.effects().sooner(latency - quick), age, quick));
    }
    for (const NaiveLag& lag : naive_lags()) {
      lagging_.push_back(naive_outlook(history_.effects().lagging(history_.first_shown(), lag), age, latency));
    }
    judge(&Twist2::v);
    judge(&Twist2::omega);
  }
  Twist2 reference() const { return reference_; }
  Twist2 believed() const { return believed_; }
  bool doubted() const { return doubted_; }
  bool fast() const { return fast_; }
  /// The first as the commands say; where odometry says otherwise, also as it says.
  const std::vector<NaiveOutlook>& ways() const { return ways_; }
  /// That one of them along which an old pose is led on.
  const NaiveOutlook& likeliest() const { return ways_[likeliest_]; }
  /// The limits of this cycle: while something holds the robot, nothing faster than what could have started from there.
  Parameters limited() const {
    Parameters p = p_;
    p.max_vel_x = std::max(std::min(0.0, p.min_vel_x), std::min(p.max_vel_x, most_.v));
    if (p.min_vel_x <= 0.0) p.min_vel_x = std::min(p.max_vel_x, std::max(p.min_vel_x, -most_.v));
    p.max_vel_theta = std::min(p.max_vel_theta, most_.omega);
    return p;
  }
  /// For those who want to be sure: a base that is quicker than the latency says.
  const std::vector<NaiveOutlook>& unlikely_ways() const { return unlikely_; }
  /// As the commands say, by bases that lag.
  const std::vector<NaiveOutlook>& lagging_ways() const { return lagging_; }

 private:
  void judge(double Twist2::*axis) {
    const double measured = cycles_.back().measured.*axis, last = cycles_.back().last_command.*axis;
    const bool is_v = axis == &Twist2::v;
    const NaiveExplained explained = history_.explained(axis);
    if (explained.fast(measured)) {
      const NaiveBelief belief = beliefs(axis);
      believed_.*axis = belief.sure() ? belief.believed() : last;
      (belief.sure() ? fast_ : doubted_) = true;
      if (belief.sure()) go_otherwise(axis, believed_.*axis, true);
    } else if (!explained.agrees(measured)) {
      const bool held = beliefs(axis).held();
      if (held) {
        most_.*axis = std::abs(measured) + cycles_.back().period * (is_v ? p_.acc_lim_x : p_.acc_lim_theta);
      } else {
        believed_.*axis = last;
        doubted_ = true;
      }
      go_otherwise(axis, measured, held);
    } else if (p_.method == Method::paper) {
      // No start is beyond both the limits and the last command.
      const double highest = is_v ? p_.max_vel_x : p_.max_vel_theta,
                   lowest = is_v ? std::min(0.0, p_.min_vel_x) : -p_.max_vel_theta;
      reference_.*axis = std::max(std::min({lowest, last, 0.0}), std::min(measured, std::max({highest, last, 0.0})));
      go_otherwise(axis, measured, true);
    }
  }
  NaiveBelief beliefs(double Twist2::*axis) const {
    std::vector<NaiveBelief::Reading> readings;
    const double fastest_change =
        axis == &Twist2::v ? std::max(p_.acc_lim_x, p_.braking_x()) : std::max(p_.acc_lim_theta, p_.braking_theta());
    for (std::size_t k = 0; k < cycles_.size(); ++k) {
      const NaiveHistory then(p_, {cycles_.begin(), cycles_.begin() + static_cast<std::ptrdiff_t>(k) + 1});
      const NaiveExplained explained = then.explained(axis);
      const double measured = cycles_[k].measured.*axis;
      const bool fast = explained.fast(measured);
      readings.push_back(
          {cycles_[k].time, measured, fast, !fast && !explained.agrees(measured), explained.tolerance, fastest_change});
    }
    return NaiveBelief(readings);
  }
  void go_otherwise(double Twist2::*axis, double velocity, bool likeliest) {
    const std::vector<NaiveOutlook> before = ways_;
    if (likeliest) likeliest_ += before.size();
    for (const NaiveOutlook& way : before) ways_.push_back(way.with(axis, velocity));
  }

  Parameters p_;
  std::vector<NaiveCycle> cycles_;
  NaiveHistory history_;
  Twist2 reference_, believed_;
  bool doubted_ = false, fast_ = false;
  Twist2 most_{INFINITY, INFINITY};
  std::vector<NaiveOutlook> ways_, unlikely_, lagging_;
  std::size_t likeliest_ = 0;
};

}  // namespace hidwa_local_planner::test
