// SPDX-License-Identifier: BSD-3-Clause
#include "core/autonomy/way_room.hpp"

#include <algorithm>
#include <vector>

#include "core/util/rotation.hpp"

namespace hidwa_local_planner {
namespace {

// Stations of the next seconds count [s].
constexpr double kRoomAhead = 3.0;

}  // namespace

double room_ahead(const Way& way, std::size_t part, const CollisionChecker& collision, double cell) {
  const std::vector<Way::Station>& stations = way.stations();
  double room = cell;
  for (std::size_t k = part + 1; k < stations.size() && room > 0.0; ++k) {
    const Pose2& pose = stations[k].pose;
    if (stations[part].left - stations[k].left > kRoomAhead) break;
    if (collision.clear_around(pose.x, pose.y, cell)) continue;
    room = std::min(room, collision.clearance(pose, Rotation::of(pose.theta), cell));
  }
  return room;
}

}  // namespace hidwa_local_planner
