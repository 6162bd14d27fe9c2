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
#include "files.hpp"
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

nlohmann::json what_decides(const Options& o) {
  return {
      {"tracking", to_string(o.tracking)},
      {"motion", o.motion == sim::KeyMotion::linear ? "linear" : "spline"},
      {"speed", o.speed},
      {"worlds", fingerprint_of_file(o.worlds)},
      {"parameters", fingerprint_of_file(share_file(kRobotFile)) + " " + fingerprint_of_file(share_file(kCourtFile))}};
}

}  // namespace

int dynabarn(const Options& options, std::ostream& out, std::ostream& errors) {
  const std::map<int, sim::DynabarnWorld> worlds = worlds_by_index(sim::load_dynabarn_worlds, options.worlds);
  const Plan plan = make_world_plan("dynabarn", numbers_of(worlds, options.seeds), options.modes, settings_of(options));
  const std::vector<DynabarnCourt> courts = courts_of(options, plan);
  const auto make = [&](const Run& run) {
    const Seeds seeds = seeds_of(options.seed, run);
    const sim::DynabarnWorld& world = worlds.at(run.participant / kSeedsOfWorld);
    const double release = release_time(seeds.world);
    drive::DriveResult result = courts[run.setting].drive(world, run.condition, release, seeds.world, seeds.person);
    Row row = encounter_row(plan, run, {std::to_string(world.index), world.difficulty, seeds.world, release}, result);
    return Made{std::move(row), std::move(result)};
  };
  return execute(options, plan, what_decides(options), make, out, errors);
}

}  // namespace study
}  // namespace hidwa_local_planner
