// SPDX-License-Identifier: BSD-3-Clause
#include "study/gap_table.hpp"

namespace hidwa_local_planner {
namespace study {
namespace {

// The first run's, which all phases have.
double length_in(const Group& group, const std::string& column) { return group.values(column).front(); }

nlohmann::json gap_figures(const Group& group) {
  const Statistics width = statistics(group.values("width"));
  return {{"padded", length_in(group, "padded")},
          {"resolution", length_in(group, "resolution")},
          {"noise", length_in(group, "noise")},
          {"least", width.min},
          {"mean", width.mean},
          {"most", width.max}};
}

std::vector<double> gap_merit(const Group& group) { return {statistics(group.values("width")).mean}; }

}  // namespace

Tables gap_tables() {
  Tables tables;
  tables.columns = {"id",    "outline", "setting", "resolution", "noise",
                    "phase", "padded",  "width",   "drives",     "duration"};
  tables.keys = {"outline", "setting"};
  tables.sorted_by = {"outline", "setting"};
  tables.order = gap_outlines();
  tables.count_name = "phases";
  tables.figures = gap_figures;
  tables.merit = gap_merit;
  tables.ranked = {"least", "mean", "most"};
  tables.told = {"padded", "resolution", "noise", "least", "mean", "most"};
  return tables;
}

Row gap_row(const Plan& plan, const Run& run, double phase, const GapSubject& subject, const Narrowest& narrowest) {
  return {run.id,
          run.condition,
          to_string(plan.settings[run.setting]),
          number(subject.resolution),
          number(subject.noise),
          number(phase),
          number(width_of(run.condition) + 2.0 * subject.padding),
          number(narrowest.width),
          std::to_string(narrowest.drives),
          number(narrowest.result.duration)};
}

}  // namespace study
}  // namespace hidwa_local_planner
