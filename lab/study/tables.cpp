// SPDX-License-Identifier: BSD-3-Clause
#include "study/tables.hpp"

#include "study/attack_table.hpp"
#include "study/barn_table.hpp"
#include "study/encounter_table.hpp"
#include "study/gap_table.hpp"
#include "study/passage_table.hpp"

namespace hidwa_local_planner {
namespace study {
namespace {

nlohmann::json people_figures(const Group& group) {
  nlohmann::json all = nlohmann::json::object();
  for (const std::string& measure : measures()) {
    const Statistics s = statistics(group.values(measure));
    all[measure] = {{"mean", s.mean}, {"median", s.median}, {"sd", s.sd}, {"min", s.min}, {"max", s.max}};
  }
  return {{"arrived", group.count("arrived")}, {"measures", all}};
}

// Most arrivals, then fewest contacts, fewest regions crossed, least time.
std::vector<double> people_merit(const Group& group) {
  return {-group.mean("arrived"), group.mean("contacts"), group.mean("regions_crossed"), group.mean("duration")};
}

nlohmann::json people_ranked(const Group& group) {
  nlohmann::json means = nlohmann::json::object();
  for (const std::string& measure : measures()) means["mean_" + measure] = group.mean(measure);
  return means;
}

}  // namespace

Tables people_tables() {
  Tables tables;
  tables.columns = columns();
  tables.keys = {"condition", "setting"};
  tables.sorted_by = {"setting", "condition"};
  tables.order = {"SJ", "SG", "SW"};
  tables.figures = people_figures;
  tables.merit = people_merit;
  tables.ranked = {"arrived"};
  for (const std::string& measure : measures()) tables.ranked.push_back("mean_" + measure);
  tables.only_ranked = people_ranked;
  tables.told = {"arrived", "mean_duration", "mean_regions_crossed", "mean_contacts"};
  return tables;
}

Tables tables_of(const std::string& experiment) {
  if (experiment == "barn") return barn_tables();
  if (experiment == "dynabarn" || experiment == "crowd") return encounter_tables();
  if (experiment == "passage") return passage_tables();
  if (experiment == "gap") return gap_tables();
  if (experiment == "attack") return attack_tables();
  return people_tables();
}

}  // namespace study
}  // namespace hidwa_local_planner
