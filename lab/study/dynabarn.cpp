// SPDX-License-Identifier: BSD-3-Clause
#include "experiments.hpp"

#include <algorithm>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/util/words.hpp"
#include "execution.hpp"
#include "manifest.hpp"
#include "share.hpp"
#include "study/dynabarn_drive.hpp"
#include "study/encounter_table.hpp"
#include "study/seed.hpp"
#include "study/worlds.hpp"
#include "subjects.hpp"

namespace hidwa_local_planner {
namespace study {
namespace {

const char* const kRobotFile = "launch/params/jackal.yaml";
const char* const kCourtFile = "launch/params/dynabarn.yaml";

std::vector<int> numbers_of(const std::map<int, sim::DynabarnWorld>& worlds, int seeds) {
  std::vector<int> numbers;
  for (const auto& entry : worlds) {
    for (int seed = 0; seed < seeds; ++seed) numbers.push_back(entry.first * kSeedsOfWorld + seed);
  }
  return numbers;
}

// No faster backwards than forwards.
void limit_speed(BarnSubject& jackal, double speed) {
  assign_barn(jackal, {"min_vel_x", shortest(std::max(jackal.subject.parameters.min_vel_x, -speed))});
  assign_barn(jackal, {"max_vel_x", shortest(speed)});
}

// One court a setting.
std::vector<DynabarnCourt> courts_of(const Options& options, const Plan& plan) {
  BarnSubject jackal = barn_subject(share_file(kRobotFile), share_file(kCourtFile));
  limit_speed(jackal, options.speed);
  std::vector<DynabarnCourt> courts;
  for (const BarnSubject& subject : drivers_of(options, plan, jackal, assign_barn)) {
    courts.emplace_back(subject, options.tracking, options.motion);
  }
  return courts;
}

std::string court_manifest(const Options& o) {
  const nlohmann::json manifest = {
      {"version", HIDWA_VERSION},
      {"experiment", "dynabarn"},
      {"seed", o.seed},
      {"tracking", to_string(o.tracking)},
      {"motion", o.motion == sim::KeyMotion::linear ? "linear" : "spline"},
      {"speed", o.speed},
      {"set", json_of(o.sets)},
      {"worlds", fingerprint_of_file(o.worlds)},
      {"parameters", fingerprint_of_file(share_file(kRobotFile)) + " " + fingerprint_of_file(share_file(kCourtFile))},
      {"paths", o.paths}};
  return manifest.dump(2) + '\n';
}

}  // namespace

int dynabarn(const Options& options, std::ostream& out, std::ostream& errors) {
  const std::map<int, sim::DynabarnWorld> worlds = worlds_by_index(sim::load_dynabarn_worlds, options.worlds);
  const Plan plan = make_world_plan("dynabarn", numbers_of(worlds, options.seeds), options.modes, settings_of(options));
  const std::vector<DynabarnCourt> courts = courts_of(options, plan);
  const auto make = [&](const Run& run) {
    // The release and the noise are the same in all modes and settings.
    const std::uint64_t seed = seed_for(options.seed, run.participant, "world") % kSeeds;
    const std::uint64_t person = seed_for(options.seed, run.participant, "person " + run.condition);
    const sim::DynabarnWorld& world = worlds.at(run.participant / kSeedsOfWorld);
    const double release = release_time(seed);
    drive::DriveResult result = courts[run.setting].drive(world, run.condition, release, seed, person);
    Row row = encounter_row(plan, run, {std::to_string(world.index), world.difficulty, seed, release}, result);
    return Made{std::move(row), std::move(result)};
  };
  return execute(options, plan, court_manifest(options), make, out, errors);
}

}  // namespace study
}  // namespace hidwa_local_planner
