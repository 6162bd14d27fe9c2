// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "hidwa_local_planner/core/types.hpp"
#include "world.hpp"

namespace hidwa_attack {

/// How long a robot stood at most although its way was open: nobody steered it, a disc around all of it fits at its
/// place, and all along the next metre of the plan, with half a cell to spare. A way that is open in this sense needs
/// nothing but turning and driving ahead.
class StandWatch {
 public:
  struct State {
    hidwa_local_planner::Pose2 pose;
    hidwa_local_planner::Twist2 velocity;
  };

  /// `radius`: of the disc around the robot's centre that holds it [m].
  StandWatch(const World& world, double radius)
      : world_(world), disc_{{}, radius + 0.5 * world.resolution() + kMargin} {}

  /// Each control cycle. `wants`: autonomy has somewhere to go. `plan`: whole, in the world's frame.
  void observe(int now, const State& state, bool wants, const std::vector<hidwa_local_planner::Pose2>& plan) {
    const bool stands = std::abs(state.velocity.v) < 0.01 && std::abs(state.velocity.omega) < 0.05;
    if (!stands || !wants || !open(state.pose, plan)) {
      since_ = -1;
      return;
    }
    if (since_ < 0) since_ = now;
    longest_ = std::max(longest_, now - since_);
  }
  double longest() const { return 1e-3 * longest_; }  // [s]

 private:
  static constexpr double kMargin = 0.05;  // for the way from the robot to the plan, and what it turns by [m]
  static constexpr double kAhead = 1.0;    // [m]
  static constexpr double kBeside = 0.05;  // of the plan, at most [m]

  bool fits(double x, double y) const { return deepest(world_, Placed(disc_, {x, y, 0.0}), 0.01) < 0.0; }

  bool open(const hidwa_local_planner::Pose2& at, const std::vector<hidwa_local_planner::Pose2>& plan) const {
    const auto away = [&at](const auto& p) { return std::hypot(p.x - at.x, p.y - at.y); };
    const auto nearest =
        std::min_element(plan.begin(), plan.end(), [&away](const auto& a, const auto& b) { return away(a) < away(b); });
    if (nearest == plan.end() || away(*nearest) > kBeside || !fits(at.x, at.y)) return false;
    double way = 0.0;
    for (auto one = nearest; one + 1 != plan.end() && way < kAhead; ++one) {
      way += std::hypot((one + 1)->x - one->x, (one + 1)->y - one->y);
      if (!fits((one + 1)->x, (one + 1)->y)) return false;
    }
    return way >= kAhead;
  }

  const World& world_;
  Shape disc_;
  int since_ = -1, longest_ = 0;  // [ms]
};

}  // namespace hidwa_attack
