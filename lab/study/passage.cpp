// SPDX-License-Identifier: BSD-3-Clause
#include "experiments.hpp"

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "execution.hpp"
#include "files.hpp"
#include "floor.hpp"
#include "study/passage_table.hpp"
#include "study/scene.hpp"
#include "study/seed.hpp"
#include "subjects.hpp"

namespace hidwa_local_planner {
namespace study {
namespace {

// The demo's robot and its parameters.
Subject demo_robot() {
  Subject subject;
  assign_file(subject.parameters, share_file("launch/params/telepresence_base.yaml"));
  subject.parameters.cycle_budget = -1.0;  // all samples always: the same on any computer
  return subject;
}

}  // namespace

int passage(const Options& asked, std::ostream& out, std::ostream& errors) {
  const Options options = with_floor(asked);
  const Scene scene = scene_of(options);
  std::vector<int> numbers;
  for (int k = 1; k <= options.seeds; ++k) numbers.push_back(k);
  const Plan plan = make_world_plan("passage", numbers, {"AUTONOMY"}, settings_of(options));
  const std::vector<Subject> drivers = drivers_of(options, plan, demo_robot(), assign);
  const auto make = [&](const Run& run) {
    const std::uint64_t seed = seeds_of(options.seed, run).world;
    const Subject& driver = drivers[run.setting];
    drive::DriveResult result = drive::drive(drive_setup(scene, driver, seed));
    const Passage seen = passage_of(result, scene.goal, driver.parameters.xy_goal_tolerance);
    Row row = passage_row(plan, run, seed, result, seen);
    return Made{std::move(row), std::move(result)};
  };
  return execute(options, plan, json_of_floor(options, scene), make, out, errors);
}

}  // namespace study
}  // namespace hidwa_local_planner
