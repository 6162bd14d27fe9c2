// SPDX-License-Identifier: BSD-3-Clause
#include "passage.hpp"

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "execution.hpp"
#include "manifest.hpp"
#include "share.hpp"
#include "study/error.hpp"
#include "study/passage_table.hpp"
#include "study/scene.hpp"
#include "study/seed.hpp"

namespace hidwa_local_planner {
namespace study {
namespace {

// The demo's robot and its parameters.
std::vector<Subject> drivers_of(const Options& options, const Plan& plan) {
  std::vector<Subject> subjects;
  for (const Setting& setting : plan.settings) {
    Subject subject;
    assign_file(subject.parameters, share_file("launch/params/telepresence_base.yaml"));
    subject.parameters.cycle_budget = -1.0;  // all samples always: the same on any computer
    for (const Assignment& set : options.sets) assign(subject, set);
    for (const Assignment& set : setting) assign(subject, set);
    check(setting, subject.parameters);
    subjects.push_back(subject);
  }
  return subjects;
}

std::string manifest_of_passage(const Options& o, const std::string& map, const Scene& scene) {
  const auto pose = [](const sim::Pose& p) { return nlohmann::json{p.x, p.y, p.theta}; };
  const nlohmann::json manifest = {{"version", HIDWA_VERSION},
                                   {"experiment", "passage"},
                                   {"seed", o.seed},
                                   {"map", fingerprint_of_file(map)},
                                   {"start", pose(scene.start)},
                                   {"goal", pose(scene.goal)},
                                   {"set", json_of(o.sets)},
                                   {"paths", o.paths}};
  return manifest.dump(2) + '\n';
}

}  // namespace

int passage(const Options& options, std::ostream& out, std::ostream& errors) {
  const bool office = options.map.empty();
  const std::string map = office ? share_file("maps/office.yaml") : options.map;
  const std::string regions = !options.regions.empty() ? options.regions
                              : office                 ? share_file("maps/office_regions.yaml")
                                                       : "none";
  const Scene scene = load_scene(map, regions, options.start, options.goal);
  std::vector<int> numbers;
  for (int k = 1; k <= options.seeds; ++k) numbers.push_back(k);
  const Plan plan = make_world_plan("passage", numbers, {"AUTONOMY"}, settings_of(options));
  const std::vector<Subject> drivers = drivers_of(options, plan);
  const auto make = [&](const Run& run) {
    // The noise is the same in all settings.
    const std::uint64_t seed = seed_for(options.seed, run.participant, "world") % kSeeds;
    const Subject& driver = drivers[run.setting];
    drive::DriveResult result = drive::drive(drive_setup(scene, driver, seed));
    const Passage seen = passage_of(result, scene.goal, driver.parameters.xy_goal_tolerance);
    Row row = passage_row(plan, run, seed, result, seen);
    return Made{std::move(row), std::move(result)};
  };
  return execute(options, plan, manifest_of_passage(options, map, scene), make, out, errors);
}

}  // namespace study
}  // namespace hidwa_local_planner
