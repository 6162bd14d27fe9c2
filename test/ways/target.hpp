// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "ways/body.hpp"

namespace hidwa_ways {

/// The stretch of a plan that a way must come to.
class Target {
 public:
  /// From the plan's start on. A shorter plan has its goal for a target.
  Target(const std::vector<Pose2>& plan, double from, double to);
  /// Whether a place is within `tolerance` [m] of it.
  bool near(double x, double y, double tolerance) const { return squared(x, y) <= tolerance * tolerance; }
  double distance(double x, double y) const;  // [m]

 private:
  double squared(double x, double y) const;

  std::vector<Spot> points_;  // as dense as the plan's
};

}  // namespace hidwa_ways
