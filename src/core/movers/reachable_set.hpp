// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "hidwa_local_planner/core/moving_obstacle.hpp"
#include "hidwa_local_planner/core/parameters.hpp"
#include "hidwa_local_planner/core/types.hpp"

namespace hidwa_local_planner {

/// Where a moving obstacle may be at a time t of a cycle [s], costmap frame. With tau = t + the estimate's age it is in
/// both of two discs: what its acceleration allows, around where its velocity leads it; and what its speed allows,
/// around where it was.
///
///   |x - (p + w tau)| <= r + k s_p + k s_v tau + a tau^2 / 2
///   |x - p|           <= r + k s_p + s tau                      with s = max(moving_obstacle_speed, |w| + k s_v)
///
/// with k = moving_obstacle_deviations.
class ReachableSet {
 public:
  ReachableSet() = default;
  ReachableSet(const MovingObstacleEstimate& mover, const Parameters& parameters)
      : position_(mover.position),
        velocity_(mover.velocity),
        age_(mover.age),
        base_(mover.radius + parameters.moving_obstacle_deviations * mover.position_deviation),
        spread_(parameters.moving_obstacle_deviations * mover.velocity_deviation),
        half_acc_(0.5 * parameters.moving_obstacle_acc),
        fastest_(std::max(parameters.moving_obstacle_speed, mover.velocity.norm() + spread_)) {}

  /// Of somebody who was anywhere in a disc [m] `age` ago [s], and is no faster than `speed` [m/s].
  static ReachableSet of_hidden(const Point& place, double radius, double speed, double age) {
    ReachableSet set;
    set.position_ = place;
    set.age_ = age;
    set.base_ = radius;
    set.spread_ = set.fastest_ = speed;
    return set;
  }

  /// Where it was estimated.
  const Point& position() const { return position_; }
  const Point& velocity() const { return velocity_; }
  /// No point of the set gets outwards faster [m/s].
  double fastest() const { return fastest_; }
  /// Of the disc that acceleration allows.
  Point centre(double t) const { return position_ + (t + age_) * velocity_; }
  double radius(double t) const {
    const double tau = t + age_;
    return base_ + (spread_ + half_acc_ * tau) * tau;
  }
  /// How fast that radius grows [m/s].
  double growth(double t) const { return spread_ + 2.0 * half_acc_ * (t + age_); }
  /// Of the disc that speed allows, around position().
  double speed_radius(double t) const { return base_ + fastest_ * (t + age_); }
  /// Both discs of now cover the whole square around `middle` whose sides are `half` [m] away from it.
  bool covers(const Point& middle, double half) const {
    const auto farthest = [&](const Point& from) {
      return std::hypot(std::abs(middle.x() - from.x()) + half, std::abs(middle.y() - from.y()) + half);
    };
    return farthest(centre(0.0)) <= radius(0.0) && farthest(position_) <= speed_radius(0.0);
  }

 private:
  Point position_{0.0, 0.0}, velocity_{0.0, 0.0};  // [m], [m/s]
  double age_ = 0.0;                               // [s]
  double base_ = 0.0;                              // of the least disc that holds it at the estimate [m]
  double spread_ = 0.0;                            // [m/s]
  double half_acc_ = 0.0;                          // [m/s^2]
  double fastest_ = 0.0;                           // [m/s]
};

}  // namespace hidwa_local_planner
