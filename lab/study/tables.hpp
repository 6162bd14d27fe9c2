// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "study/table.hpp"

namespace hidwa_local_planner {
namespace study {

/// What an experiment keeps of its runs, and what it makes of them.
struct Tables {
  using Text = std::function<std::string(const Plan&, const std::vector<Row>&)>;
  std::vector<std::string> columns;  // of runs.csv
  Text summary;                      // summary.json
  Text ranking;                      // ranking.csv, where there are several settings
  Text digest;                       // what is told at the end, in lines
};

/// Those of the study with simulated people.
Tables people_tables();

/// Those of an experiment: run, pilot, sweep, barn, dynabarn, crowd, passage or gap.
Tables tables_of(const std::string& experiment);

}  // namespace study
}  // namespace hidwa_local_planner
