// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "core/motion/cycle_start.hpp"

namespace hidwa_local_planner {

/// What a command may come to within a period, whichever way, cut into a few parts. The check of the command in the
/// middle of a part, with an allowance, serves all others of the part.
class WindowParts {
 public:
  struct Part {
    bool looked_at = false;
    bool free = false;  // all of its commands are
    Twist2 middle;      // [m/s, rad/s]
  };

  void divide(const CycleStart& start) {
    period_ = start.period;
    const Twist2 half{std::max(start.limits.x.acc, start.limits.x.braking) * period_,
                      std::max(start.limits.theta.acc, start.limits.theta.braking) * period_};
    least_ = {start.reference.v - half.v, start.reference.omega - half.omega};
    size_ = {2.0 * half.v / kParts, 2.0 * half.omega / kParts};
    parts_.fill({});
    divided_ = true;
  }
  /// Every command is looked at by itself.
  void leave_whole() { divided_ = false; }

  /// The part of a command [m/s, rad/s]; null where it has none.
  Part* find(const Twist2& command) {
    const double v = (command.v - least_.v) / size_.v, omega = (command.omega - least_.omega) / size_.omega;
    const auto inside = [](double at) { return at >= -kRounding && at <= kParts + kRounding; };
    if (!divided_ || !inside(v) || !inside(omega)) return nullptr;
    const auto place = [](double at) { return std::min(kParts - 1, static_cast<std::size_t>(std::max(0.0, at))); };
    const std::size_t i = place(v), j = place(omega);
    Part& part = parts_[i * kParts + j];
    part.middle = {least_.v + (static_cast<double>(i) + 0.5) * size_.v,
                   least_.omega + (static_cast<double>(j) + 0.5) * size_.omega};
    return &part;
  }

  /// How far way and heading may differ between the manoeuvres of a part's command and of its middle, within `duration`
  /// [s], after a pending motion that ends with this velocity [m, rad]. Until a command is reached, within a period,
  /// both velocities lie between that end and their commands; from then on they differ by no more than the commands do,
  /// since both brake alike.
  Twist2 apart(const Twist2& end, double duration) const {
    const auto integral = [&](double from, double least, double size) {
      const double reaching = std::max(std::abs(from - least), std::abs(from - least - kParts * size));
      return period_ * reaching + duration * 0.5 * size;
    };
    return {integral(end.v, least_.v, size_.v), integral(end.omega, least_.omega, size_.omega)};
  }

 private:
  static constexpr std::size_t kParts = 3;   // of each axis
  static constexpr double kRounding = 1e-6;  // of a part

  std::array<Part, kParts * kParts> parts_;
  Twist2 least_, size_;  // the least command, and how large a part is [m/s, rad/s]
  double period_ = 0.0;  // [s]
  bool divided_ = false;
};

}  // namespace hidwa_local_planner
