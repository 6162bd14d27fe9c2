// SPDX-License-Identifier: BSD-3-Clause
#include "experiments.hpp"

#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "execution.hpp"
#include "floor.hpp"
#include "manifest.hpp"
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

std::string manifest_of_crowd(const Options& options, const Scene& scene) {
  nlohmann::json manifest = json_of_floor("crowd", options, scene);
  manifest["people"] = options.people;
  manifest["yielding"] = options.yielding;
  manifest["tracking"] = to_string(options.tracking);
  return manifest.dump(2) + '\n';
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
    // The people and the noise are the same in all modes and settings.
    const std::uint64_t seed = seed_for(options.seed, run.participant, "world") % kSeeds;
    const std::uint64_t person = seed_for(options.seed, run.participant, "person " + run.condition);
    drive::DriveResult result = drive_among(scene, ways, subjects[run.setting], passers, run.condition, seed, person);
    const Scenery scenery{name, std::to_string(options.people) + " people", seed, 0.0};
    Row row = encounter_row(plan, run, scenery, result);
    return Made{std::move(row), std::move(result)};
  };
  return execute(options, plan, manifest_of_crowd(options, scene), make, out, errors);
}

}  // namespace study
}  // namespace hidwa_local_planner
