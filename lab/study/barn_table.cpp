// SPDX-License-Identifier: BSD-3-Clause
#include "study/barn_table.hpp"

namespace hidwa_local_planner {
namespace study {
namespace {

nlohmann::json barn_figures(const Group& group) {
  return {{"success", group.mean("success")},
          {"collision", group.mean("collision")},
          {"timeout", group.mean("timeout")},
          {"time_of_successes", group.time_of_successes()},
          {"metric", group.mean("metric")},
          {"contacts", group.count("contacts")},
          {"least_clearance", statistics(group.values("clearance")).min},
          {"operator_active", group.mean("operator_active")}};
}

// Fewest contacts, then the greatest metric, most successes.
std::vector<double> barn_merit(const Group& group) {
  return {group.mean("contacts"), -group.mean("metric"), -group.mean("success")};
}

}  // namespace

Tables barn_tables() {
  Tables tables;
  tables.columns = {"id",        "world",           "mode",           "setting",  "seed",
                    "ending",    "success",         "collision",      "timeout",  "time",
                    "metric",    "optimal_time",    "path_clearance", "length",   "contacts",
                    "clearance", "operator_active", "interventions",  "v_change", "omega_change",
                    "agreement", "failures",        "brakes"};
  tables.keys = {"mode", "setting"};
  tables.sorted_by = {"setting", "mode"};
  tables.order = barn_modes();
  tables.figures = barn_figures;
  tables.merit = barn_merit;
  tables.ranked = {"success", "collision", "timeout", "time_of_successes", "metric"};
  tables.told = {"success", "collision", "timeout", "time_of_successes", "metric", "contacts", "least_clearance"};
  return tables;
}

Row barn_row(const Plan& plan, const Run& run, std::uint64_t world_seed, const drive::DriveResult& r,
             const BarnScore& score) {
  const bool collision = r.contacts > 0;
  return row_in(barn_tables().columns, plan, run, world_seed, r,
                {{"world", std::to_string(run.participant)},
                 {"mode", run.condition},
                 {"success", score.success ? "1" : "0"},
                 {"collision", collision ? "1" : "0"},
                 {"timeout", score.success || collision ? "0" : "1"},
                 {"time", number(r.duration)},
                 {"metric", number(score.metric)},
                 {"optimal_time", number(score.optimal_time)},
                 {"path_clearance", number(score.path_clearance)}});
}

}  // namespace study
}  // namespace hidwa_local_planner
