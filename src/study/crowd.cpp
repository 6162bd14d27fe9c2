// SPDX-License-Identifier: BSD-3-Clause
#include "crowd.hpp"

#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "execution.hpp"
#include "manifest.hpp"
#include "share.hpp"
#include "study/crowd_drive.hpp"
#include "study/encounter_table.hpp"
#include "study/error.hpp"
#include "study/seed.hpp"

namespace hidwa_local_planner {
namespace study {
namespace {

std::vector<Subject> subjects_among(const Options& options, const Plan& plan) {
  std::vector<Subject> subjects;
  for (const Setting& setting : plan.settings) {
    Subject subject;
    subject.parameters.cycle_budget = -1.0;  // all samples always: the same on any computer
    for (const Assignment& set : options.sets) assign(subject, set);
    for (const Assignment& set : setting) assign(subject, set);
    check(setting, subject.parameters);
    subjects.push_back(subject);
  }
  return subjects;
}

std::string floor_manifest(const Options& o, const std::string& map, const Scene& scene) {
  const auto pose = [](const sim::Pose& p) { return nlohmann::json{p.x, p.y, p.theta}; };
  const nlohmann::json manifest = {{"version", HIDWA_VERSION},
                                   {"experiment", "crowd"},
                                   {"seed", o.seed},
                                   {"map", fingerprint_of_file(map)},
                                   {"start", pose(scene.start)},
                                   {"goal", pose(scene.goal)},
                                   {"people", o.people},
                                   {"yielding", o.yielding},
                                   {"tracking", to_string(o.tracking)},
                                   {"set", json_of(o.sets)},
                                   {"paths", o.paths}};
  return manifest.dump(2) + '\n';
}

}  // namespace

int crowd(const Options& options, std::ostream& out, std::ostream& errors) {
  const bool office = options.map.empty();
  const std::string map = office ? share_file("maps/office.yaml") : options.map;
  const std::string regions = !options.regions.empty() ? options.regions
                              : office                 ? share_file("maps/office_regions.yaml")
                                                       : "none";
  const Scene scene = load_scene(map, regions, options.start, options.goal);
  std::vector<int> numbers;
  for (int k = 1; k <= options.seeds; ++k) numbers.push_back(k);
  const Plan plan = make_world_plan("crowd", numbers, options.modes, settings_of(options));
  const std::vector<Subject> subjects = subjects_among(options, plan);
  const std::shared_ptr<const sim::FloorWays> ways = ways_of_people(scene, options.seed);
  const Passers passers{options.people, options.yielding, options.tracking};
  const std::string name = std::filesystem::path(map).stem().string();
  const auto make = [&](const Run& run) {
    // The people and the noise are the same in all modes and settings.
    const std::uint64_t seed = seed_for(options.seed, run.participant, "world") % kSeeds;
    const std::uint64_t person = seed_for(options.seed, run.participant, "person " + run.condition);
    drive::DriveResult result = drive_among(scene, ways, subjects[run.setting], passers, run.condition, seed, person);
    const Scenery scenery{name, std::to_string(options.people) + " people", seed, 0.0};
    Row row = encounter_row(plan, run, scenery, result);
    return Made{std::move(row), std::move(result)};
  };
  return execute(options, plan, floor_manifest(options, map, scene), make, out, errors);
}

}  // namespace study
}  // namespace hidwa_local_planner
