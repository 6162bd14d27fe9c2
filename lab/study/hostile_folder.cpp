// SPDX-License-Identifier: BSD-3-Clause
#include "hostile_folder.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "core/util/words.hpp"
#include "study/error.hpp"
#include "study/store.hpp"

namespace hidwa_local_planner {
namespace study {
namespace {

const char* const kManifest = "hostile.json";
const char* const kDrives = "drives.csv";
constexpr double kTouch = 1e-4;  // deeper than this counts [m]

// The columns of drives.csv, in their order.
struct Column {
  enum Index : std::size_t {
    index,
    condition,
    promised,
    place,
    outline,
    link,
    seed,
    cycles,
    moving,
    threatened,
    depth_mm,
    touched_at_s,
    beyond,
    beyond_v,
    beyond_omega,
    hard,
    stood_s,
    walkers,
    met,
    touched_moving,
    touched_leaving,
    touched_at_rest,
    columns
  };
};
constexpr const char* kHead =
    "index,condition,promised,place,outline,link,seed,cycles,moving,threatened,depth_mm,touched_at_s,beyond,beyond_v,"
    "beyond_omega,hard,stood_s,walkers,met,touched_moving,touched_leaving,touched_at_rest";

std::string read(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return file ? text.str() : "";
}

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream stream(line);
  for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(cell);
  return cells;
}

// What is counted over drives.
class Sum {
 public:
  void add(const std::vector<std::string>& cells) {
    const auto number = [&cells](std::size_t column) { return std::strtod(cells[column].c_str(), nullptr); };
    const auto count = [&number](std::size_t column) { return static_cast<long long>(number(column)); };
    ++drives_;
    cycles_ += count(Column::cycles);
    moving_ += count(Column::moving);
    threatened_ += count(Column::threatened);
    const double depth = 1e-3 * number(Column::depth_mm);
    contacts_ += depth > kTouch;
    worst_depth_ = std::max(worst_depth_, depth);
    beyond_ += count(Column::beyond);
    hard_ += count(Column::hard);
    if (number(Column::stood_s) > stood_) {
      stood_ = number(Column::stood_s);
      stood_index_ = cells[Column::index];
    }
    met_ += count(Column::met);
    touched_moving_ += count(Column::touched_moving);
    touched_leaving_ += count(Column::touched_leaving);
    touched_at_rest_ += count(Column::touched_at_rest);
    const bool too_much = count(Column::beyond) > 0 || count(Column::hard) > 0;
    if (depth > kTouch || too_much || count(Column::touched_moving) > 0)
      found_.push_back(std::strtoull(cells[Column::index].c_str(), nullptr, 10));
  }

  nlohmann::json json() const {
    const auto share = [](long long part, long long of) {
      return of > 0 ? static_cast<double>(part) / static_cast<double>(of) : 0.0;
    };
    return {{"drives", drives_},
            {"cycles", cycles_},
            {"moving", share(moving_, cycles_)},
            {"threatened", share(threatened_, cycles_)},
            {"contacts", contacts_},
            {"worst_depth_mm", 1e3 * worst_depth_},
            {"commands_beyond_limits", beyond_},
            {"commands_beyond_accelerations", hard_},
            {"longest_stand_with_a_way_open_s", stood_},
            {"longest_stand_drive", stood_index_},
            {"encounters", met_},
            {"touched_moving", touched_moving_},
            {"touched_leaving", touched_leaving_},
            {"touched_at_rest", touched_at_rest_},
            {"found", found_}};
  }
  bool held() const { return found_.empty(); }

 private:
  long long drives_ = 0, cycles_ = 0, moving_ = 0, threatened_ = 0, contacts_ = 0, beyond_ = 0, hard_ = 0, met_ = 0;
  long long touched_moving_ = 0, touched_leaving_ = 0, touched_at_rest_ = 0;
  double worst_depth_ = 0.0, stood_ = 0.0;  // [m], [s]
  std::string stood_index_;
  std::vector<std::uint64_t> found_;
};

}  // namespace

HostileFolder::HostileFolder(std::string folder, const std::string& manifest)
    : folder_(std::move(folder)), manifest_(manifest) {
  std::error_code error;
  std::filesystem::create_directories(folder_, error);
  if (error) throw std::runtime_error("'" + folder_.string() + "' cannot be made: " + error.message());
  const std::string present = read(folder_ / kManifest);
  if (!present.empty() && present != manifest_) {
    throw UsageError("'" + folder_.string() +
                     "' holds another study (its hostile.json differs): give another --out, or remove it");
  }
  Store(folder_).write(kManifest, manifest_);
  read_lines();
}

HostileFolder::HostileFolder(std::string folder) : folder_(std::move(folder)), manifest_(read(folder_ / kManifest)) {
  if (manifest_.empty())
    throw UsageError("'" + folder_.string() + "' is no folder of hidwa_study hostile: it has no hostile.json");
  read_lines();
}

// A line that was cut short is made again.
void HostileFolder::read_lines() {
  std::istringstream text(read(folder_ / kDrives));
  for (std::string line; std::getline(text, line);) {
    const std::vector<std::string> cells = cells_of(line);
    if (line != kHead && cells.size() == Column::columns && !text.eof()) {
      lines_[std::strtoull(cells[Column::index].c_str(), nullptr, 10)] = line;
    }
  }
}

void HostileFolder::keep(std::uint64_t drive, const std::string& line) {
  lines_[drive] = line;
  std::error_code error;
  const bool fresh = std::filesystem::file_size(folder_ / kDrives, error) == 0 || error;
  std::ofstream file(folder_ / kDrives, std::ios::app);
  if (fresh) file << kHead << '\n';
  file << line << '\n';
  if (!file.flush()) throw std::runtime_error("'" + (folder_ / kDrives).string() + "' cannot be written");
}

std::string HostileFolder::finish() {
  Sum within;
  std::map<std::string, Sum> by_condition, outside;
  std::string text = std::string(kHead) + '\n';
  for (const auto& [drive, line] : lines_) {
    const std::vector<std::string> cells = cells_of(line);
    if (cells[Column::promised] == "1") within.add(cells);
    (cells[Column::promised] == "1" ? by_condition : outside)[cells[Column::condition]].add(cells);
    text += line + '\n';
  }
  nlohmann::json conditions = nlohmann::json::object(), beyond = nlohmann::json::object();
  for (const auto& [name, sum] : by_condition) conditions[name] = sum.json();
  for (const auto& [name, sum] : outside) beyond[name] = sum.json();
  nlohmann::json summary = {{"study", nlohmann::json::parse(manifest_)},
                            {"held", within.held()},
                            {"within", within.json()},
                            {"conditions", conditions},
                            {"outside", beyond}};
  Store(folder_).write(kDrives, text);
  std::string json = summary.dump(2) + '\n';
  Store(folder_).write("summary.json", json);
  return json;
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

std::string hostile_head() { return kHead; }

}  // namespace study
}  // namespace hidwa_local_planner
