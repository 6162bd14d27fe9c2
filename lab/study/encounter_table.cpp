// SPDX-License-Identifier: BSD-3-Clause
#include "study/encounter_table.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "core/util/words.hpp"

namespace hidwa_local_planner {
namespace study {
namespace {

constexpr double kJustLeapt = 0.5;  // [s]
constexpr double kNobody = 99.0;    // [m], written where nobody ever was there

const std::vector<std::string>& columns_of_encounters() {
  static const std::vector<std::string> all{"id",         "world",          "class",           "mode",
                                            "setting",    "seed",           "release",         "ending",
                                            "success",    "touched_moving", "touched_at_rest", "touched_wall",
                                            "timeout",    "time",           "length",          "touched_after_leap",
                                            "moved_into", "encounters",     "closest",         "personal_space",
                                            "standing",   "clearance",      "operator_active", "interventions",
                                            "agreement",  "failures",       "brakes",          "touches"};
  return all;
}

double figure_of(const Row& row, const std::string& column) { return value(row, column, columns_of_encounters()); }
const std::string& word_of(const Row& row, const std::string& column) {
  return cell(row, column, columns_of_encounters());
}

// The runs of one class of worlds, mode and setting.
struct Encounters {
  std::string klass, mode, setting;
  std::vector<Row> rows;

  double sum(const std::string& column) const {
    double all = 0.0;
    for (const Row& row : rows) all += figure_of(row, column);
    return all;
  }
  double mean(const std::string& column) const { return sum(column) / static_cast<double>(rows.size()); }
  double share(const std::string& column) const {
    const auto some = std::count_if(rows.begin(), rows.end(), [&](const Row& r) { return figure_of(r, column) > 0.0; });
    return static_cast<double>(some) / static_cast<double>(rows.size());
  }
  double time_of_successes() const {
    double time = 0.0, n = 0.0;
    for (const Row& row : rows) {
      if (word_of(row, "success") != "1") continue;
      time += figure_of(row, "time");
      n += 1.0;
    }
    return n > 0.0 ? time / n : 0.0;
  }
};

// In the order of the plan's settings; classes and modes as they first come.
std::vector<Encounters> encounters_of(const Plan& plan, const std::vector<Row>& rows) {
  std::vector<Encounters> groups;
  for (const Setting& setting : plan.settings) {
    const std::string name = to_string(setting);
    for (const Row& row : rows) {
      if (word_of(row, "setting") != name) continue;
      auto group = std::find_if(groups.begin(), groups.end(), [&](const Encounters& g) {
        return g.setting == name && g.klass == word_of(row, "class") && g.mode == word_of(row, "mode");
      });
      if (group == groups.end())
        group = groups.insert(groups.end(), {word_of(row, "class"), word_of(row, "mode"), name, {}});
      group->rows.push_back(row);
    }
  }
  return groups;
}

nlohmann::json json_of_encounters(const Encounters& group) {
  return {{"class", group.klass},
          {"mode", group.mode},
          {"setting", group.setting},
          {"n", group.rows.size()},
          {"success", group.mean("success")},
          {"touched_moving", group.share("touched_moving")},
          {"touched_at_rest", group.share("touched_at_rest")},
          {"touched_wall", group.share("touched_wall")},
          {"timeout", group.mean("timeout")},
          {"touched_after_leap", group.share("touched_after_leap")},
          {"touches_moving", std::lround(group.sum("touched_moving"))},
          {"touches_at_rest", std::lround(group.sum("touched_at_rest"))},
          {"encounters", std::lround(group.sum("encounters"))},
          {"time", group.mean("time")},
          {"time_of_successes", group.time_of_successes()},
          {"standing", group.mean("standing")},
          {"personal_space", group.mean("personal_space")},
          {"operator_active", group.mean("operator_active")}};
}

std::string encounter_summary(const Plan& plan, const std::vector<Row>& rows) {
  nlohmann::json all = nlohmann::json::array();
  for (const Encounters& group : encounters_of(plan, rows)) all.push_back(json_of_encounters(group));
  const nlohmann::json summary = {
      {"experiment", plan.experiment}, {"runs_planned", plan.runs.size()}, {"runs", rows.size()}, {"groups", all}};
  return summary.dump(2) + '\n';
}

// The best first: fewest drives touched while moving, most successes.
std::string encounter_ranking(const Plan& plan, const std::vector<Row>& rows) {
  std::vector<Encounters> ranked = encounters_of(plan, rows);
  const auto merit = [](const Encounters& g) {
    return std::make_tuple(g.share("touched_moving"), -g.mean("success"), g.mean("time"));
  };
  std::stable_sort(ranked.begin(), ranked.end(),
                   [&merit](const Encounters& a, const Encounters& b) { return merit(a) < merit(b); });
  std::string csv = "rank,class,mode,setting,n,success,touched_moving,touched_at_rest,timeout,time_of_successes\n";
  int rank = 0;
  for (const Encounters& g : ranked) {
    csv +=
        std::to_string(++rank) + ',' + g.klass + ',' + g.mode + ',' + g.setting + ',' + std::to_string(g.rows.size());
    for (const double v : {g.mean("success"), g.share("touched_moving"), g.share("touched_at_rest"), g.mean("timeout"),
                           g.time_of_successes()}) {
      csv += ',' + number(v);
    }
    csv += '\n';
  }
  return csv;
}

std::string encounter_digest(const Plan& plan, const std::vector<Row>& rows) {
  std::string lines;
  for (const Encounters& g : encounters_of(plan, rows)) {
    lines += g.klass + " " + g.mode + " " + g.setting + ": ";
    lines += format(
        "n %zu, success %.3f, touched moving %.3f, at rest %.3f, timeout %.3f, %.1f s, %.0f encounters, "
        "%.0f touches moving, %.0f at rest\n",
        g.rows.size(), g.mean("success"), g.share("touched_moving"), g.share("touched_at_rest"), g.mean("timeout"),
        g.time_of_successes(), g.sum("encounters"), g.sum("touched_moving"), g.sum("touched_at_rest"));
  }
  return lines;
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

Tables encounter_tables() { return {columns_of_encounters(), encounter_summary, encounter_ranking, encounter_digest}; }

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
  return {run.id,
          scenery.world,
          scenery.klass,
          run.condition,
          to_string(plan.settings[run.setting]),
          std::to_string(scenery.seed),
          number(scenery.release),
          drive::to_string(r.ending),
          success ? "1" : "0",
          std::to_string(p.contacts_moving),
          std::to_string(p.contacts_at_rest),
          std::to_string(r.contacts),
          r.arrived || r.ending == drive::Ending::contact ? "0" : "1",
          number(r.duration),
          number(r.length),
          std::to_string(leapt),
          std::to_string(moved_into),
          std::to_string(p.encounters),
          number(std::min(kNobody, p.closest)),
          number(p.personal_space),
          number(p.standing),
          number(r.clearance),
          number(r.operator_active),
          std::to_string(r.interventions),
          number(r.agreement),
          std::to_string(r.failures),
          std::to_string(r.brakes),
          words_of(p.touches)};
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
