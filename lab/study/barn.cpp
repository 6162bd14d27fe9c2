// SPDX-License-Identifier: BSD-3-Clause
#include "experiments.hpp"

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "execution.hpp"
#include "files.hpp"
#include "study/barn_drive.hpp"
#include "study/barn_table.hpp"
#include "study/seed.hpp"
#include "study/worlds.hpp"
#include "subjects.hpp"

namespace hidwa_local_planner {
namespace study {
namespace {

const char* const kJackal = "launch/params/jackal.yaml";
const char* const kBarn = "launch/params/barn.yaml";

}  // namespace

int barn(const Options& options, std::ostream& out, std::ostream& errors) {
  const std::map<int, sim::BarnWorld> worlds = worlds_by_index(sim::load_barn_worlds, options.worlds);
  std::vector<int> indices;
  indices.reserve(worlds.size());
  for (const auto& entry : worlds) indices.push_back(entry.first);
  const Plan plan = make_world_plan("barn", indices, options.modes, settings_of(options));
  const BarnSubject jackal = barn_subject(share_file(kJackal), share_file(kBarn));
  const std::vector<BarnSubject> subjects = drivers_of(options, plan, jackal, assign_barn);
  const auto make = [&](const Run& run) {
    const Seeds seeds = seeds_of(options.seed, run);
    const sim::BarnWorld& world = worlds.at(run.participant);
    drive::DriveResult result = drive_barn(world, subjects[run.setting], run.condition, seeds.world, seeds.person);
    Row row = barn_row(plan, run, seeds.world, result, score_barn(world, result));
    return Made{std::move(row), std::move(result)};
  };
  const nlohmann::json deciding = {
      {"worlds", fingerprint_of_file(options.worlds)},
      {"parameters", fingerprint_of_file(share_file(kJackal)) + " " + fingerprint_of_file(share_file(kBarn))}};
  return execute(options, plan, deciding, make, out, errors);
}

}  // namespace study
}  // namespace hidwa_local_planner
