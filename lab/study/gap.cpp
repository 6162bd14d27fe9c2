// SPDX-License-Identifier: BSD-3-Clause
#include "experiments.hpp"

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "execution.hpp"
#include "study/gap_drive.hpp"
#include "study/gap_table.hpp"
#include "study/seed.hpp"
#include "subjects.hpp"

namespace hidwa_local_planner {
namespace study {
namespace {

// Cells and noise as they usually are, unless others are asked for.
std::vector<Setting> settings_of_gaps(const Options& options) {
  if (!options.grid.empty() || !options.vary.empty()) return settings_of(options);
  return combinations({"costmap.resolution=0.025,0.05,0.1", "laser.noise=0,0.01,0.03"});
}

GapSubject robot_at_gaps() {
  GapSubject subject;
  subject.subject.parameters.cycle_budget = -1.0;  // all samples always: the same on any computer
  return subject;
}

}  // namespace

int gap(const Options& options, std::ostream& out, std::ostream& errors) {
  std::vector<int> phases;
  for (int k = 1; k <= options.phases; ++k) phases.push_back(k);
  const Plan plan = make_world_plan("gap", phases, options.outlines, settings_of_gaps(options));
  const std::vector<GapSubject> subjects = drivers_of(options, plan, robot_at_gaps(), assign_gap);
  const auto make = [&](const Run& run) {
    const double phase = static_cast<double>(run.participant - 1) / options.phases;
    const GapSubject& subject = subjects[run.setting];
    Narrowest narrowest = narrowest_gap(subject, run.condition, phase, seeds_of(options.seed, run).world);
    Row row = gap_row(plan, run, phase, subject, narrowest);
    return Made{std::move(row), std::move(narrowest.result)};
  };
  return execute(options, plan, {{"phases", options.phases}}, make, out, errors);
}

}  // namespace study
}  // namespace hidwa_local_planner
