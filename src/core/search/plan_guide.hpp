// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "core/motion/brake_manoeuvre.hpp"
#include "core/motion/velocity_limits.hpp"
#include "hidwa_local_planner/core/types.hpp"

namespace hidwa_local_planner {

/// How long the robot still has to drive from a pose if it goes back to the plan and along it, at full speed [s]. Of
/// the plan so much counts as the robot may drive meanwhile; where the plan is a window of a longer one, it goes on
/// straight.
///
/// From a pose beside the plan at the distance d it joins the plan 2 m ahead (R), and turns that way first:
///
///   T = (s + sqrt(d^2 + R^2) - R) / v_max + 0.3 min(s, 1) a / omega_max
///
/// with the way s that is left along the plan [m], and the angle a to where it joins, as pi (1 - cos a) / 2.
class PlanGuide {
 public:
  PlanGuide() { points_.reserve(kMost); }
  /// Once a cycle. `plan`: poses from about the robot on; `goal`: the last one of the whole plan; `ahead` [m]: so much
  /// of it counts.
  void prepare(const std::vector<Pose2>& plan, const Pose2& goal, const Pose2& here, const VelocityLimits& limits,
               double ahead);
  /// There is a plan.
  bool any() const { return points_.size() > 1; }
  /// [s]
  double time_left(double x, double y, const Rotation& heading) const;
  /// Of a robot there that goes `way` [m] straight towards the plan's end: what is left then, if it need not turn [s].
  double least_left(double x, double y, double way) const;

 private:
  static constexpr std::size_t kMost = 12;
  struct Station {
    double x = 0.0, y = 0.0;                  // [m]
    double left = 0.0;                        // along the plan [m]
    double forward_x = 1.0, forward_y = 0.0;  // where the plan goes there
  };
  struct Projection {
    double left = 0.0;                  // along the plan, from the nearest place on it [m]
    double way = 0.0;                   // to the plan and along it [m]
    double join_x = 0.0, join_y = 0.0;  // from here to where it joins [m]
  };
  void direct();
  Projection project(double x, double y) const;

  std::vector<Station> points_;
  double inverse_speed_ = 1.0;  // [s/m]
  double turn_weight_ = 0.0;    // [s/m]
  bool ends_ = false;           // at the goal
};

}  // namespace hidwa_local_planner
