// SPDX-License-Identifier: BSD-3-Clause
// Where a cycle starts from, the slow way: all cycles that ever were are searched every time.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "hidwa_local_planner/core/planner.hpp"
#include "support/naive_effects.hpp"

namespace hidwa_local_planner::test {

/// A cycle, as far as the reference is concerned.
struct NaiveCycle {
  double time = 0.0, period = 0.0;  // [s]
  Twist2 last_command;
};

inline NaiveCycle naive_cycle(const Situation& s) { return {s.time, s.period, s.last_command}; }

/// The twin of CommandHistory and velocity_reference(), for one set of parameters and times that are numbers. The last
/// cycle is the one that asks.
class NaiveReference {
 public:
  NaiveReference(const Parameters& p, const std::vector<NaiveCycle>& cycles) : p_(p), cycles_(cycles) {
    const NaiveCycle& now = cycles_.back();
    const double begin = now.time - p_.control_latency - now.period;
    std::size_t in_force = 0;  // when the window begins: the last one that was sent by then
    for (std::size_t i = 0; i < cycles_.size(); ++i) {
      if (known(i) && sent(i) <= begin + 1e-6) in_force = i;
    }
    for (std::size_t i = in_force; i < cycles_.size(); ++i) {
      if (!known(i)) continue;
      shown_.push_back(cycles_[i].last_command);
      effects_.push_back({sent(i) + p_.control_latency - now.time, cycles_[i].last_command});
    }
  }
  const std::vector<Twist2>& shown() const { return shown_; }

  Twist2 of(const Twist2& measured) const { return agrees(measured) ? cycles_.back().last_command : measured; }
  /// What is under way.
  const std::vector<NaiveEffect>& effects() const { return effects_; }

  bool agrees(const Twist2& measured) const {
    if (p_.velocity_reference == VelocityReference::odometry) return false;
    const Twist2 last = cycles_.back().last_command;
    const double dead_band = std::max(p_.min_vel_theta, p_.min_in_place_vel_theta);
    const double still = std::abs(last.omega) <= dead_band ? std::abs(last.omega) : 0.0;
    // Between two of them, or near one.
    double least_v = INFINITY, least_omega = INFINITY;
    for (const Twist2& a : shown_) {
      for (const Twist2& b : shown_) {
        least_v = std::min(least_v, off(measured.v, a.v, b.v));
        least_omega = std::min(least_omega, off(measured.omega, a.omega, b.omega));
      }
    }
    return least_v <= p_.velocity_reference_tolerance_x &&
           least_omega <= p_.velocity_reference_tolerance_theta + still;
  }

 private:
  // How far outside of two values another one lies.
  static double off(double value, double a, double b) {
    if ((value - a) * (value - b) <= 0.0) return 0.0;
    return std::min(std::abs(value - a), std::abs(value - b));
  }
  // The last cycle before number i at another time; -1 where there is none.
  int before(std::size_t i) const {
    for (int n = static_cast<int>(i) - 1; n >= 0; --n) {
      if (cycles_[static_cast<std::size_t>(n)].time != cycles_[i].time) return n;
    }
    return -1;
  }
  // Nothing could have followed the command of number i from what came before.
  bool breaks(std::size_t i) const {
    const int n = before(i);
    if (n < 0) return false;
    const NaiveCycle& from = cycles_[static_cast<std::size_t>(n)];
    const NaiveCycle& to = cycles_[i];
    const double step = std::max(p_.acc_lim_x, p_.braking_x()) * to.period + 1e-6;
    const double turn = std::max(p_.acc_lim_theta, p_.braking_theta()) * to.period + 1e-6;
    return to.time < from.time || std::abs(to.last_command.v - from.last_command.v) > step ||
           std::abs(to.last_command.omega - from.last_command.omega) > turn;
  }
  bool known(std::size_t i) const {
    if (i + 1 < cycles_.size() && cycles_[i + 1].time == cycles_[i].time) return false;  // told anew
    for (std::size_t later = i + 1; later < cycles_.size(); ++later) {
      if (breaks(later)) return false;
    }
    return true;
  }
  double sent(std::size_t i) const {
    const int n = before(i);
    return n < 0 || cycles_[static_cast<std::size_t>(n)].time > cycles_[i].time
               ? cycles_[i].time
               : cycles_[static_cast<std::size_t>(n)].time;
  }

  Parameters p_;
  std::vector<NaiveCycle> cycles_;
  std::vector<Twist2> shown_;
  std::vector<NaiveEffect> effects_;
};

}  // namespace hidwa_local_planner::test
