// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "benchmark/situations.hpp"
#include "hidwa_local_planner/core/planner.hpp"
#include "hidwa_local_planner/critics/built_in.hpp"

namespace hidwa_local_planner::test {

/// How many candidates, and how long their rollouts are.
struct Load {
  const char* name;  // the nominal number of candidates, and of poses a rollout where that is not the default
  int vx_samples = 20;
  int vth_samples = 20;   // even: an exact 0 is added
  double sim_time = 1.7;  // [s]
};

/// The loads of the cycle cases, few candidates first.
const std::vector<Load>& loads();
/// One of them by name.
const Load& load(const std::string& name);

/// One cycle's surroundings, ready to run.
class CycleCase {
 public:
  CycleCase(const Load& load, const Setting& setting);

  std::size_t size() const { return scenes_.size(); }
  const Scene& scene(std::size_t k) const { return scenes_[k % scenes_.size()]; }
  const Decision& plan(std::size_t k) {
    const Scene& s = scene(k);
    return planner_.plan(s.situation, s.grid(), s.intent, sampling_);
  }
  /// From now on nobody steers.
  void let_drive();
  /// From now on so many people walk around the robot, at places and with velocities that are the same in every run.
  void add_people(std::size_t count);
  /// From now on all candidates are checked.
  void watch() { sampling_.report = Report::legality; }

  struct Size {
    std::size_t candidates = 0;
    std::size_t poses = 0;  // of all rollouts, without their start
  };
  /// Of the first situation's cycle; the others differ by the rollouts of the person's and the last command.
  Size measure();
  /// Part of the candidates that are legal, over all situations.
  double legal_part();

 private:
  std::vector<Scene> scenes_;
  Planner planner_{critics::built_in()};
  Sampling sampling_;
};

}  // namespace hidwa_local_planner::test
