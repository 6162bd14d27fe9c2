// SPDX-License-Identifier: BSD-3-Clause
// What SocialDistance says of one rollout: every mover at every look.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "hidwa_local_planner/core/footprint.hpp"
#include "hidwa_local_planner/core/moving_obstacle.hpp"
#include "hidwa_local_planner/core/parameters.hpp"

namespace hidwa_local_planner::test {

/// From a point in the robot's frame to the side of a convex outline that is farthest in front of it [m]; off a corner
/// less than the distance. Exactly, where the outline is no convex polygon.
inline double distance_to_sides(const Footprint& body, const Point& point) {
  if (body.sides().empty()) return body.distance_to(point);
  double most = -1e9;
  for (const Footprint::Side& side : body.sides()) most = std::max(most, side.normal.dot(point) - side.offset);
  return most;
}

/// [s] `poses`: start pose first, `step` [s] apart. `apart` [s]: about so far apart are the times that are looked at.
inline double naive_social_distance(const std::vector<Pose2>& poses, double step, const Footprint& body,
                                    const MovingObstacleEstimates& movers, const Parameters& p, double apart = 0.25) {
  const auto stride = static_cast<std::size_t>(std::max(1.0, std::round(apart / step)));
  const double lasts = static_cast<double>(stride) * step;
  double sum = 0.0;
  for (std::size_t k = stride; k < poses.size(); k += stride) {
    const double t = static_cast<double>(k) * step;
    double nearness = 0.0;
    for (const MovingObstacleEstimate& mover : movers) {
      const Point at = mover.position + (mover.age + t) * mover.velocity;
      const double dx = at.x() - poses[k].x, dy = at.y() - poses[k].y;
      const double c = std::cos(poses[k].theta), s = std::sin(poses[k].theta);
      const double gap = std::max(0.0, distance_to_sides(body, {c * dx + s * dy, c * dy - s * dx}) - mover.radius);
      nearness = std::max(nearness, 1.0 - gap / p.social_distance);
    }
    sum += lasts * std::exp(-(t - 0.5 * lasts) / p.SocialDistance_fading_time) * nearness;
  }
  return sum;
}

}  // namespace hidwa_local_planner::test
