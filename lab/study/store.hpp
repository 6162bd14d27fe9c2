// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "study/tables.hpp"

namespace hidwa_local_planner {
namespace study {

/// A study's folder. What decides about the results is in study.json and plan.csv; each finished run has a
/// line in rows/ and its way in paths/; runs.csv, summary.json and, for several settings, ranking.csv are
/// made of the rows. Files appear whole or not at all. Throws std::runtime_error where it cannot read or
/// write.
class Store {
 public:
  explicit Store(std::string folder, Tables tables = people_tables())
      : folder_(std::move(folder)), tables_(std::move(tables)) {}

  /// Begins or goes on. Throws UsageError where the folder holds another study, and with `resume` false
  /// forgets the runs that it holds.
  void begin(const std::string& manifest, const Plan& plan, bool resume) const;

  /// The line of a finished run; none where it is not finished or its line is damaged.
  std::optional<Row> row(const Run& run) const;

  /// The lines of all finished runs of a plan.
  std::vector<Row> rows(const Plan& plan) const;

  /// Keeps a finished run; an empty `path` is not kept. May be called from several threads.
  void keep(const Row& row, const std::string& path) const;

  /// The path kept of a run; empty where there is none.
  std::string path(const Run& run) const;

  /// Makes runs.csv, summary.json and ranking.csv of all runs that are finished. Returns their lines.
  std::vector<Row> finish(const Plan& plan) const;

  std::string manifest() const;
  Plan plan() const;
  void write(const std::string& name, const std::string& text) const;

 private:
  std::string folder_;
  Tables tables_;
};

}  // namespace study
}  // namespace hidwa_local_planner
