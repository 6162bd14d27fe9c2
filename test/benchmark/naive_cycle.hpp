// SPDX-License-Identifier: BSD-3-Clause
// A cycle written straight down: what Planner::plan is timed against.
#pragma once

#include <optional>

#include "hidwa_local_planner/core/types.hpp"
#include "support/naive_collision.hpp"
#include "support/scene.hpp"

namespace hidwa_local_planner::test {

struct NaiveChoice {
  Twist2 sample;       // [m/s, rad/s]
  Twist2 command;      // [m/s, rad/s]
  double total = 0.0;  // J
};

/// One candidate at a time, a sine and a cosine a pose, no sharing between candidates, a check left at its first
/// answer; critics and distance grids are the slow twins. For the default profile, a robot that stands free, a person
/// who steers, and a plan on the map; the same choice as the planner's.
std::optional<NaiveChoice> naive_cycle(const Scene& scene, const NaiveBody& body);

}  // namespace hidwa_local_planner::test
