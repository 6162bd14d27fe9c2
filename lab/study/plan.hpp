// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "study/setting.hpp"

namespace hidwa_local_planner {
namespace study {

/// One drive of an experiment.
struct Run {
  std::string id;  // experiment, participant, condition and setting
  int participant = 1;
  std::string condition;    // SJ, SG or SW
  int order = 1;            // which of the participant's drives it is
  std::size_t setting = 0;  // index
};

/// The drives of an experiment, whose they are and in which order.
struct Plan {
  std::string experiment;  // run, pilot, sweep, barn, dynabarn, crowd, passage, gap or attack
  std::vector<Setting> settings;
  std::vector<Run> runs;  // by id
};

/// Each participant drives in every condition with every setting. SJ and SW take turns in coming first from
/// participant to participant, SG is last (Kalliokoski 2022, section IV-C). The settings come in the order
/// given; with `balanced` in that of a Williams design: each comes at each place equally often, and after
/// each other one equally often, where their number is even and participants are a multiple of it.
Plan make_plan(const std::string& experiment, int participants, const std::vector<std::string>& conditions,
               const std::vector<Setting>& settings, bool balanced);

/// BARN-2D and its like: each of these worlds in every mode with every setting. A run's participant is its world's
/// number, its condition the mode.
Plan make_world_plan(const std::string& experiment, const std::vector<int>& worlds,
                     const std::vector<std::string>& modes, const std::vector<Setting>& settings);

/// The paper's pilot: four combinations of s_v, s_omega and delta (section IV-A).
std::vector<Setting> pilot_settings();

/// Part `k` of `n`, k from 1: every n-th run.
std::vector<Run> shard(const std::vector<Run>& runs, std::size_t k, std::size_t n);

/// The plan as CSV: one line a run.
std::string to_csv(const Plan& plan);

/// Reads what to_csv() wrote. Throws std::invalid_argument where it is something else.
Plan plan_from_csv(const std::string& csv);

}  // namespace study
}  // namespace hidwa_local_planner
