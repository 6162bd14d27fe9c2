// SPDX-License-Identifier: BSD-3-Clause
#include "ways/way.hpp"

#include <algorithm>
#include <cmath>

namespace hidwa_ways {

Pose2 after(const Pose2& from, const Move& move, double share) {
  const double length = share * move.length, turn = share * move.turn;
  // The chord of an arc leads to the middle of its turn.
  const double chord = std::abs(turn) > 1e-12 ? length * std::sin(0.5 * turn) / (0.5 * turn) : length;
  const double heading = from.theta + 0.5 * turn;
  return {from.x + chord * std::cos(heading), from.y + chord * std::sin(heading), from.theta + turn};
}

double Way::length() const {
  double sum = 0.0;
  for (const Move& move : moves) sum += std::abs(move.length);
  return sum;
}

double Way::time(const Pace& pace) const {
  double sum = 0.0;
  for (const Move& move : moves) {
    const double speed = move.length < 0.0 ? pace.backward : pace.forward;
    sum += std::max(move.length == 0.0 ? 0.0 : std::abs(move.length) / speed, std::abs(move.turn) / pace.turning);
  }
  return sum;
}

std::vector<Pose2> Way::poses(double step, double angle) const {
  std::vector<Pose2> all{start};
  Pose2 at = start;
  for (const Move& move : moves) {
    const int parts =
        std::max(1, static_cast<int>(std::ceil(std::max(std::abs(move.length) / step, std::abs(move.turn) / angle))));
    for (int k = 1; k <= parts; ++k) all.push_back(after(at, move, static_cast<double>(k) / parts));
    at = all.back();
  }
  return all;
}

double deepest_along(const Way& way, const World& world, const Shape& shape) {
  constexpr double kAround = 0.01;  // [m]
  double most = -kAround;
  for (const Pose2& pose : way.poses(1e-3, 0.1 * M_PI / 180.0))
    most = std::max(most, hidwa_attack::deepest(world, hidwa_attack::Placed(shape, pose), kAround));
  return most;
}

}  // namespace hidwa_ways
