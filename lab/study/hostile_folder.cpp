// SPDX-License-Identifier: BSD-3-Clause
#include "hostile_folder.hpp"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <utility>
#include <vector>

#include "core/util/words.hpp"
#include "files.hpp"
#include "study/error.hpp"
#include "study/groups.hpp"
#include "study/store.hpp"

namespace hidwa_local_planner {
namespace study {
namespace {

const char* const kManifest = "hostile.json";
const char* const kDrives = "drives.csv";
constexpr double kTouch = 0.1;  // deeper than this counts [mm]

const std::vector<std::string> kColumns{
    "index",  "condition",      "promised",        "place",          "outline",  "link",
    "seed",   "cycles",         "moving",          "threatened",     "depth_mm", "touched_at_s",
    "beyond", "beyond_v",       "beyond_omega",    "hard",           "stood_s",  "walkers",
    "met",    "touched_moving", "touched_leaving", "touched_at_rest"};

double figure(const Row& drive, const char* column) { return value(drive, column, kColumns); }

std::uint64_t index_of(const Row& drive) { return std::strtoull(drive.front().c_str(), nullptr, 10); }

bool is_found(const Row& drive) {
  return figure(drive, "depth_mm") > kTouch || figure(drive, "beyond") > 0.0 || figure(drive, "hard") > 0.0 ||
         figure(drive, "touched_moving") > 0.0;
}

// What is counted over drives.
nlohmann::json json_of(const Group& drives) {
  std::vector<std::uint64_t> found;
  double stood = 0.0;  // [s]
  std::string longest;
  for (const Row& drive : drives.rows) {
    if (is_found(drive)) found.push_back(index_of(drive));
    if (figure(drive, "stood_s") <= stood) continue;
    stood = figure(drive, "stood_s");
    longest = drive.front();
  }
  const double cycles = std::max(1.0, drives.sum("cycles"));
  return {{"drives", drives.rows.size()},
          {"cycles", drives.count("cycles")},
          {"moving", drives.sum("moving") / cycles},
          {"threatened", drives.sum("threatened") / cycles},
          {"contacts", drives.above("depth_mm", kTouch)},
          {"worst_depth_mm", statistics(drives.values("depth_mm")).max},
          {"commands_beyond_limits", drives.count("beyond")},
          {"commands_beyond_accelerations", drives.count("hard")},
          {"longest_stand_with_a_way_open_s", stood},
          {"longest_stand_drive", longest},
          {"encounters", drives.count("met")},
          {"touched_moving", drives.count("touched_moving")},
          {"touched_leaving", drives.count("touched_leaving")},
          {"touched_at_rest", drives.count("touched_at_rest")},
          {"found", found}};
}

nlohmann::json by_condition(const Group& drives) {
  std::map<std::string, Group> groups;
  for (const Row& drive : drives.rows) {
    Group& group = groups[cell(drive, "condition", kColumns)];
    group.columns = &kColumns;
    group.rows.push_back(drive);
  }
  nlohmann::json all = nlohmann::json::object();
  for (const auto& [condition, group] : groups) all[condition] = json_of(group);
  return all;
}

}  // namespace

HostileFolder::HostileFolder(std::string folder, const std::string& manifest)
    : folder_(std::move(folder)), manifest_(manifest) {
  std::error_code error;
  std::filesystem::create_directories(folder_, error);
  if (error) throw std::runtime_error("'" + folder_.string() + "' cannot be made: " + error.message());
  const std::string present = read_file(folder_ / kManifest).value_or("");
  if (!present.empty() && present != manifest_) {
    throw UsageError("'" + folder_.string() +
                     "' holds another study (its hostile.json differs): give another --out, or remove it");
  }
  Store(folder_).write(kManifest, manifest_);
  read_lines();
}

HostileFolder::HostileFolder(std::string folder)
    : folder_(std::move(folder)), manifest_(read_file(folder_ / kManifest).value_or("")) {
  if (manifest_.empty())
    throw UsageError("'" + folder_.string() + "' is no folder of hidwa_study hostile: it has no hostile.json");
  read_lines();
}

// A line that was cut short is made again.
void HostileFolder::read_lines() {
  std::istringstream text(read_file(folder_ / kDrives).value_or(""));
  for (std::string line; std::getline(text, line);) {
    const Row drive = from_line(line);
    if (line != hostile_head() && drive.size() == kColumns.size() && !text.eof()) lines_[index_of(drive)] = line;
  }
}

void HostileFolder::keep(std::uint64_t drive, const std::string& line) {
  lines_[drive] = line;
  std::error_code error;
  const bool fresh = std::filesystem::file_size(folder_ / kDrives, error) == 0 || error;
  std::ofstream file(folder_ / kDrives, std::ios::app);
  if (fresh) file << hostile_head() << '\n';
  file << line << '\n';
  if (!file.flush()) throw std::runtime_error("'" + (folder_ / kDrives).string() + "' cannot be written");
}

nlohmann::json HostileFolder::finish() {
  Group within, outside;
  within.columns = outside.columns = &kColumns;
  std::string text = hostile_head() + '\n';
  for (const auto& [index, line] : lines_) {
    const Row drive = from_line(line);
    (cell(drive, "promised", kColumns) == "1" ? within : outside).rows.push_back(drive);
    text += line + '\n';
  }
  const bool held = std::none_of(within.rows.begin(), within.rows.end(), is_found);
  nlohmann::json summary = {{"study", nlohmann::json::parse(manifest_)},
                            {"held", held},
                            {"within", json_of(within)},
                            {"conditions", by_condition(within)},
                            {"outside", by_condition(outside)}};
  Store(folder_).write(kDrives, text);
  Store(folder_).write("summary.json", summary.dump(2) + '\n');
  return summary;
}

std::string hostile_line(std::uint64_t drive_index, const hidwa_attack::HostileDrive& drive,
                         const hidwa_attack::DriveResult& r) {
  const hidwa_attack::Encounters& e = r.encounters;
  const auto whole = [](std::uint64_t number) { return std::to_string(number); };
  return whole(drive_index) + "," + drive.condition + "," + (drive.promised ? "1," : "0,") + drive.place + "," +
         name_of(drive.spec.outline) + "," + name_of(drive.spec.link) + "," + whole(drive.seed) +
         format(",%d,%d,%d,%.4f,%.3f,%d,%.4f,%.4f,%d,%.2f,%d,", r.cycles, r.moving, r.threatened, 1e3 * r.depth,
                1e-3 * r.touched_at, r.beyond, r.beyond_worst.v, r.beyond_worst.omega, r.hard, r.stood,
                drive.spec.walkers) +
         whole(e.met) + "," + whole(e.moving) + "," + whole(e.leaving) + "," + whole(e.at_rest);
}

std::string hostile_head() { return to_line(kColumns); }

}  // namespace study
}  // namespace hidwa_local_planner
