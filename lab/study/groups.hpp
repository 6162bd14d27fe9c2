// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "study/table.hpp"

namespace hidwa_local_planner {
namespace study {

/// What is said of a measure over several runs; `sd` is that of a sample, 0 for one run.
struct Statistics {
  double mean = 0.0, median = 0.0, sd = 0.0, min = 0.0, max = 0.0;
};
Statistics statistics(std::vector<double> values);

/// Runs that have the same in the columns that name them, such as mode and setting; one at least.
struct Group {
  std::vector<std::string> names;                     // what is in those columns
  std::vector<std::ptrdiff_t> place;                  // among the other groups
  const std::vector<std::string>* columns = nullptr;  // of the rows; they outlive the group
  std::vector<Row> rows;

  /// The names with blanks between them.
  std::string name() const;

  std::vector<double> values(const std::string& column) const;
  double sum(const std::string& column) const;
  double mean(const std::string& column) const;
  double most(const std::string& column) const;
  /// The sum of whole numbers.
  long count(const std::string& column) const;
  /// How many runs have more than `bound` in a column; which share of them has more than 0.
  long above(const std::string& column, double bound) const;
  double share(const std::string& column) const;
  /// The mean time of the runs that are a success; 0 where none is.
  double time_of_successes() const;
};

/// What is said of all runs together.
struct Verdict {
  bool held = true;  // the study ends with 1 where it is not so
  std::string told;  // in lines
};

/// What an experiment keeps of its runs, and what it says of a group of them.
struct Tables {
  std::vector<std::string> columns;                        // of runs.csv
  std::vector<std::string> keys;                           // those of them that name a group
  std::vector<std::string> sorted_by;                      // those of the keys that order groups, the first one first
  std::vector<std::string> order;                          // of what is in them; settings come as in the plan
  std::string count_name = "n";                            // what the number of runs is called
  std::function<nlohmann::json(const Group&)> figures;     // in summary.json, by name
  std::function<std::vector<double>(const Group&)> merit;  // the least comes first in ranking.csv
  std::vector<std::string> ranked;                         // names of the figures there
  // Figures there that summary.json does not have, by name.
  std::function<nlohmann::json(const Group&)> only_ranked = [](const Group&) { return nlohmann::json::object(); };
  std::vector<std::string> told;  // names of the figures that are told at the end
  std::function<Verdict(const Plan&, const std::vector<Row>&)> verdict = [](const auto&...) { return Verdict{}; };
};

/// Groups whose order the tables do not say come as their first runs do.
std::vector<Group> groups(const Tables& tables, const Plan& plan, const std::vector<Row>& rows);

/// summary.json; ranking.csv, where there are several settings; and what is told at the end, in lines.
std::string summary_json(const Tables& tables, const Plan& plan, const std::vector<Row>& rows);
std::string ranking_csv(const Tables& tables, const Plan& plan, const std::vector<Row>& rows);
std::string digest(const Tables& tables, const Plan& plan, const std::vector<Row>& rows);

}  // namespace study
}  // namespace hidwa_local_planner
