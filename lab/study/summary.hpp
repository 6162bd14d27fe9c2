// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "study/table.hpp"

namespace hidwa_local_planner {
namespace study {

/// What is said of a measure over several runs; `sd` is that of a sample, 0 for one run.
struct Statistics {
  double mean = 0.0, median = 0.0, sd = 0.0, min = 0.0, max = 0.0;
};
Statistics statistics(std::vector<double> values);

/// The runs of one condition with one setting.
struct Group {
  std::string condition;
  std::string setting;
  std::vector<Row> rows;
};

/// By setting in the order of the plan, then by condition: SJ, SG, SW.
std::vector<Group> groups(const Plan& plan, const std::vector<Row>& rows);

/// summary.json.
std::string summary_json(const Plan& plan, const std::vector<Row>& rows);

/// ranking.csv: the best setting first: most arrivals, fewest contacts, fewest regions crossed, least time.
std::string ranking_csv(const Plan& plan, const std::vector<Row>& rows);

}  // namespace study
}  // namespace hidwa_local_planner
