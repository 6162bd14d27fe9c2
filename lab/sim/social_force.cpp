// SPDX-License-Identifier: BSD-3-Clause
#include "sim/social_force.hpp"

#include <algorithm>
#include <cmath>

namespace hidwa_local_planner {
namespace sim {

Eigen::Vector2d drive_force(const Eigen::Vector2d& velocity, const Eigen::Vector2d& wanted) {
  constexpr double kRelaxation = 0.5;  // [s]
  return (wanted - velocity) / kRelaxation;
}

Eigen::Vector2d repulsion(const Eigen::Vector2d& away, const Eigen::Vector2d& other) {
  constexpr double kStrength = 2.1, kReach = 0.3, kAhead = 2.0;  // [m^2/s^2], [m], [s]
  constexpr double kLeast = 1e-6;                                // [m]
  const Eigen::Vector2d step = other * kAhead, shifted = away - step;
  const double r = std::max(kLeast, away.norm()), s = std::max(kLeast, shifted.norm());
  const double b = 0.5 * std::sqrt(std::max(kLeast * kLeast, (r + s) * (r + s) - step.squaredNorm()));
  // -grad V(b), V = V0 exp(-b / sigma).
  const Eigen::Vector2d slope = (r + s) / (4.0 * b) * (away / r + shifted / s);
  return kStrength / kReach * std::exp(-b / kReach) * slope;
}

Eigen::Vector2d wall_force(double distance, const Eigen::Vector2d& away) {
  constexpr double kStrength = 10.0, kReach = 0.2;  // [m^2/s^2], [m]
  return kStrength / kReach * std::exp(-distance / kReach) * away;
}

double sight(const Eigen::Vector2d& ahead, const Eigen::Vector2d& force) {
  constexpr double kHalfView = 100.0 / 180.0 * M_PI, kUnseen = 0.5;
  const double cosine = std::cos(kHalfView);
  return -ahead.dot(force) >= force.norm() * ahead.norm() * cosine ? 1.0 : kUnseen;
}

}  // namespace sim
}  // namespace hidwa_local_planner
