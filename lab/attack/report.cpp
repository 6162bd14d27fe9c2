// SPDX-License-Identifier: BSD-3-Clause
#include "report.hpp"

#include <nlohmann/json.hpp>

#include "core/util/words.hpp"

namespace hidwa_attack {
namespace {

using hidwa_local_planner::format;

unsigned long long number(std::uint64_t seed) { return seed; }

std::string verdict(const Summary& s) {
  if (!s.promised) return "outside";
  return s.held() ? "held" : "FOUND";
}

std::string in_collision(const Summary& s) {
  if (s.stood_in == 0) return "";
  return format(
      "   in collision: %d came out of %d; %d entered cells, %d too fast, total depth grew %.2f mm, neighbour %.2f mm "
      "too deep",
      s.came_out, s.stood_in, s.entered, s.too_fast, 1e3 * s.worst_growth, 1e3 * s.worst_excess);
}

std::string repeat(const Summary& s, std::uint64_t seed, int seconds) {
  return format("  hidwa_attack --condition %s --seed %llu --seconds %d --trace drive.csv\n", s.condition.c_str(),
                number(seed), seconds);
}

nlohmann::json json_of(const Summary& s) {
  return {{"condition", s.condition},
          {"promised", s.promised},
          {"held", s.held()},
          {"drives", s.drives},
          {"cycles", s.cycles},
          {"contacts", s.contacts},
          {"worst_mm", 1e3 * s.worst_depth},
          {"worst_seed", s.worst_seed},
          {"beyond", s.beyond},
          {"beyond_v", s.beyond_v},
          {"beyond_omega", s.beyond_omega},
          {"beyond_seed", s.beyond_seed},
          {"hard", s.hard},
          {"moving", s.moving},
          {"threatened", s.threatened},
          {"stood_in", s.stood_in},
          {"came_out", s.came_out},
          {"entered", s.entered},
          {"too_fast", s.too_fast},
          {"growth_mm", 1e3 * s.worst_growth},
          {"neighbour_mm", 1e3 * s.worst_excess},
          {"found", s.found}};
}

}  // namespace

std::string table_head() {
  return format("%-28s %-8s %6s %8s %8s %9s %8s %9s %9s %7s %10s\n", "condition", "", "drives", "cycles", "contacts",
                "worst mm", "beyond", "m/s", "rad/s", "moving", "threatened");
}

std::string table_line(const Summary& s) {
  return format("%-28s %-8s %6d %8d %8d %9.2f %8d %9.3f %9.3f %6.0f%% %10d", s.condition.c_str(), verdict(s).c_str(),
                s.drives, s.cycles, s.contacts, 1e3 * s.worst_depth, s.beyond, s.beyond_v, s.beyond_omega,
                100.0 * s.moving, s.threatened) +
         in_collision(s) + "\n";
}

std::string how_to_repeat(const Summary& s, int seconds) {
  std::string lines;
  if (s.contacts > 0) lines += repeat(s, s.worst_seed, seconds);
  if (s.beyond > 0 && (s.contacts == 0 || s.beyond_seed != s.worst_seed)) lines += repeat(s, s.beyond_seed, seconds);
  if (lines.empty() && !s.found.empty()) lines += repeat(s, s.found.front(), seconds);
  return lines;
}

std::string as_json(const std::vector<Summary>& summaries, int seconds) {
  nlohmann::json conditions = nlohmann::json::array();
  for (const Summary& summary : summaries) conditions.push_back(json_of(summary));
  return nlohmann::json({{"seconds", seconds}, {"conditions", conditions}}).dump(2) + '\n';
}

std::string drives_head() {
  return "condition,seed,cycles,moving,threatened,touched,depth_mm,touched_at_s,beyond,beyond_v,beyond_omega,stood_in,"
         "came_out,entered,"
         "neighbour_mm,growth_mm,fastest_inside,speed_bound\n";
}

std::string drive_line(const Summary& s, const DriveResult& r) {
  return format("%s,%llu,%d,%d,%d,%d,%.4f,%.3f,%d,%.4f,%.4f,", s.condition.c_str(), number(r.seed), r.cycles, r.moving,
                r.threatened, r.touched ? 1 : 0, 1e3 * r.depth, 1e-3 * r.touched_at, r.beyond, r.beyond_worst.v,
                r.beyond_worst.omega) +
         format("%d,%d,%d,%.4f,%.4f,%.4f,%.4f\n", r.stood_in ? 1 : 0, r.came_out ? 1 : 0, r.entered, 1e3 * r.excess,
                1e3 * r.growth, r.fastest_inside, r.speed_bound);
}

}  // namespace hidwa_attack
