// SPDX-License-Identifier: BSD-3-Clause
#include "core/planner/way_room.hpp"

#include <algorithm>
#include <cmath>

namespace hidwa_local_planner {
namespace {

// Stations that come up to so much later count [s].
constexpr double kRoomAhead = 3.0;

// So gently it slows down before a narrow place [m/s^2].
constexpr double kSlowsDown = 0.4;

}  // namespace

WayRoom WayRoom::look(const Way& way, std::size_t part, const CollisionChecker& collision, double cell, double here,
                      double creeping, double full) {
  const std::vector<Way::Station>& stations = way.stations();
  const auto speed = [&](double clearance) {
    return creeping + (full - creeping) * std::min(std::max(clearance, 0.0) / cell, 1.0);
  };
  WayRoom room{cell, speed(here)};
  double gone = 0.0;
  for (std::size_t k = part + 1; k < stations.size(); ++k) {
    if (stations[part].left - stations[k].left > kRoomAhead) break;
    const Pose2& pose = stations[k].pose;
    gone += k > part + 1 ? distance(stations[k - 1].pose, pose) : 0.0;
    if (collision.clear_around(pose.x, pose.y, cell)) continue;
    const double clearance = collision.clearance(pose, Rotation::of(pose.theta), cell);
    room.least = std::min(room.least, clearance);
    room.fastest = std::min(room.fastest, std::sqrt(std::pow(speed(clearance), 2) + 2.0 * kSlowsDown * gone));
  }
  return room;
}

}  // namespace hidwa_local_planner
