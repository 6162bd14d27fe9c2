// SPDX-License-Identifier: BSD-3-Clause
#include "core/search/way.hpp"

#include <algorithm>
#include <cmath>

#include "core/collision/collision.hpp"
#include "core/util/rotation.hpp"

namespace hidwa_local_planner {
namespace {

// A radian counts as this length [m].
constexpr double kRadianLength = 0.4;

// Parts that turn by more are bent [rad].
constexpr double kBent = 0.22;

// Back to a way where it is not known to have room [m/s].
constexpr double kSlowBackSpeed = 0.04;

// Stations of the next seconds count for the room of a way [s].
constexpr double kRoomAhead = 3.0;

double length_between(const Pose2& a, const Pose2& b) {
  return std::hypot(a.x - b.x, a.y - b.y, kRadianLength * wrap_angle(a.theta - b.theta));
}

bool is_bent(const Pose2& a, const Pose2& b) { return std::abs(wrap_angle(b.theta - a.theta)) > kBent; }

}  // namespace

void Way::reverse() { std::reverse(stations_.begin(), stations_.end()); }

Way::Projection Way::project(const Pose2& pose, std::size_t part, double room) const {
  const Station& a = stations_[part];
  const Station& b = stations_[std::min(part + 1, stations_.size() - 1)];
  const double dx = b.pose.x - a.pose.x, dy = b.pose.y - a.pose.y;
  const double dt = kRadianLength * wrap_angle(b.pose.theta - a.pose.theta);
  const double x = pose.x - a.pose.x, y = pose.y - a.pose.y, t = kRadianLength * wrap_angle(pose.theta - a.pose.theta);
  const double length2 = dx * dx + dy * dy + dt * dt;
  const double share = length2 > 0.0 ? std::clamp((x * dx + y * dy + t * dt) / length2, 0.0, 1.0) : 0.0;
  const double ox = x - share * dx, oy = y - share * dy, ot = t - share * dt;
  const double off = std::sqrt(ox * ox + oy * oy + ot * ot), within = std::min(off, room);
  return {part, a.left + share * (b.left - a.left), off, within / kBackSpeed + (off - within) / kSlowBackSpeed};
}

Way::Projection Way::nearest(const Pose2& pose, std::size_t from, std::size_t end, double room) const {
  from = std::min(from, stations_.size() - 1);
  Projection best = project(pose, from, room);
  for (std::size_t part = from + 1; part < end; ++part) {
    const Projection other = project(pose, part, room);
    if (other.remaining() < best.remaining()) best = other;
  }
  return best;
}

double Way::time_until_near(const Pose2& pose, double near) const {
  for (const Station& station : stations_) {
    if (distance(station.pose, pose) <= near) return duration() - station.left;
  }
  return duration();
}

std::size_t Way::end_of_parts(const Pose2& pose, std::size_t from, double ahead, double near) const {
  from = std::min(from, stations_.size() - 1);
  const double until = stations_[from].left - ahead;
  int direction = 0;  // of the last part that drives
  for (std::size_t p = from + 1; direction == 0 && p > 0; --p) direction = direction_of(p - 1);
  std::size_t part = from + 1;
  for (; part + 1 < stations_.size() && stations_[part].left >= until; ++part) {
    const int next = direction_of(part);
    if (direction * next < 0 && length_between(pose, stations_[part].pose) > near) break;
    if (next != 0) direction = next;
  }
  return part;
}

double Way::room_ahead(std::size_t part, const CollisionChecker& collision, double cell) const {
  double room = cell;
  for (std::size_t k = part + 1; k < stations_.size() && room > 0.0; ++k) {
    const Pose2& pose = stations_[k].pose;
    if (stations_[part].left - stations_[k].left > kRoomAhead) break;
    if (collision.clear_around(pose.x, pose.y, cell)) continue;
    room = std::min(room, collision.clearance(pose, Rotation::of(pose.theta), cell));
  }
  return room;
}

int Way::direction_from(std::size_t from) const {
  for (std::size_t part = from; part + 1 < stations_.size(); ++part) {
    if (const int direction = direction_of(part); direction != 0) return direction;
  }
  return 0;
}

int Way::direction_of(std::size_t part) const {
  return part + 1 < stations_.size() ? direction_between(stations_[part].pose, stations_[part + 1].pose) : 0;
}

// 1 forwards, -1 backwards, 0 on the spot.
int Way::direction_between(const Pose2& a, const Pose2& b) {
  const double along = (b.x - a.x) * std::cos(a.theta) + (b.y - a.y) * std::sin(a.theta);
  return std::abs(along) < 1e-6 ? 0 : (along > 0.0 ? 1 : -1);
}

// A part that is bent, with one end that stays, would point elsewhere than the robot faces there, and could not be
// followed.
bool Way::lies_between(const Pose2& before, std::size_t k, bool stayed) const {
  const Pose2& own = stations_[k].pose;
  const int direction = direction_between(before, own);
  if (direction == 0 || direction_of(k) != direction) return false;
  const bool next_stays = direction_of(k + 1) != direction;
  return !(stayed && is_bent(before, own)) && !(next_stays && is_bent(own, stations_[k + 1].pose));
}

Pose2 Way::mean_of(const Pose2& before, const Pose2& own, const Pose2& next) {
  const double turn = wrap_angle(before.theta - own.theta) + wrap_angle(next.theta - own.theta);
  return {0.25 * (before.x + 2.0 * own.x + next.x), 0.25 * (before.y + 2.0 * own.y + next.y),
          wrap_angle(own.theta + 0.25 * turn)};
}

}  // namespace hidwa_local_planner
