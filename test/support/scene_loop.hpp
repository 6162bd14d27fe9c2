// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "control/control_loop.hpp"
#include "hidwa_local_planner/critics/built_in.hpp"
#include "support/scene.hpp"

namespace hidwa_local_planner::test {

/// The control loop of a robot in a scene. Pose, velocity, time, periods and the operator's intent are the scene's at
/// each cycle; its plan and, behind that, its goal are what the host plans. The last command is the loop's own.
class SceneLoop {
 public:
  /// `scene` must outlive it.
  explicit SceneLoop(const Scene& scene) : scene_(scene), loop_(critics::built_in()) {
    EXPECT_EQ(loop_.configure(scene.parameters), std::vector<std::string>{});
    loop_.set_footprint(scene.outline);
    plan();
  }

  /// The host plans anew.
  void plan() {
    std::vector<Pose2> plan = scene_.situation.plan;
    const Pose2& goal = scene_.situation.goal;
    if (plan.empty() || distance(plan.back(), goal) > 1e-6) plan.push_back(goal);
    loop_.set_plan(std::move(plan), "map", scene_.situation.time, scene_.situation.period);
  }

  bool doubts_velocity() const { return loop_.doubts_velocity(); }

  /// One control cycle, in which nothing is missing; `host_stops`: the host stops the robot.
  control::Result cycle(bool host_stops = false) {
    const Situation& now = scene_.situation;
    control::Observation seen;
    seen.timing = {now.time, now.period, now.longest_period, now.period, false};
    seen.pose = now.pose;
    seen.velocity = now.velocity;
    seen.pose_age = now.pose_age;
    seen.costmap = scene_.grid();
    seen.host_stops = host_stops;
    return loop_.step(seen, scene_.intent);
  }

 private:
  const Scene& scene_;
  control::ControlLoop loop_;
};

}  // namespace hidwa_local_planner::test
