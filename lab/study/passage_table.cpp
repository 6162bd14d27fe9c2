// SPDX-License-Identifier: BSD-3-Clause
#include "study/passage_table.hpp"

namespace hidwa_local_planner {
namespace study {
namespace {

long stood_long(const Group& group) { return group.above("longest_stand", kLongestStand); }
long stopped_often(const Group& group) { return group.above("stops", kMostStops); }

nlohmann::json passage_figures(const Group& group) {
  return {{"arrived", group.count("arrived")},
          {"stood_long", stood_long(group)},
          {"stopped_often", stopped_often(group)},
          {"most_stops", group.most("stops")},
          {"mean_stops", group.mean("stops")},
          {"longest_stand", group.most("longest_stand")},
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
  tables.told = {"arrived",    "duration",   "longest_stand", "stood_long",
                 "mean_stops", "most_stops", "stopped_often", "contacts"};
  return tables;
}

Row passage_row(const Plan& plan, const Run& run, std::uint64_t world_seed, const drive::DriveResult& r,
                const Passage& passage) {
  const bool steady =
      r.arrived && r.contacts == 0 && passage.longest_stand <= kLongestStand && passage.stops <= kMostStops;
  return row_in(passage_tables().columns, plan, run, world_seed, r,
                {{"drive", std::to_string(run.participant)},
                 {"steady", steady ? "1" : "0"},
                 {"stops", std::to_string(passage.stops)},
                 {"longest_stand", number(passage.longest_stand)},
                 {"standing", number(passage.standing)},
                 {"share_at_limit", number(r.gentleness.at_limit)}});
}

}  // namespace study
}  // namespace hidwa_local_planner
