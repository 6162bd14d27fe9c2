// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "hidwa_local_planner/core/planner.hpp"

namespace hidwa_local_planner::test {

/// The paper's profile (launch/params/paper.yaml) as a value.
inline Parameters paper_parameters() {
  Parameters p;
  p.max_vel_x = 0.26;
  p.trans_stopped_velocity = 0.25;
  p.rot_stopped_velocity = 0.25;
  p.generator = Generator::standard;
  p.method = Method::paper;
  p.angular_granularity = 0.025;
  p.sim_time = 1.7;
  p.PathAlign_scale = p.PathDist_scale = 32.0;
  p.vx_samples = 20;
  p.vth_samples = 20;
  p.comfort_acc_lim_theta = 0.0;
  p.admissibility = Admissibility::horizon;
  p.forward_prune_distance = 1.0;
  return p;
}

/// An empty map of 61 x 61 cells of 0.05 m with the robot at the centre of the middle cell, heading +x, driving at
/// v_max on a straight plan from 1.0 m behind to 1.0 m ahead; the goal is 8 m ahead. At 1.0 m/s the rollouts end 1.7 m
/// ahead, beyond the 1.525 m of that map: 101 cells then, which changes no distance.
struct PaperScene {
  std::vector<std::uint8_t> costs;
  GridView grid;
  Situation situation;
  Polygon outline{{0.2, 0.2}, {-0.2, 0.2}, {-0.2, -0.2}, {0.2, -0.2}};

  explicit PaperScene(double v_max) {
    const int cells = v_max > 0.8 ? 101 : 61;
    costs.assign(static_cast<std::size_t>(cells * cells), cost::kFree);
    grid = {costs.data(), cells, cells, 0.05, -cells * 0.025, -cells * 0.025};
    situation.velocity = situation.last_command = {v_max, 0.0};
    for (int i = -20; i <= 20; ++i) situation.plan.push_back({0.05 * i, 0.0, 0.0});
    situation.goal = {8.0, 0.0, 0.0};
  }
};

}  // namespace hidwa_local_planner::test
