// SPDX-License-Identifier: BSD-3-Clause
#include "experiments.hpp"

#include <exception>
#include <filesystem>
#include <memory>
#include <numeric>
#include <sstream>
#include <string>
#include <vector>

#include "attack/drive.hpp"
#include "attack/floor.hpp"
#include "core/util/words.hpp"
#include "execution.hpp"
#include "files.hpp"
#include "sim/barn_world.hpp"
#include "sim/occupancy_map.hpp"
#include "study/attack_table.hpp"
#include "study/error.hpp"

namespace hidwa_local_planner {
namespace study {
namespace {

using hidwa_attack::Case;
using hidwa_attack::Ground;
using hidwa_attack::World;

std::vector<std::string> maps_of(const Options& options) {
  std::vector<std::string> maps{share_file("maps/office.yaml")};
  std::istringstream text(options.map);
  for (std::string map; std::getline(text, map, ',');) maps.push_back(map);
  return maps;
}

Ground ground_of_map(const std::string& yaml) {
  try {
    auto world = std::make_shared<World>(hidwa_attack::world_of(sim::load_map(yaml)));
    // Many maps are called map.yaml: their folder tells them apart.
    const std::filesystem::path path = std::filesystem::absolute(yaml);
    return {(path.parent_path().filename() / path.stem()).string(), world};
  } catch (const std::exception& e) {
    throw UsageError(e.what());
  }
}

// All fields of a file side by side.
Ground ground_of_fields(const std::string& file) {
  constexpr double kWidth = 6.0, kHeight = 14.0, kResolution = 0.05;  // of a field's place [m]
  constexpr int kAcross = 16;
  std::vector<sim::BarnWorld> fields;
  try {
    fields = sim::load_barn_worlds(file);
  } catch (const std::exception& e) {
    throw UsageError(e.what());
  }
  const int rows = (static_cast<int>(fields.size()) + kAcross - 1) / kAcross;
  auto world = std::make_shared<World>(kAcross * kWidth, rows * kHeight, kResolution);
  for (std::size_t k = 0; k < fields.size(); ++k) {
    const double x = (static_cast<double>(k % kAcross) + 0.9) * kWidth;
    const std::size_t row = k / kAcross;
    const double y = (static_cast<double>(row) + 0.05) * kHeight;
    for (const Eigen::Vector2d& cylinder : fields[k].cylinders) {
      const double left = x + cylinder.x(), bottom = y + cylinder.y(), radius = sim::kBarnCylinder;
      for (int j = world->cell(bottom - radius); j <= world->cell(bottom + radius); ++j) {
        for (int i = world->cell(left - radius); i <= world->cell(left + radius); ++i) {
          const double dx = world->middle(i) - left, dy = world->middle(j) - bottom;
          if (dx * dx + dy * dy <= radius * radius) world->set(i, j, true);
        }
      }
    }
  }
  return {"barn", world};
}

std::vector<Ground> grounds_of(const Options& options) {
  std::vector<Ground> grounds;
  for (const std::string& map : maps_of(options)) grounds.push_back(ground_of_map(map));
  if (!options.worlds.empty()) grounds.push_back(ground_of_fields(options.worlds));
  return grounds;
}

// A drive of an attack: its number is the run's.
Case case_of(const Run& run, const Options& options, const std::vector<Ground>& grounds) {
  const auto number = static_cast<std::uint64_t>(run.participant);
  Case drive = run.condition == kMixed
                   ? hidwa_attack::mixed_case(options.seed, number, grounds)
                   : hidwa_attack::case_of(*hidwa_attack::find_condition(run.condition), options.seed + number);
  drive.spec.seconds = options.seconds;
  return drive;
}

nlohmann::json grounds_and_time(const Options& options) {
  nlohmann::json maps = nlohmann::json::array();
  for (const std::string& map : maps_of(options)) maps.push_back(fingerprint_of_file(map));
  return {{"seconds", options.seconds},
          {"maps", maps},
          {"worlds", options.worlds.empty() ? "" : fingerprint_of_file(options.worlds)}};
}

int tell_conditions(std::ostream& out) {
  for (const hidwa_attack::Condition& c : hidwa_attack::all_conditions()) {
    out << format("%-28s %s%s\n", c.name, c.promised ? "" : "(outside the promise) ", c.what);
  }
  out << format("%-28s all that start free, in turn, in many places, by poor links and among people\n", kMixed);
  return 0;
}

}  // namespace

int attack(const Options& asked, std::ostream& out, std::ostream& errors) {
  if (asked.list) return tell_conditions(out);
  Options options = asked;
  options.paths = false;  // a drive alone leaves a trace, and is driven each time that it is asked for
  options.resume = asked.resume && !asked.drive;
  if (asked.drive) options.shard = options.shards = 1;  // it is the whole of this plan
  std::vector<int> numbers(static_cast<std::size_t>(asked.drive ? 1 : asked.drives));
  std::iota(numbers.begin(), numbers.end(), static_cast<int>(asked.drive.value_or(0)));
  const Plan plan = make_world_plan("attack", numbers, options.conditions, settings_of(options));
  const std::vector<Ground> grounds = grounds_of(options);
  const auto make = [&](const Run& run) {
    const Case drive = case_of(run, options, grounds);
    std::ostringstream trace;
    trace.precision(9);
    const hidwa_attack::DriveResult result =
        hidwa_attack::drive(drive.spec, drive.seed, asked.drive ? &trace : nullptr);
    if (asked.drive) Store(options.out).write("trace.csv", trace.str());
    Made made{attack_row(run, drive, result), {}};
    made.result.duration = result.seconds;
    return made;
  };
  return execute(options, plan, grounds_and_time(options), make, out, errors);
}

}  // namespace study
}  // namespace hidwa_local_planner
