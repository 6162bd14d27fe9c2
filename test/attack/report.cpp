// SPDX-License-Identifier: BSD-3-Clause
#include "report.hpp"

#include <cstdio>
#include <sstream>

namespace hidwa_attack {
namespace {

template <typename... Values>
std::string text(const char* format, Values... values) {
  char line[600];
  std::snprintf(line, sizeof(line), format, values...);
  return line;
}

unsigned long long number(std::uint64_t seed) { return seed; }

std::string verdict(const Summary& s) {
  if (!s.promised) return "outside";
  return s.held() ? "held" : "FOUND";
}

std::string in_collision(const Summary& s) {
  if (s.stood_in == 0) return "";
  return text(
      "   in collision: %d came out of %d; %d entered cells, %d too fast, total depth grew %.2f mm, neighbour %.2f mm "
      "too deep",
      s.came_out, s.stood_in, s.entered, s.too_fast, 1e3 * s.worst_growth, 1e3 * s.worst_excess);
}

std::string repeat(const Summary& s, std::uint64_t seed, int seconds) {
  return text("  hidwa_attack --condition %s --seed %llu --seconds %d --trace drive.csv\n", s.condition.c_str(),
              number(seed), seconds);
}

std::string object(const Summary& s) {
  std::string found;
  for (const std::uint64_t seed : s.found) found += (found.empty() ? "" : ", ") + std::to_string(seed);
  return text(
             "{\"condition\": \"%s\", \"promised\": %s, \"held\": %s, \"drives\": %d, \"cycles\": %d, \"contacts\": "
             "%d, \"worst_mm\": %.4f, "
             "\"worst_seed\": %llu, ",
             s.condition.c_str(), s.promised ? "true" : "false", s.held() ? "true" : "false", s.drives, s.cycles,
             s.contacts, 1e3 * s.worst_depth, number(s.worst_seed)) +
         text(
             "\"beyond\": %d, \"beyond_v\": %.4f, \"beyond_omega\": %.4f, \"beyond_seed\": %llu, \"moving\": %.4f, "
             "\"threatened\": %d, ",
             s.beyond, s.beyond_v, s.beyond_omega, number(s.beyond_seed), s.moving, s.threatened) +
         text("\"meetings\": %zu, \"met_p10\": %.3f, \"met_p50\": %.3f, \"met_p90\": %.3f, \"met_max\": %.3f, ",
              s.meetings.size(), s.meeting(0.1), s.meeting(0.5), s.meeting(0.9), s.meeting(1.0)) +
         text(
             "\"stood_in\": %d, \"came_out\": %d, \"entered\": %d, \"too_fast\": %d, \"growth_mm\": %.4f, "
             "\"neighbour_mm\": %.4f, ",
             s.stood_in, s.came_out, s.entered, s.too_fast, 1e3 * s.worst_growth, 1e3 * s.worst_excess) +
         "\"found\": [" + found + "]}";
}

}  // namespace

std::string table_head() {
  return text("%-28s %-8s %6s %8s %8s %9s %8s %9s %9s %7s %10s %6s %22s\n", "condition", "", "drives", "cycles",
              "contacts", "worst mm", "beyond", "m/s", "rad/s", "moving", "threatened", "met", "at m/s 10/50/90/100 %");
}

std::string table_line(const Summary& s) {
  return text("%-28s %-8s %6d %8d %8d %9.2f %8d %9.3f %9.3f %6.0f%% %10d %6zu   %.2f %.2f %.2f %.2f",
              s.condition.c_str(), verdict(s).c_str(), s.drives, s.cycles, s.contacts, 1e3 * s.worst_depth, s.beyond,
              s.beyond_v, s.beyond_omega, 100.0 * s.moving, s.threatened, s.meetings.size(), s.meeting(0.1),
              s.meeting(0.5), s.meeting(0.9), s.meeting(1.0)) +
         in_collision(s) + "\n";
}

std::string how_to_repeat(const Summary& s, int seconds) {
  std::string lines;
  if (s.contacts > 0) lines += repeat(s, s.worst_seed, seconds);
  if (s.beyond > 0 && (s.contacts == 0 || s.beyond_seed != s.worst_seed)) lines += repeat(s, s.beyond_seed, seconds);
  return lines;
}

std::string as_json(const std::vector<Summary>& summaries, int seconds) {
  std::ostringstream out;
  out << "{\"seconds\": " << seconds << ", \"conditions\": [\n";
  for (std::size_t k = 0; k < summaries.size(); ++k)
    out << "  " << object(summaries[k]) << (k + 1 < summaries.size() ? ",\n" : "\n");
  out << "]}\n";
  return out.str();
}

std::string drives_head() {
  return "condition,seed,cycles,moving,threatened,touched,depth_mm,touched_at_s,beyond,beyond_v,beyond_omega,stood_in,"
         "came_out,entered,"
         "neighbour_mm,growth_mm,fastest_inside,speed_bound\n";
}

std::string drive_line(const Summary& s, const DriveResult& r) {
  return text("%s,%llu,%d,%d,%d,%d,%.4f,%.3f,%d,%.4f,%.4f,", s.condition.c_str(), number(r.seed), r.cycles, r.moving,
              r.threatened, r.touched ? 1 : 0, 1e3 * r.depth, 1e-3 * r.touched_at, r.beyond, r.beyond_worst.v,
              r.beyond_worst.omega) +
         text("%d,%d,%d,%.4f,%.4f,%.4f,%.4f\n", r.stood_in ? 1 : 0, r.came_out ? 1 : 0, r.entered, 1e3 * r.excess,
              1e3 * r.growth, r.fastest_inside, r.speed_bound);
}

}  // namespace hidwa_attack
