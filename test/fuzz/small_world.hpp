// SPDX-License-Identifier: BSD-3-Clause
// A quiet corridor: what is asked of a target that varies something else.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "control/control_loop.hpp"

namespace hidwa_local_planner::fuzz {

class SmallWorld {
 public:
  static constexpr int kCells = 40;
  static constexpr double kResolution = 0.1;  // [m]

  SmallWorld() : costs_(static_cast<std::size_t>(kCells) * kCells, cost::kFree) {
    for (int i = 0; i < kCells; ++i) {
      costs_[static_cast<std::size_t>(i)] = cost::kLethal;
      costs_[static_cast<std::size_t>((kCells - 1) * kCells + i)] = cost::kLethal;
    }
  }

  GridView view() const { return {costs_.data(), kCells, kCells, kResolution, -2.0, -2.0}; }
  static std::vector<Pose2> plan() {
    std::vector<Pose2> plan;
    for (int k = 0; k < 40; ++k) plan.push_back({-0.5 + 0.05 * k, 0.0, 0.0});
    return plan;
  }
  static Polygon outline() { return {{0.2, 0.2}, {-0.2, 0.2}, {-0.2, -0.2}, {0.2, -0.2}}; }
  /// Nothing is wrong, and the robot does what it was told last.
  control::Observation observe(double now, double period, const Twist2& velocity) const {
    control::Observation seen;
    seen.timing = {now, period, period, period, false};
    seen.velocity = velocity;
    seen.costmap = view();
    return seen;
  }

 private:
  std::vector<std::uint8_t> costs_;
};

}  // namespace hidwa_local_planner::fuzz
