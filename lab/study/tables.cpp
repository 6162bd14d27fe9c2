// SPDX-License-Identifier: BSD-3-Clause
#include "study/tables.hpp"

#include "core/util/words.hpp"
#include "study/barn_table.hpp"
#include "study/encounter_table.hpp"
#include "study/gap_table.hpp"
#include "study/passage_table.hpp"
#include "study/summary.hpp"

namespace hidwa_local_planner {
namespace study {
namespace {

std::string digest(const Plan& plan, const std::vector<Row>& rows) {
  std::string lines;
  for (const Group& group : groups(plan, rows)) {
    double arrived = 0.0, contacts = 0.0, crossed = 0.0, duration = 0.0;
    for (const Row& row : group.rows) {
      arrived += value(row, "arrived");
      contacts += value(row, "contacts");
      crossed += value(row, "regions_crossed");
      duration += value(row, "duration");
    }
    const auto n = static_cast<double>(group.rows.size());
    lines += group.condition + " " + group.setting + ": " +
             format("n %.0f, arrived %.0f, %.2f s, %.3f regions crossed, contacts %.0f in all\n", n, arrived,
                    duration / n, crossed / n, contacts);
  }
  return lines;
}

}  // namespace

Tables people_tables() { return {columns(), summary_json, ranking_csv, digest}; }

Tables tables_of(const std::string& experiment) {
  if (experiment == "barn") return barn_tables();
  if (experiment == "dynabarn" || experiment == "crowd") return encounter_tables();
  if (experiment == "passage") return passage_tables();
  if (experiment == "gap") return gap_tables();
  return people_tables();
}

}  // namespace study
}  // namespace hidwa_local_planner
