// SPDX-License-Identifier: BSD-3-Clause
#include "experiments.hpp"

#include <cmath>
#include <exception>
#include <filesystem>
#include <fstream>
#include <memory>
#include <mutex>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "attack/drive.hpp"
#include "attack/floor.hpp"
#include "attack/hostile.hpp"
#include "files.hpp"
#include "hostile_folder.hpp"
#include "progress.hpp"
#include "sim/barn_world.hpp"
#include "sim/occupancy_map.hpp"
#include "study/error.hpp"
#include "study/runner.hpp"

namespace hidwa_local_planner {
namespace study {
namespace {

using hidwa_attack::DriveResult;
using hidwa_attack::Ground;
using hidwa_attack::HostileDrive;
using hidwa_attack::World;

// Nominal cycles for each that is asked for: late cycles leave fewer, and contacts end a drive.
constexpr double kMargin = 1.1;

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

std::string manifest(const Options& options) {
  nlohmann::json maps = nlohmann::json::array();
  for (const std::string& map : maps_of(options)) maps.push_back(fingerprint_of_file(map));
  const nlohmann::json manifest = {{"version", HIDWA_VERSION},
                                   {"seed", options.seed},
                                   {"cycles", options.cycles},
                                   {"maps", maps},
                                   {"worlds", options.worlds.empty() ? "" : fingerprint_of_file(options.worlds)}};
  return manifest.dump(2) + '\n';
}

// The indices of all drives of the study, as many as it takes.
std::uint64_t drives_for(const Options& options, const std::vector<Ground>& grounds) {
  std::uint64_t index = 0;
  for (double cycles = 0.0; cycles < kMargin * static_cast<double>(options.cycles); ++index) {
    const HostileDrive drive = hidwa_attack::hostile_drive(options.seed, index, grounds);
    if (drive.promised) cycles += drive.nominal_cycles();
  }
  return index;
}

// Tells what a study came to; returns the program's exit code.
int conclude(const nlohmann::json& all, const std::string& folder, std::ostream& out) {
  const nlohmann::json& s = all.at("within");
  out << s.at("cycles").get<long long>() << " cycles in " << s.at("drives").get<long long>()
      << " drives within the promise: "
      << "moving " << std::lround(100.0 * s.at("moving").get<double>()) << " %, threatened "
      << std::lround(100.0 * s.at("threatened").get<double>()) << " %; contacts " << s.at("contacts") << " (worst "
      << s.at("worst_depth_mm") << " mm), commands beyond " << s.at("commands_beyond_limits") << "; "
      << s.at("encounters") << " encounters, touched while moving " << s.at("touched_moving") << ", while leaving "
      << s.at("touched_leaving") << '\n';
  for (const auto& [name, sum] : all.at("outside").items()) {
    out << "outside, " << name << ": " << sum.at("contacts") << " of " << sum.at("drives")
        << " drives touched something, " << sum.at("touched_moving") << " of " << sum.at("encounters") << " people\n";
  }
  for (const auto& index : s.at("found")) out << "found: --drive " << index << '\n';
  out << folder << "/summary.json" << std::endl;
  return all.at("held").get<bool>() ? 0 : 1;
}

int drive_alone(const Options& options, const std::vector<Ground>& grounds, std::ostream& out) {
  const auto index = static_cast<std::uint64_t>(*options.drive);
  const HostileDrive drive = hidwa_attack::hostile_drive(options.seed, index, grounds);
  std::filesystem::create_directories(options.out);
  const std::string file = options.out + "/drive_" + std::to_string(index) + ".csv";
  std::ofstream trace(file);
  trace.precision(9);
  const DriveResult result = hidwa_attack::drive(drive.spec, drive.seed, &trace);
  if (!trace.flush()) throw std::runtime_error("'" + file + "' cannot be written");
  out << hostile_head() << '\n' << hostile_line(index, drive, result) << '\n' << file << std::endl;
  return 0;
}

}  // namespace

int hostile(const Options& options, std::ostream& out, std::ostream& errors) {
  const std::vector<Ground> grounds = grounds_of(options);
  if (options.drive) return drive_alone(options, grounds, out);
  HostileFolder folder(options.out, manifest(options));
  std::vector<std::uint64_t> wanted;
  const std::uint64_t all = drives_for(options, grounds);
  for (std::uint64_t index = options.shard - 1; index < all; index += options.shards) {
    if (folder.lines().count(index) == 0) wanted.push_back(index);
  }
  std::mutex mutex;
  Progress progress(errors, wanted.size());
  const auto make_and_keep = [&](std::size_t number) {
    const std::uint64_t index = wanted[number];
    const HostileDrive drive = hidwa_attack::hostile_drive(options.seed, index, grounds);
    const DriveResult result = hidwa_attack::drive(drive.spec, drive.seed);
    const std::lock_guard<std::mutex> lock(mutex);
    folder.keep(index, hostile_line(index, drive, result));
  };
  make_runs(wanted.size(), threads_for(options.threads), make_and_keep, [&progress] { progress.step(); });
  return conclude(folder.finish(), options.out, out);
}

bool are_hostile(const std::vector<std::string>& parts) {
  return !parts.empty() && std::filesystem::exists(parts.front() + "/hostile.json");
}

int merge_hostile(const Options& options, std::ostream& out) {
  std::vector<HostileFolder> parts;
  for (const std::string& part : options.parts) parts.emplace_back(part);
  for (const HostileFolder& part : parts) {
    if (part.manifest() != parts.front().manifest())
      throw UsageError("the parts are of different studies: their hostile.json differ");
  }
  HostileFolder all(options.out, parts.front().manifest());
  for (const HostileFolder& part : parts) {
    for (const auto& [index, line] : part.lines()) {
      const auto there = all.lines().find(index);
      if (there != all.lines().end() && there->second != line) {
        throw UsageError("drive " + std::to_string(index) + " differs between the parts: different versions made them");
      }
      if (there == all.lines().end()) all.keep(index, line);
    }
  }
  return conclude(all.finish(), options.out, out);
}

}  // namespace study
}  // namespace hidwa_local_planner
