// SPDX-License-Identifier: BSD-3-Clause
#include "core/search/motion_fan.hpp"

#include <algorithm>

namespace hidwa_local_planner {
namespace {

constexpr std::size_t kUsualMotions = 64;

// Where among `parts` the one with this target is; it is put there if there is none.
template <typename Part>
std::size_t place_of(std::vector<Part>& parts, double target) {
  const auto same = [target](const Part& part) { return part.target == target; };
  const auto found = std::find_if(parts.begin(), parts.end(), same);
  if (found != parts.end()) return static_cast<std::size_t>(found - parts.begin());
  parts.emplace_back();
  parts.back().target = target;
  return parts.size() - 1;
}

}  // namespace

MotionFan::MotionFan() {
  speeds_.reserve(kUsualMotions);
  turns_.reserve(kUsualMotions);
  motions_.reserve(kUsualMotions);
}

void MotionFan::clear() {
  speeds_.clear();
  turns_.clear();
  motions_.clear();
}

void MotionFan::add(const Twist2& motion) {
  motions_.push_back({place_of(speeds_, motion.v), place_of(turns_, motion.omega)});
}

void MotionFan::unfold(const VelocityLimits& limits, const Rotation& heading, const Twist2& velocity, double step) {
  for (Speed& speed : speeds_) {
    double v = velocity.v;
    for (std::size_t k = 0; k < kSteps; ++k) {
      const double next = limits.x.ramp(v, speed.target, step);
      speed.way[k] = 0.5 * (v + next) * step;
      v = speed.v[k] = next;
    }
  }
  for (Turn& turn : turns_) {
    double omega = velocity.omega;
    Rotation at = heading;
    for (std::size_t k = 0; k < kSteps; ++k) {
      const double next = limits.theta.ramp(omega, turn.target, step);
      const Rotation half = Rotation::of(0.25 * (omega + next) * step);
      turn.middle[k] = at.turned(half);
      at = turn.heading[k] = turn.middle[k].turned(half);
      omega = next;
    }
    turn.last = omega;
  }
}

}  // namespace hidwa_local_planner
