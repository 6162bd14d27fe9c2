// SPDX-License-Identifier: BSD-3-Clause
#include "study/attack_table.hpp"

#include <algorithm>

namespace hidwa_local_planner {
namespace study {
namespace {

const char* const kWithin = "within";
const char* const kOutside = "outside";

nlohmann::json attack_figures(const Group& group) {
  const double cycles = std::max(1.0, group.sum("cycles"));
  return {{"cycles", group.count("cycles")},
          {"moving", group.sum("moving") / cycles},
          {"threatened", group.sum("threatened") / cycles},
          {"contacts", group.count("touched")},
          {"worst_mm", group.most("depth_mm")},
          {"beyond", group.count("beyond")},
          {"beyond_v", group.most("beyond_v")},
          {"beyond_omega", group.most("beyond_omega")},
          {"hard", group.count("hard")},
          {"longest_stand", group.most("stood_s")},
          {"met", group.count("met")},
          {"touched_moving", group.count("touched_moving")},
          {"touched_leaving", group.count("touched_leaving")},
          {"touched_at_rest", group.count("touched_at_rest")},
          {"stood_in", group.count("stood_in")},
          {"came_out", group.count("came_out")},
          {"entered", group.above("entered", 0.0)},
          {"neighbour_mm", group.most("neighbour_mm")},
          {"growth_mm", group.most("growth_mm")},
          {"too_fast", group.count("too_fast")},
          {"found", group.count("found")}};
}

// All that lies within the promise, all outside, and what was found within.
Verdict attack_verdict(const Plan& plan, const std::vector<Row>& rows) {
  Tables by_promise = attack_tables();
  by_promise.keys = by_promise.sorted_by = {"promise"};
  by_promise.order = {kWithin, kOutside};
  Verdict verdict;
  verdict.told = digest(by_promise, {}, rows);
  for (const Row& row : rows) {
    const std::vector<std::string>& names = by_promise.columns;
    if (cell(row, "promise", names) != kWithin || cell(row, "found", names) == "0") continue;
    verdict.held = false;
    const auto run =
        std::find_if(plan.runs.begin(), plan.runs.end(), [&row](const Run& one) { return one.id == row.front(); });
    verdict.told += "found: " + run->id + "; alone: the same with --condition " + run->condition + " --drive " +
                    std::to_string(run->participant) + " and another --out\n";
  }
  return verdict;
}

// Within the promise people count only where nobody appears within reach.
bool is_found(const hidwa_attack::Case& drive, const hidwa_attack::DriveResult& r) {
  const bool people_count = !drive.condition->promised || drive.spec.bounds.appear > 0.0;
  return r.touched || r.beyond > 0 || r.hard > 0 || (people_count && r.encounters.moving > 0);
}

}  // namespace

const std::vector<std::string>& attack_conditions() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const hidwa_attack::Condition& condition : hidwa_attack::all_conditions()) all.emplace_back(condition.name);
    all.emplace_back(kMixed);
    return all;
  }();
  return names;
}

Tables attack_tables() {
  Tables tables;
  tables.columns = from_line(
      "id,promise,condition,place,outline,link,seed,cycles,moving,threatened,touched,depth_mm,touched_at,beyond,"
      "beyond_v,beyond_omega,hard,stood_s,walkers,met,touched_moving,touched_leaving,touched_at_rest,stood_in,"
      "came_out,entered,neighbour_mm,growth_mm,fastest_inside,speed_bound,too_fast,found");
  tables.keys = {"promise", "condition"};
  tables.sorted_by = {"condition"};
  tables.order = attack_conditions();
  tables.count_name = "drives";
  tables.figures = attack_figures;
  tables.told = {"cycles",        "contacts", "worst_mm",       "beyond",          "hard",    "moving",    "threatened",
                 "longest_stand", "met",      "touched_moving", "touched_leaving", "entered", "growth_mm", "found"};
  tables.verdict = attack_verdict;
  return tables;
}

Row attack_row(const Run& run, const hidwa_attack::Case& drive, const hidwa_attack::DriveResult& r) {
  const hidwa_attack::Encounters& e = r.encounters;
  return {run.id,
          drive.condition->promised ? kWithin : kOutside,
          drive.condition->name,
          drive.place,
          name_of(drive.spec.outline),
          name_of(drive.spec.link),
          std::to_string(drive.seed),
          std::to_string(r.cycles),
          std::to_string(r.moving),
          std::to_string(r.threatened),
          std::to_string(r.touched),
          number(1e3 * r.depth),
          number(1e-3 * r.touched_at),
          std::to_string(r.beyond),
          number(r.beyond_worst.v),
          number(r.beyond_worst.omega),
          std::to_string(r.hard),
          number(r.stood),
          std::to_string(drive.spec.walkers),
          std::to_string(e.met),
          std::to_string(e.moving),
          std::to_string(e.leaving),
          std::to_string(e.at_rest),
          std::to_string(r.stood_in),
          std::to_string(r.came_out),
          std::to_string(r.entered),
          number(1e3 * r.excess),
          number(1e3 * r.growth),
          number(r.fastest_inside),
          number(r.speed_bound),
          std::to_string(r.fastest_inside > 1.02 * r.speed_bound),
          std::to_string(is_found(drive, r))};
}

}  // namespace study
}  // namespace hidwa_local_planner
