// SPDX-License-Identifier: BSD-3-Clause
// What commands that take effect one after the other make of the velocity, by searching them for every time.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "hidwa_local_planner/core/parameters.hpp"
#include "hidwa_local_planner/core/types.hpp"

namespace hidwa_local_planner::test {

/// A command and when it takes effect, counted from now [s]. The first of a list was in force long before.
struct NaiveEffect {
  double time = 0.0;
  Twist2 command;
};

/// How long an axis needs from one velocity to another, `most` at the longest: all of it where it slows down.
inline double naive_needed(double from, double to, double most, double acc, double braking) {
  if (from * to >= 0.0 && std::abs(to) <= std::abs(from)) return most;
  const double needed = from * to < 0.0 ? std::abs(from) / braking + std::abs(to) / acc : std::abs(to - from) / acc;
  return std::min(needed, most);
}

/// `p` must outlive it.
class NaiveEffects {
 public:
  /// Each command is reached within `period` [s], or before the next one takes effect.
  NaiveEffects(const Parameters& p, double period, std::vector<NaiveEffect> effects)
      : p_(&p), period_(period), effects_(std::move(effects)) {}
  /// One velocity for ever.
  NaiveEffects(const Parameters& p, double period, const Twist2& u)
      : NaiveEffects(p, period, std::vector<NaiveEffect>{{0.0, u}}) {}

  NaiveEffects then(double time, const Twist2& command) const {
    NaiveEffects more = *this;
    more.effects_.push_back({time, command});
    return more;
  }

  Twist2 velocity(double t) const {
    std::size_t i = 0;
    while (i + 1 < effects_.size() && effects_[i + 1].time <= t) ++i;
    const Twist2 to = effects_[i].command;
    if (i == 0) return to;
    const Twist2 from = effects_[i - 1].command;
    const double age = t - effects_[i].time;
    const auto now = [age](double a, double b, double needed) { return age < needed ? a + (b - a) * age / needed : b; };
    return {now(from.v, to.v, needed_v(i)), now(from.omega, to.omega, needed_omega(i))};
  }

  /// Between two times: when the velocity may begin to change otherwise, both ends included.
  std::vector<double> corners(double begin, double end) const {
    std::vector<double> all{begin, end};
    for (std::size_t i = 1; i < effects_.size(); ++i) {
      const double at = effects_[i].time;
      for (const double t : {at, at + needed_v(i), at + needed_omega(i), at + most(i)}) {
        if (t > begin && t < end) all.push_back(t);
      }
    }
    std::sort(all.begin(), all.end());
    const auto same = [](double a, double b) { return b - a <= 1e-6; };
    all.erase(std::unique(all.begin(), all.end(), same), all.end());
    return all;
  }

 private:
  double most(std::size_t i) const {
    return i + 1 < effects_.size() ? std::min(period_, effects_[i + 1].time - effects_[i].time) : period_;
  }
  double needed_v(std::size_t i) const {
    return naive_needed(effects_[i - 1].command.v, effects_[i].command.v, most(i), p_->acc_lim_x, p_->braking_x());
  }
  double needed_omega(std::size_t i) const {
    return naive_needed(effects_[i - 1].command.omega, effects_[i].command.omega, most(i), p_->acc_lim_theta,
                        p_->braking_theta());
  }

  const Parameters* p_;
  double period_;  // [s]
  std::vector<NaiveEffect> effects_;
};

}  // namespace hidwa_local_planner::test
