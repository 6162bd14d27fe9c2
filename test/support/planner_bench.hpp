// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "hidwa_local_planner/critics/built_in.hpp"
#include "support/scene.hpp"

namespace hidwa_local_planner::test {

/// A planner in a scene that it can drive through: commands are carried out perfectly, without latency, and
/// reached evenly within the period.
class PlannerBench {
 public:
  explicit PlannerBench(Scene scene, CriticRegistry registry = critics::built_in())
      : scene_(std::move(scene)), planner_(std::move(registry)) {
    EXPECT_EQ(planner_.configure(scene_.parameters), std::vector<std::string>{});
    planner_.set_footprint(scene_.outline);
  }
  Scene& scene() { return scene_; }
  Planner& planner() { return planner_; }

  const Decision& cycle() { return planner_.plan(scene_.situation, scene_.grid(), scene_.intent); }

  /// One cycle, carried out.
  const Decision& drive() {
    const Decision& decision = cycle();
    Situation& s = scene_.situation;
    const Twist2 u = decision.outcome == Outcome::fail ? Twist2{} : decision.command;
    constexpr int kSteps = 50;
    const double dt = s.period / kSteps;
    for (int k = 0; k < kSteps; ++k) {
      const double part = (k + 0.5) / kSteps;
      const double v = s.velocity.v + part * (u.v - s.velocity.v);
      const double omega = s.velocity.omega + part * (u.omega - s.velocity.omega);
      s.pose.x += v * std::cos(s.pose.theta + 0.5 * omega * dt) * dt;
      s.pose.y += v * std::sin(s.pose.theta + 0.5 * omega * dt) * dt;
      s.pose.theta += omega * dt;
    }
    s.velocity = s.last_command = u;
    s.time += s.period;
    return decision;
  }

 private:
  Scene scene_;
  Planner planner_{critics::built_in()};
};

inline std::size_t rejections_by(const Decision& decision, const std::string& name) {
  for (const RejectionCount& rejection : decision.rejections) {
    if (rejection.name == name) return rejection.count;
  }
  return 0;
}

}  // namespace hidwa_local_planner::test
