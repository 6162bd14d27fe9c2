// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <set>
#include <tuple>

#include "ways/body.hpp"

namespace hidwa_ways {

/// When a robot last came to a pose that was new to it: whoever only turns to and fro rests.
class Novelty {
 public:
  void observe(double now, const Pose2& pose) {
    const auto part = [](double value, double size) { return static_cast<int>(std::floor(value / size)); };
    const double heading = std::remainder(pose.theta, 2.0 * M_PI);
    if (seen_.insert({part(pose.x, kPlace), part(pose.y, kPlace), part(heading, kHeading)}).second) since_ = now;
  }
  double since() const { return since_; }  // [s]

 private:
  static constexpr double kPlace = 0.1;           // [m]
  static constexpr double kHeading = M_PI / 9.0;  // [rad]
  std::set<std::tuple<int, int, int>> seen_;
  double since_ = 0.0;
};

}  // namespace hidwa_ways
