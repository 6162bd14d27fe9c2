// SPDX-License-Identifier: BSD-3-Clause
#include "ways/report.hpp"

#include "core/util/words.hpp"

namespace hidwa_ways {
namespace {

using hidwa_local_planner::format;

// "97.3 %" of those; "-" where there are none.
std::string share(int part, int whole) { return whole == 0 ? "-" : format("%.1f %%", 100.0 * part / whole); }

std::string quoted(const std::string& words) {
  std::string line = "\"";
  for (const char c : words) line += c == '"' || c == '\\' ? std::string("\\") + c : std::string(1, c);
  return line + "\"";
}

}  // namespace

std::string table(const std::vector<Summary>& summaries) {
  std::string lines = format("%-10s %-15s %7s %6s %8s %8s %6s %9s %6s %8s %9s %9s\n", "kind", "outline", "scenes",
                             "sure", "nearer", "through", "none", "says so", "open", "through", "contacts", "cycle ms");
  for (const Summary& s : summaries)
    lines += format("%-10s %-15s %7d %6d %8s %8s %6d %9s %6d %8s %9d %9.1f\n", s.kind.c_str(), s.body.c_str(), s.scenes,
                    s.sure, share(s.nearer, s.sure).c_str(), share(s.through, s.sure).c_str(), s.none,
                    share(s.failed, s.none).c_str(), s.open, share(s.open_through, s.open).c_str(), s.contacts,
                    1e3 * s.worst_cycle);
  return lines;
}

std::string in_words(const Result& r) {
  std::string line = format("%s %s%s, %.3f m cells: %s", r.kind.c_str(), r.body.c_str(),
                            r.reverse ? " with reverse" : "", r.resolution, to_string(r.answer));
  if (r.answer == Class::sure)
    line += format(" (a way of %.2f m, %.1f s%s); nearer at %.2f s (limit %.2f s)", r.way_length, r.way_time,
                   r.verified ? "" : ", NOT VERIFIED", r.nearer_at, r.nearer_limit);
  line += format("; through at %.2f s (limit %.1f s)", r.through_at, r.through_limit);
  if (r.failed_at >= 0.0) line += format("; failed at %.2f s: ", r.failed_at) + r.problem;
  if (r.touched) line += format("; TOUCHED by %.2f mm", 1e3 * r.depth);
  return line;
}

std::string failures(const std::vector<Result>& results) {
  std::string lines;
  for (const Result& r : results) {
    if (!r.good()) lines += "  " + r.repeat + "   # " + in_words(r) + "\n";
  }
  return lines;
}

std::string scenes_csv(const std::vector<Result>& results) {
  std::string lines =
      "kind,seed,outline,reverse,resolution,class,verified,way_m,way_s,nearer_at,nearer_limit,through_at,through_limit,"
      "failed_at,failed_late,touched,depth_mm,cycles,worst_cycle_ms,good,problem\n";
  for (const Result& r : results) {
    lines += format("%s,%llu,%s,%d,%.3f,%s,%d,%.3f,%.3f,%.2f,%.2f,", r.kind.c_str(),
                    static_cast<unsigned long long>(r.seed), r.body.c_str(), r.reverse, r.resolution,
                    to_string(r.answer), r.verified, r.way_length, r.way_time, r.nearer_at, r.nearer_limit) +
             format("%.2f,%.2f,%.2f,%d,%d,%.4f,%d,%.3f,%d,", r.through_at, r.through_limit, r.failed_at, r.failed_late,
                    r.touched, 1e3 * r.depth, r.cycles, 1e3 * r.worst_cycle, r.good()) +
             quoted(r.problem) + "\n";
  }
  return lines;
}

}  // namespace hidwa_ways
