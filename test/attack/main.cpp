// SPDX-License-Identifier: BSD-3-Clause
// hidwa_attack: a hostile campaign against the planner's library. See docs/evidence/attack.md.
#include <cstdio>
#include <filesystem>
#include <stdexcept>

#include "arguments.hpp"
#include "campaign.hpp"
#include "drive.hpp"
#include "report.hpp"

namespace hidwa_attack {
namespace {

constexpr const char* kHelp =
    "People who want a collision, faulty odometry, late cycles and bases of all kinds.\n"
    "  [--condition NAME[,NAME...]] [--drives N] [--seconds N] [--first-seed N] [--jobs N] [--out DIR]\n"
    "                   every condition, 300 drives of 20 s each; summary.json and drives.csv go to DIR\n"
    "  --condition NAME --seed N [--seconds N] [--trace FILE.csv]\n"
    "                   one drive alone, with what happened every 10 ms\n"
    "  --list           the conditions\n"
    "exit status: 0 the planner held under every promised condition; 1 it did not; 2 something did not run\n";

std::vector<const Condition*> chosen(const Arguments& arguments) {
  std::vector<const Condition*> conditions;
  for (const std::string& name : arguments.list("--condition")) {
    conditions.push_back(find_condition(name));
    if (conditions.back() == nullptr) throw std::invalid_argument("no condition '" + name + "'; --list names them");
  }
  if (!conditions.empty()) return conditions;
  for (const Condition& condition : all_conditions()) conditions.push_back(&condition);
  return conditions;
}

int list() {
  for (const Condition& c : all_conditions())
    std::printf("%-28s %s%s\n", c.name, c.promised ? "" : "(outside the promise) ", c.what);
  return 0;
}

int drive_one(const Condition& condition, const Arguments& arguments) {
  const std::uint64_t seed = arguments.seed("--seed");
  const Spec spec = spec_of(condition, seed, static_cast<int>(arguments.whole("--seconds", 20, 1)));
  std::ofstream trace = arguments.trace();
  const DriveResult result = drive(spec, seed, trace.is_open() ? &trace : nullptr);
  const Summary summary(condition, {result});
  std::printf("%s %s of %.3f m cells, %.0f Hz, latency %d ms (told %.0f), limits %.2f m/s, %.2f rad/s\n",
              name_of(spec.outline), name_of(spec.place), spec.resolution, 1000.0 / spec.period, spec.latency,
              1e3 * spec.parameters.control_latency, spec.parameters.max_vel_x, spec.parameters.max_vel_theta);
  std::printf("%s%s", table_head().c_str(), table_line(summary).c_str());
  if (result.touched_at >= 0) std::printf("first touch at %.3f s\n", 1e-3 * result.touched_at);
  return summary.promised && !summary.held() ? 1 : 0;
}

int attack(const std::vector<const Condition*>& conditions, const Arguments& arguments) {
  Extent extent;
  extent.drives = static_cast<int>(arguments.whole("--drives", 300, 1));
  extent.seconds = static_cast<int>(arguments.whole("--seconds", 20, 1));
  extent.first_seed = arguments.seed("--first-seed");
  extent.threads = static_cast<int>(arguments.whole("--jobs", 1, 1));
  if (arguments.has("--out")) std::filesystem::create_directories(arguments.text("--out"));
  std::vector<Summary> summaries;
  std::string drives = drives_head(), repeats;
  int status = 0;
  std::printf("%s", table_head().c_str());
  for (const Condition* condition : conditions) {
    const std::vector<DriveResult> results = run(*condition, extent);
    summaries.emplace_back(*condition, results);
    const Summary& summary = summaries.back();
    std::printf("%s", table_line(summary).c_str());
    std::fflush(stdout);
    for (const DriveResult& result : results) drives += drive_line(summary, result);
    repeats += how_to_repeat(summary, extent.seconds);
    if (summary.promised && !summary.held()) status = 1;
  }
  if (!repeats.empty()) std::printf("\nthe worst of each, alone:\n%s", repeats.c_str());
  if (!arguments.has("--out")) return status;
  write_file(arguments.text("--out") + "/summary.json", as_json(summaries, extent.seconds));
  write_file(arguments.text("--out") + "/drives.csv", drives);
  return status;
}

int main_with(const Arguments& arguments) {
  if (arguments.has("--help")) {
    std::printf("%s", kHelp);
    return 0;
  }
  if (arguments.has("--list")) return list();
  const std::vector<const Condition*> conditions = chosen(arguments);
  if (!arguments.has("--seed")) return attack(conditions, arguments);
  if (conditions.size() != 1) throw std::invalid_argument("--seed needs one --condition");
  return drive_one(*conditions.front(), arguments);
}

}  // namespace
}  // namespace hidwa_attack

int main(int count, char** words) {
  try {
    return hidwa_attack::main_with(
        {count,
         words,
         {"--condition", "--drives", "--seconds", "--first-seed", "--jobs", "--out", "--seed", "--trace"},
         {"--list", "--help"},
         {{"--seed", "--condition"}, {"--trace", "--seed"}}});
  } catch (const std::exception& fault) {
    std::fprintf(stderr, "hidwa_attack: %s\n%s", fault.what(), hidwa_attack::kHelp);
    return 2;
  }
}
