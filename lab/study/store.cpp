// SPDX-License-Identifier: BSD-3-Clause
#include "study/store.hpp"

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "files.hpp"
#include "study/error.hpp"

namespace hidwa_local_planner {
namespace study {
namespace {

namespace fs = std::filesystem;

const char* const kManifest = "study.json";
const char* const kPlan = "plan.csv";

std::string read_or_fail(const fs::path& path) {
  const std::optional<std::string> text = read_file(path);
  if (!text) throw UsageError("'" + path.string() + "' cannot be read: is its folder one of hidwa_study?");
  return *text;
}

std::string row_name(const std::string& id) { return "rows/" + id + ".csv"; }
std::string path_name(const std::string& id) { return "paths/" + id + ".csv"; }

}  // namespace

void Store::begin(const std::string& manifest, const Plan& plan, bool resume) const {
  std::error_code error;
  for (const char* part : {"rows", "paths"}) {
    fs::create_directories(fs::path(folder_) / part, error);
    if (error) throw std::runtime_error("'" + folder_ + "' cannot be made: " + error.message());
  }
  const std::optional<std::string> present = read_file(fs::path(folder_) / kManifest);
  const std::optional<std::string> present_plan = read_file(fs::path(folder_) / kPlan);
  const bool other = (present && *present != manifest) || (present_plan && *present_plan != to_csv(plan));
  if (other) {
    throw UsageError("'" + folder_ + "' holds another study (its study.json or plan.csv differs): give another " +
                     "--out, or remove it");
  }
  if (!resume) {
    for (const Run& run : plan.runs) {
      fs::remove(fs::path(folder_) / row_name(run.id), error);
      fs::remove(fs::path(folder_) / path_name(run.id), error);
    }
  }
  write(kManifest, manifest);
  write(kPlan, to_csv(plan));
}

std::optional<Row> Store::row(const Run& run) const {
  const std::optional<std::string> text = read_file(fs::path(folder_) / row_name(run.id));
  if (!text || text->empty() || text->back() != '\n') return std::nullopt;
  const Row row = from_line(*text);
  if (row.size() != tables_.columns.size() || row.front() != run.id) return std::nullopt;
  return row;
}

void Store::keep(const Row& row, const std::string& path) const {
  // The row comes last: where it is, the run is finished.
  if (!path.empty()) write(path_name(row.front()), path);
  write(row_name(row.front()), to_line(row) + '\n');
}

std::string Store::path(const Run& run) const { return read_file(fs::path(folder_) / path_name(run.id)).value_or(""); }

std::vector<Row> Store::rows(const Plan& plan) const {
  std::vector<Row> rows;
  for (const Run& run : plan.runs) {
    if (const std::optional<Row> finished = row(run)) rows.push_back(*finished);
  }
  return rows;
}

std::vector<Row> Store::finish(const Plan& plan) const {
  std::vector<Row> finished = rows(plan);
  std::string csv = to_line(tables_.columns) + '\n';
  for (const Row& row : finished) csv += to_line(row) + '\n';
  write("runs.csv", csv);
  if (plan.settings.size() > 1) write("ranking.csv", ranking_csv(tables_, plan, finished));
  write("summary.json", summary_json(tables_, plan, finished));
  return finished;
}

std::string Store::manifest() const { return read_or_fail(fs::path(folder_) / kManifest); }

Plan Store::plan() const {
  const fs::path path = fs::path(folder_) / kPlan;
  try {
    return plan_from_csv(read_or_fail(path));
  } catch (const std::logic_error& e) {
    throw UsageError("'" + path.string() + "' is damaged: " + e.what());
  }
}

void Store::write(const std::string& name, const std::string& text) const {
  const fs::path path = fs::path(folder_) / name;
  // Shards may share a folder.
  const fs::path draft = path.string() + "." + std::to_string(::getpid()) + ".part";
  std::ofstream file(draft, std::ios::binary);
  file << text;
  file.close();
  std::error_code error;
  if (file) fs::rename(draft, path, error);
  if (!file || error) throw std::runtime_error("'" + path.string() + "' cannot be written: is there room?");
}

}  // namespace study
}  // namespace hidwa_local_planner
