// SPDX-License-Identifier: BSD-3-Clause
#include "study/passage_table.hpp"

#include "core/util/words.hpp"

namespace hidwa_local_planner {
namespace study {
namespace {

double most(const Group& group, const std::string& column) { return statistics(group.values(column)).max; }
long stood_long(const Group& group) { return group.above("longest_stand", kLongestStand); }
long stopped_often(const Group& group) { return group.above("stops", kMostStops); }

nlohmann::json passage_figures(const Group& group) {
  return {{"arrived", group.count("arrived")},
          {"stood_long", stood_long(group)},
          {"stopped_often", stopped_often(group)},
          {"most_stops", most(group, "stops")},
          {"mean_stops", group.mean("stops")},
          {"longest_stand", most(group, "longest_stand")},
          {"standing", group.mean("standing")},
          {"duration", group.mean("duration")},
          {"v_change", group.mean("v_change")},
          {"acc_rms", group.mean("acc_rms")},
          {"share_at_limit", group.mean("share_at_limit")},
          {"contacts", group.sum("contacts")},
          {"failures", group.mean("failures")}};
}

// Fewest contacts, then most steady drives, least time.
std::vector<double> passage_merit(const Group& group) {
  return {group.mean("contacts"), -group.mean("steady"), group.mean("duration")};
}

nlohmann::json passage_ranked(const Group& group) { return {{"steady", group.mean("steady")}}; }

std::string passage_line(const Group& group) {
  return group.name() +
         format(
             ": n %zu, arrived %ld, %.1f s, worst stand %.2f s (%ld above %.0f s), stops %.2f, at most %.0f (%ld "
             "above %d), contacts %ld\n",
             group.rows.size(), group.count("arrived"), group.mean("duration"), most(group, "longest_stand"),
             stood_long(group), kLongestStand, group.mean("stops"), most(group, "stops"), stopped_often(group),
             kMostStops, group.count("contacts"));
}

}  // namespace

Tables passage_tables() {
  Tables tables;
  tables.columns = {"id",           "drive",   "setting",        "seed",     "ending", "arrived",  "steady",
                    "duration",     "stops",   "longest_stand",  "standing", "length", "contacts", "v_change",
                    "omega_change", "acc_rms", "share_at_limit", "failures", "brakes"};
  tables.keys = {"setting"};
  tables.sorted_by = {"setting"};
  tables.figures = passage_figures;
  tables.merit = passage_merit;
  tables.ranked = {"arrived", "steady", "duration", "mean_stops", "longest_stand"};
  tables.only_ranked = passage_ranked;
  tables.digest_line = passage_line;
  return tables;
}

Row passage_row(const Plan& plan, const Run& run, std::uint64_t world_seed, const drive::DriveResult& r,
                const Passage& passage) {
  const bool steady =
      r.arrived && r.contacts == 0 && passage.longest_stand <= kLongestStand && passage.stops <= kMostStops;
  return {run.id,
          std::to_string(run.participant),
          to_string(plan.settings[run.setting]),
          std::to_string(world_seed),
          drive::to_string(r.ending),
          r.arrived ? "1" : "0",
          steady ? "1" : "0",
          number(r.duration),
          std::to_string(passage.stops),
          number(passage.longest_stand),
          number(passage.standing),
          number(r.length),
          std::to_string(r.contacts),
          number(r.v_change),
          number(r.omega_change),
          number(r.gentleness.acc_rms),
          number(r.gentleness.at_limit),
          std::to_string(r.failures),
          std::to_string(r.brakes)};
}

}  // namespace study
}  // namespace hidwa_local_planner
