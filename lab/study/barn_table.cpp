// SPDX-License-Identifier: BSD-3-Clause
#include "study/barn_table.hpp"

#include "core/util/words.hpp"

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

std::string barn_line(const Group& group) {
  return group.name() + format(
                            ": n %zu, success %.3f, collision %.3f, timeout %.3f, %.1f s, metric %.3f, contacts %ld, "
                            "least clearance %.3f m\n",
                            group.rows.size(), group.mean("success"), group.mean("collision"), group.mean("timeout"),
                            group.time_of_successes(), group.mean("metric"), group.count("contacts"),
                            statistics(group.values("clearance")).min);
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
  tables.digest_line = barn_line;
  return tables;
}

Row barn_row(const Plan& plan, const Run& run, std::uint64_t world_seed, const drive::DriveResult& r,
             const BarnScore& score) {
  const bool collision = r.contacts > 0;
  return {run.id,
          std::to_string(run.participant),
          run.condition,
          to_string(plan.settings[run.setting]),
          std::to_string(world_seed),
          drive::to_string(r.ending),
          score.success ? "1" : "0",
          collision ? "1" : "0",
          score.success || collision ? "0" : "1",
          number(r.duration),
          number(score.metric),
          number(score.optimal_time),
          number(score.path_clearance),
          number(r.length),
          std::to_string(r.contacts),
          number(r.clearance),
          number(r.operator_active),
          std::to_string(r.interventions),
          number(r.v_change),
          number(r.omega_change),
          number(r.agreement),
          std::to_string(r.failures),
          std::to_string(r.brakes)};
}

}  // namespace study
}  // namespace hidwa_local_planner
