// SPDX-License-Identifier: BSD-3-Clause
#include "experiments.hpp"

#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "execution.hpp"
#include "floor.hpp"
#include "study/crowd_drive.hpp"
#include "study/encounter_table.hpp"
#include "study/seed.hpp"
#include "subjects.hpp"

namespace hidwa_local_planner {
namespace study {
namespace {

Subject usual_robot() {
  Subject subject;
  subject.parameters.cycle_budget = -1.0;  // all samples always: the same on any computer
  return subject;
}

}  // namespace

int crowd(const Options& asked, std::ostream& out, std::ostream& errors) {
  const Options options = with_floor(asked);
  const Scene scene = scene_of(options);
  std::vector<int> numbers;
  for (int k = 1; k <= options.seeds; ++k) numbers.push_back(k);
  const Plan plan = make_world_plan("crowd", numbers, options.modes, settings_of(options));
  const std::vector<Subject> subjects = drivers_of(options, plan, usual_robot(), assign);
  const std::shared_ptr<const sim::FloorWays> ways = ways_of_people(scene, options.seed);
  const Passers passers{options.people, options.yielding, options.tracking};
  const std::string name = std::filesystem::path(options.map).stem().string();
  const auto make = [&](const Run& run) {
    const Seeds seeds = seeds_of(options.seed, run);
    drive::DriveResult result =
        drive_among(scene, ways, subjects[run.setting], passers, run.condition, seeds.world, seeds.person);
    const Scenery scenery{name, std::to_string(options.people) + " people", seeds.world, 0.0};
    Row row = encounter_row(plan, run, scenery, result);
    return Made{std::move(row), std::move(result)};
  };
  nlohmann::json deciding = json_of_floor(options, scene);
  deciding["people"] = options.people;
  deciding["yielding"] = options.yielding;
  deciding["tracking"] = to_string(options.tracking);
  return execute(options, plan, deciding, make, out, errors);
}

}  // namespace study
}  // namespace hidwa_local_planner
