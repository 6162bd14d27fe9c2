// SPDX-License-Identifier: BSD-3-Clause
#include "core/search/way.hpp"

#include <algorithm>
#include <cmath>

namespace hidwa_local_planner {
namespace {

// So long is a radian [m].
constexpr double kRadianLength = 0.4;

// The speed at which a robot gets back to its way [m/s]: low, so that it keeps to it.
constexpr double kBackSpeed = 0.1;

}  // namespace

double Way::Place::remaining() const { return left + off / kBackSpeed; }

void Way::reverse() { std::reverse(stations_.begin(), stations_.end()); }

Way::Place Way::place_on(const Pose2& pose, std::size_t part) const {
  const Station& a = stations_[part];
  const Station& b = stations_[std::min(part + 1, stations_.size() - 1)];
  const double dx = b.pose.x - a.pose.x, dy = b.pose.y - a.pose.y;
  const double dt = kRadianLength * wrap_angle(b.pose.theta - a.pose.theta);
  const double x = pose.x - a.pose.x, y = pose.y - a.pose.y, t = kRadianLength * wrap_angle(pose.theta - a.pose.theta);
  const double length2 = dx * dx + dy * dy + dt * dt;
  const double share = length2 > 0.0 ? std::clamp((x * dx + y * dy + t * dt) / length2, 0.0, 1.0) : 0.0;
  const double ox = x - share * dx, oy = y - share * dy, ot = t - share * dt;
  return {part, a.left + share * (b.left - a.left), std::sqrt(ox * ox + oy * oy + ot * ot)};
}

Way::Place Way::nearest(const Pose2& pose, std::size_t from, double ahead) const {
  from = std::min(from, stations_.size() - 1);
  const double until = stations_[from].left - ahead;
  Place best = place_on(pose, from);
  for (std::size_t part = from + 1; part + 1 < stations_.size() && stations_[part].left >= until; ++part) {
    const Place place = place_on(pose, part);
    if (place.remaining() < best.remaining()) best = place;
  }
  return best;
}

}  // namespace hidwa_local_planner
