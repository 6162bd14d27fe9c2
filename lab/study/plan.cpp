// SPDX-License-Identifier: BSD-3-Clause
#include "study/plan.hpp"

#include <algorithm>
#include <numeric>
#include <sstream>
#include <stdexcept>

#include "core/util/words.hpp"

namespace hidwa_local_planner {
namespace study {
namespace {

// Which of a participant's conditions it is, from 0.
int place_of_condition(const std::string& condition, const std::vector<std::string>& conditions, int participant) {
  std::vector<std::string> order;
  const bool sj_first = participant % 2 == 1;
  for (const std::string& name :
       {std::string(sj_first ? "SJ" : "SW"), std::string(sj_first ? "SW" : "SJ"), std::string("SG")}) {
    if (std::count(conditions.begin(), conditions.end(), name) > 0) order.push_back(name);
  }
  return static_cast<int>(std::find(order.begin(), order.end(), condition) - order.begin());
}

// Williams (1949): the first row is 0, 1, n-1, 2, n-2, ...; each further one is that plus 1, modulo n.
int place_of_setting(std::size_t setting, std::size_t settings, int participant) {
  const std::size_t row = static_cast<std::size_t>(participant - 1) % settings;
  for (std::size_t place = 0; place < settings; ++place) {
    const std::size_t first = place % 2 == 1 ? (place + 1) / 2 : (settings - place / 2) % settings;
    if ((first + row) % settings == setting) return static_cast<int>(place);
  }
  return 0;
}

const char* const kHeader = "id,participant,condition,order,setting";

Setting setting_of(const std::string& text) {
  Setting setting;
  if (text == "default") return setting;
  for (const std::string& part : split(text, ';')) setting.push_back(parse_assignment(part));
  return setting;
}

Run run_of(const std::vector<std::string>& cells) {
  const std::size_t at = cells[0].rfind("-S");
  if (at == std::string::npos) throw std::invalid_argument("'" + cells[0] + "' is no run");
  Run run;
  run.id = cells[0];
  run.participant = std::stoi(cells[1]);
  run.condition = cells[2];
  run.order = std::stoi(cells[3]);
  run.setting = std::stoul(cells[0].substr(at + 2)) - 1;
  return run;
}

std::string id_of(const std::string& experiment, const Run& run) {
  return experiment + format("-P%04d-%s-S%05zu", run.participant, run.condition.c_str(), run.setting + 1);
}

}  // namespace

Plan make_plan(const std::string& experiment, int participants, const std::vector<std::string>& conditions,
               const std::vector<Setting>& settings, bool balanced) {
  std::vector<int> numbers(static_cast<std::size_t>(participants));
  std::iota(numbers.begin(), numbers.end(), 1);
  Plan plan = make_world_plan(experiment, numbers, conditions, settings);
  for (Run& run : plan.runs) {
    const int turn =
        balanced ? place_of_setting(run.setting, settings.size(), run.participant) : static_cast<int>(run.setting);
    const int place = place_of_condition(run.condition, conditions, run.participant);
    run.order = turn * static_cast<int>(conditions.size()) + place + 1;
  }
  return plan;
}

Plan make_world_plan(const std::string& experiment, const std::vector<int>& worlds,
                     const std::vector<std::string>& modes, const std::vector<Setting>& settings) {
  Plan plan{experiment, settings, {}};
  for (const int world : worlds) {
    for (std::size_t setting = 0; setting < settings.size(); ++setting) {
      for (const std::string& mode : modes) {
        Run run;
        run.participant = world;
        run.condition = mode;
        run.order = 1;
        run.setting = setting;
        run.id = id_of(plan.experiment, run);
        plan.runs.push_back(run);
      }
    }
  }
  std::sort(plan.runs.begin(), plan.runs.end(), [](const Run& a, const Run& b) { return a.id < b.id; });
  return plan;
}

std::vector<Setting> pilot_settings() {
  const auto combination = [](const char* s_v, const char* s_omega, const char* delta) {
    return Setting{{"s_v", s_v}, {"s_omega", s_omega}, {"delta", delta}};
  };
  return {combination("200", "400", "2"), combination("400", "800", "2"), combination("200", "400", "1"),
          combination("400", "800", "1")};
}

std::vector<Run> shard(const std::vector<Run>& runs, std::size_t k, std::size_t n) {
  std::vector<Run> part;
  for (std::size_t i = k - 1; i < runs.size(); i += n) part.push_back(runs[i]);
  return part;
}

std::string to_csv(const Plan& plan) {
  std::string csv = std::string(kHeader) + '\n';
  for (const Run& run : plan.runs) {
    csv += run.id + ',' + std::to_string(run.participant) + ',' + run.condition + ',' + std::to_string(run.order) +
           ',' + to_string(plan.settings[run.setting]) + '\n';
  }
  return csv;
}

Plan plan_from_csv(const std::string& csv) {
  Plan plan;
  std::istringstream lines(csv);
  std::string line;
  if (!std::getline(lines, line) || line != kHeader) throw std::invalid_argument("it is no plan of a study");
  while (std::getline(lines, line)) {
    const std::vector<std::string> cells = split(line, ',');
    if (cells.size() != 5) throw std::invalid_argument("'" + line + "' is no line of a plan");
    const Run run = run_of(cells);
    if (run.setting >= 100000) throw std::invalid_argument("'" + run.id + "' is no run");
    if (plan.settings.size() <= run.setting) plan.settings.resize(run.setting + 1);
    plan.settings[run.setting] = setting_of(cells[4]);
    plan.experiment = run.id.substr(0, run.id.find("-P"));
    plan.runs.push_back(run);
  }
  return plan;
}

}  // namespace study
}  // namespace hidwa_local_planner
