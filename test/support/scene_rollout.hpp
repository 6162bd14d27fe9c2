// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "core/motion/rollout.hpp"
#include "core/motion/samples.hpp"
#include "support/scene.hpp"

namespace hidwa_local_planner::test {

/// The candidates of a scene, rolled out from its pose and last command.
struct SceneRollout {
  explicit SceneRollout(const Scene& scene)
      : footprint(Footprint::from_outline(scene.outline, scene.parameters.footprint_padding)), grid(scene.grid()) {
    const Situation& s = scene.situation;
    start.pose = start.origin = s.pose;
    start.reference = s.last_command;
    start.limits = VelocityLimits::from(scene.parameters);
    start.period = start.longest_period = s.period;
    SampleRequest request;
    request.previous = s.last_command;
    request.vx_samples = scene.parameters.vx_samples;
    request.vth_samples = scene.parameters.vth_samples;
    sampler.make(scene.parameters, start.limits, start, request);
    rollout.run(scene.parameters, start, sampler.samples(), {}, scene.parameters.sim_time);
    reach = std::max(std::abs(s.last_command.v), rollout.fastest()) * scene.parameters.sim_time;
  }
  CycleStart start;
  Footprint footprint;
  GridView grid;
  Sampler sampler;
  Rollout rollout;
  double reach = 0.0;  // [m]
};

}  // namespace hidwa_local_planner::test
