// SPDX-License-Identifier: BSD-3-Clause
#include "study/encounter_table.hpp"

#include <algorithm>

#include "core/util/words.hpp"

namespace hidwa_local_planner {
namespace study {
namespace {

constexpr double kJustLeapt = 0.5;  // [s]
constexpr double kNobody = 99.0;    // [m], written where nobody ever was there

nlohmann::json encounter_figures(const Group& group) {
  return {{"success", group.mean("success")},
          {"touched_moving", group.share("touched_moving")},
          {"touched_at_rest", group.share("touched_at_rest")},
          {"touched_wall", group.share("touched_wall")},
          {"timeout", group.mean("timeout")},
          {"touched_after_leap", group.share("touched_after_leap")},
          {"touches_moving", group.count("touched_moving")},
          {"touches_at_rest", group.count("touched_at_rest")},
          {"encounters", group.count("encounters")},
          {"time", group.mean("time")},
          {"time_of_successes", group.time_of_successes()},
          {"standing", group.mean("standing")},
          {"personal_space", group.mean("personal_space")},
          {"operator_active", group.mean("operator_active")}};
}

// Fewest drives touched while moving, then most successes, least time.
std::vector<double> encounter_merit(const Group& group) {
  return {group.share("touched_moving"), -group.mean("success"), group.mean("time")};
}

// Each touch as time:id:moved:by_robot:robot's speed:mover's speed:time since its leap, with bars between them.
std::string words_of(const std::vector<sim::Touch>& touches) {
  std::string words;
  for (const sim::Touch& t : touches) {
    words += (words.empty() ? "" : "|") + format("%.2f:%u:%d:%d:%.3f:%.3f:%.2f", t.time, static_cast<unsigned>(t.id),
                                                 t.robot_moved ? 1 : 0, t.by_robot ? 1 : 0, t.robot_speed, t.speed,
                                                 std::min(t.since_leap, kNobody));
  }
  return words.empty() ? "none" : words;
}

}  // namespace

Tables encounter_tables() {
  Tables tables;
  tables.columns = {"id",         "world",          "class",           "mode",
                    "setting",    "seed",           "release",         "ending",
                    "success",    "touched_moving", "touched_at_rest", "touched_wall",
                    "timeout",    "time",           "length",          "touched_after_leap",
                    "moved_into", "encounters",     "closest",         "personal_space",
                    "standing",   "clearance",      "operator_active", "interventions",
                    "agreement",  "failures",       "brakes",          "touches"};
  tables.keys = {"class", "mode", "setting"};
  tables.sorted_by = {"setting"};
  tables.figures = encounter_figures;
  tables.merit = encounter_merit;
  tables.ranked = {"success", "touched_moving", "touched_at_rest", "timeout", "time_of_successes"};
  tables.told = {"success",           "touched_moving", "touched_at_rest", "timeout",
                 "time_of_successes", "encounters",     "touches_moving",  "touches_at_rest"};
  return tables;
}

Row encounter_row(const Plan& plan, const Run& run, const Scenery& scenery, const drive::DriveResult& r) {
  const drive::PeopleResult& p = r.people;
  // Where a touch ends the drive, none may be; where people may come against a robot that stands, arrival counts.
  const bool success =
      r.arrived && r.contacts == 0 && p.contacts_moving == 0 && (plan.experiment == "crowd" || p.contacts_at_rest == 0);
  int leapt = 0, moved_into = 0;
  for (const sim::Touch& touch : p.touches) {
    leapt += touch.since_leap <= kJustLeapt;
    moved_into += touch.by_robot;
  }
  return row_in(encounter_tables().columns, plan, run, scenery.seed, r,
                {{"world", scenery.world},
                 {"class", scenery.klass},
                 {"mode", run.condition},
                 {"release", number(scenery.release)},
                 {"success", success ? "1" : "0"},
                 {"touched_moving", std::to_string(p.contacts_moving)},
                 {"touched_at_rest", std::to_string(p.contacts_at_rest)},
                 {"touched_wall", std::to_string(r.contacts)},
                 {"timeout", r.arrived || r.ending == drive::Ending::contact ? "0" : "1"},
                 {"time", number(r.duration)},
                 {"touched_after_leap", std::to_string(leapt)},
                 {"moved_into", std::to_string(moved_into)},
                 {"encounters", std::to_string(p.encounters)},
                 {"closest", number(std::min(kNobody, p.closest))},
                 {"personal_space", number(p.personal_space)},
                 {"standing", number(p.standing)},
                 {"touches", words_of(p.touches)}});
}

std::string to_string(drive::Tracking tracking) {
  switch (tracking) {
    case drive::Tracking::none:
      return "none";
    case drive::Tracking::truth:
      return "truth";
    case drive::Tracking::laser:
      return "laser";
  }
  return "unknown";
}

}  // namespace study
}  // namespace hidwa_local_planner
