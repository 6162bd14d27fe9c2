// SPDX-License-Identifier: BSD-3-Clause
// hidwa_attack: a hostile campaign against the planner's library. See docs/evidence/attack.md.
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <stdexcept>

#include "campaign.hpp"
#include "drive.hpp"
#include "report.hpp"

namespace hidwa_attack {
namespace {

constexpr const char* kHelp =
    "hidwa_attack [--condition NAME[,NAME...]] [--drives N] [--seconds N] [--first-seed N] [--jobs N] [--out DIR]\n"
    "hidwa_attack --condition NAME --seed N [--seconds N] [--trace FILE.csv]   one drive alone\n"
    "hidwa_attack --list                                                       the conditions\n"
    "exit status: 0 the planner held under every promised condition; 1 it did not; 2 wrong arguments\n";

using Options = std::map<std::string, std::string>;

Options read(int count, char** words) {
  Options options;
  for (int k = 1; k < count; ++k) {
    const std::string word = words[k];
    const bool alone = word == "--list" || word == "--help";
    const char* known[] = {"--condition", "--drives", "--seconds", "--first-seed",
                           "--jobs",      "--out",    "--seed",    "--trace"};
    bool takes = false;
    for (const char* name : known) takes = takes || word == name;
    if (!alone && !takes) throw std::invalid_argument("unknown option " + word);
    if (takes && k + 1 >= count) throw std::invalid_argument(word + " needs a value");
    options[word] = alone ? "" : words[++k];
  }
  return options;
}

long whole(const Options& options, const char* name, long fallback, long least) {
  const auto found = options.find(name);
  if (found == options.end()) return fallback;
  char* end = nullptr;
  const long value = std::strtol(found->second.c_str(), &end, 10);
  if (*end != '\0' || end == found->second.c_str() || value < least) {
    throw std::invalid_argument(std::string(name) + ": '" + found->second + "' is no whole number of at least " +
                                std::to_string(least));
  }
  return value;
}

std::vector<const Condition*> chosen(const Options& options) {
  std::vector<const Condition*> conditions;
  const auto found = options.find("--condition");
  if (found == options.end()) {
    for (const Condition& condition : all_conditions()) conditions.push_back(&condition);
    return conditions;
  }
  std::string names = found->second + ",";
  for (std::size_t comma = names.find(','); comma != std::string::npos; comma = names.find(',')) {
    const std::string name = names.substr(0, comma);
    names.erase(0, comma + 1);
    const Condition* condition = find_condition(name);
    if (condition == nullptr) throw std::invalid_argument("no condition '" + name + "'; --list names them");
    conditions.push_back(condition);
  }
  return conditions;
}

int list() {
  for (const Condition& c : all_conditions())
    std::printf("%-28s %s%s\n", c.name, c.promised ? "" : "(outside the promise) ", c.what);
  return 0;
}

int drive_one(const Condition& condition, const Options& options) {
  const auto seed = static_cast<std::uint64_t>(whole(options, "--seed", 1, 0));
  const Spec spec = spec_of(condition, seed, static_cast<int>(whole(options, "--seconds", 20, 1)));
  std::ofstream trace;
  const auto file = options.find("--trace");
  if (file != options.end()) trace.open(file->second);
  if (file != options.end() && !trace) throw std::invalid_argument("cannot write " + file->second);
  trace.precision(9);
  const DriveResult result = drive(spec, seed, trace.is_open() ? &trace : nullptr);
  const Summary summary(condition, {result});
  std::printf("%s %s of %.3f m cells, %.0f Hz, latency %d ms (told %.0f), limits %.2f m/s, %.2f rad/s\n",
              name_of(spec.outline), name_of(spec.place), spec.resolution, 1000.0 / spec.period, spec.latency,
              1e3 * spec.parameters.control_latency, spec.parameters.max_vel_x, spec.parameters.max_vel_theta);
  std::printf("%s%s", table_head().c_str(), table_line(summary).c_str());
  if (result.touched_at >= 0) std::printf("first touch at %.3f s\n", 1e-3 * result.touched_at);
  return summary.promised && !summary.held() ? 1 : 0;
}

void write(const std::string& path, const std::string& content) {
  std::ofstream out(path);
  out << content;
  if (!out.flush()) throw std::invalid_argument("cannot write " + path);
}

int attack(const std::vector<const Condition*>& conditions, const Options& options) {
  Extent extent;
  extent.drives = static_cast<int>(whole(options, "--drives", 300, 1));
  extent.seconds = static_cast<int>(whole(options, "--seconds", 20, 1));
  extent.first_seed = static_cast<std::uint64_t>(whole(options, "--first-seed", 1, 0));
  extent.threads = static_cast<int>(whole(options, "--jobs", 1, 1));
  const auto out = options.find("--out");
  if (out != options.end()) std::filesystem::create_directories(out->second);
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
  if (out == options.end()) return status;
  write(out->second + "/summary.json", as_json(summaries, extent.seconds));
  write(out->second + "/drives.csv", drives);
  return status;
}

int main_with(const Options& options) {
  if (options.count("--help") != 0) {
    std::printf("%s", kHelp);
    return 0;
  }
  if (options.count("--list") != 0) return list();
  const std::vector<const Condition*> conditions = chosen(options);
  if (options.count("--seed") == 0) return attack(conditions, options);
  if (conditions.size() != 1) throw std::invalid_argument("--seed needs one --condition");
  return drive_one(*conditions.front(), options);
}

}  // namespace
}  // namespace hidwa_attack

int main(int count, char** words) {
  try {
    return hidwa_attack::main_with(hidwa_attack::read(count, words));
  } catch (const std::exception& fault) {
    std::fprintf(stderr, "hidwa_attack: %s\n%s", fault.what(), hidwa_attack::kHelp);
    return 2;
  }
}
