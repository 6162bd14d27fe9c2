// SPDX-License-Identifier: BSD-3-Clause
// hidwa_replay: repeats the cycles recorded in a bag; hidwa_replay --help.
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <optional>
#include <system_error>

#include "cycle_bag.hpp"
#include "explanation.hpp"
#include "options.hpp"
#include "picture.hpp"
#include "ros/critic_loading.hpp"
#include "ros/parameter_set.hpp"
#include "what_if.hpp"
#include "words.hpp"

namespace hidwa_local_planner {
namespace replay {
namespace {

using record::CycleReplay;

Planner::SourceFor sources_of(const std::string& critics) {
  return [set = with_foreign_content(critics)](const std::string& critic) { return set.source_for(critic); };
}

CycleReplay make_replay(const Options& options) {
  return CycleReplay(registry_with_plugins(), sources_of, options.changes);
}

void make_folder(const std::string& folder) {
  std::error_code fault;
  std::filesystem::create_directories(folder, fault);
  if (fault) throw UsageError(folder + " cannot be made: " + fault.message());
}

/// What became of the records that could not be repeated.
struct Left {
  long without = 0;  // messages without a record
  long waited = 0;   // before the first key record, or after a gap
  long damaged = 0;
  double bytes = 0.0;  // of all records
  std::string fault;   // of the first damaged one: where it is of another format, a key record names the release

  std::string in_words() const {
    std::string text;
    if (without > 0) text += format("%ld cycles hold no record (record_cycles was false)\n", without);
    if (waited > 0) text += format("%ld records lie between a gap and the next key record: not repeated\n", waited);
    return text;
  }
};

/// Goes through all records of a bag; `call` gets each that can be repeated, until it returns false.
template <typename Call>
Left for_each_record(CycleBag& bag, CycleReplay& replay, const Call& call) {
  Left left;
  Bytes bytes;
  bag.for_each([&](const Cycle& message) {
    if (message.record.empty()) {
      ++left.without;
      return true;
    }
    bytes.assign(message.record.begin(), message.record.end());
    left.bytes += static_cast<double>(bytes.size());
    switch (replay.take(bytes)) {
      case CycleReplay::Reading::ready:
        return call();
      case CycleReplay::Reading::waits_for_key:
        ++left.waited;
        break;
      case CycleReplay::Reading::damaged:
        if (left.damaged++ == 0) left.fault = replay.fault();
        break;
    }
    return true;
  });
  return left;
}

void say(const std::string& fault) { std::fprintf(stderr, "hidwa_replay: %s\n", fault.c_str()); }

// The status to end with: what is wrong with the bag goes before differences.
int conclude(const CycleBag& bag, const Left& left, long cycles, long differences) {
  std::fputs(left.in_words().c_str(), stdout);
  std::printf("%ld cycles, %ld differences\n", cycles, differences);
  std::fflush(stdout);
  if (!bag.fault().empty()) say(bag.fault() + format("; its intact part was replayed, %ld cycles", cycles));
  if (left.damaged > 0) say(format("%ld records cannot be repeated: ", left.damaged) + left.fault);
  if (!bag.fault().empty() || left.damaged > 0) return 2;
  if (cycles == 0) {
    say("no cycle could be repeated: record with record_cycles: true");
    return 2;
  }
  return differences > 0 ? 1 : 0;
}

int replay_all(const Options& options) {
  CycleBag bag(options.bag, options.topic);
  CycleReplay replay = make_replay(options);
  const bool changes = !options.changes.empty();
  if (changes) make_folder(options.out);
  const std::string csv = changes ? options.out + "/changes.csv" : "";
  WhatIf what_if(csv);
  std::printf("%s: %s\n", options.bag.c_str(), bag.topic().c_str());
  if (changes) {
    std::string named;
    for (const auto& [name, value] : options.changes) named += " " + name + "=" + value;
    std::printf("with%s, each cycle from its recorded state (open loop: the robot's way stays the recorded one)\n",
                named.c_str());
  }
  const auto begin = std::chrono::steady_clock::now();
  std::optional<double> first;
  double last = 0.0;
  long cycles = 0;
  const Left left = for_each_record(bag, replay, [&] {
    last = replay.record().time();
    if (!first) first = last;
    what_if.add(last - *first, replay.record(), replay.run());
    ++cycles;
    return true;
  });
  const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - begin;
  what_if.close();
  if (!what_if.summary().empty()) std::puts(what_if.summary().c_str());
  if (changes && options.picture && cycles > 0) {
    const std::string fault = draw("changes", csv, options.out + "/changes.png");
    if (!fault.empty()) say(fault);
  }
  if (changes) std::printf("%s\n", csv.c_str());
  const double recorded = first ? last - *first : 0.0;
  if (recorded > 0.0) std::printf("%.0f bytes of records, %.1f kB/s\n", left.bytes, left.bytes / recorded / 1e3);
  std::printf("%.1f s replayed in %.2f s, %.0f times faster than real time\n", recorded, spent.count(),
              recorded / spent.count());
  return conclude(bag, left, cycles, what_if.differences());
}

// Of the record that is asked for, ROS time [s].
double find_time(const Options& options) {
  CycleBag bag(options.bag, options.topic);
  CycleReplay replay = make_replay(options);
  MomentSearch search(*options.at);
  for_each_record(bag, replay, [&] {
    search.see(replay.record().time());
    return true;
  });
  const std::optional<double> time = search.found();
  if (!time) throw UsageError(options.bag + ": " + search.remark());
  if (!search.remark().empty()) std::printf("%s\n", search.remark().c_str());
  return *time;
}

int explain_one(const Options& options) {
  const double time = find_time(options);
  CycleBag bag(options.bag, options.topic);
  CycleReplay replay = make_replay(options);
  std::optional<double> first;
  bool identical = false;
  const Left left = for_each_record(bag, replay, [&] {
    if (!first) first = replay.record().time();
    if (replay.record().time() != time) return true;
    const record::ReplayedCycle cycle = replay.run(true);
    identical = cycle.identical;
    std::fputs(explain(time - *first, replay, cycle).c_str(), stdout);
    make_folder(options.out);
    const std::string data = options.out + "/cycle.json";
    std::ofstream(data) << explain_as_json(time - *first, replay, cycle);
    const std::string fault = options.picture ? draw("cycle", data, options.out + "/cycle.png") : "";
    if (!fault.empty()) say(fault);
    std::printf("%s\n", (options.out + (options.picture && fault.empty() ? "/cycle.png" : "/cycle.json")).c_str());
    return false;
  });
  return conclude(bag, Left{0, 0, left.damaged, 0.0, left.fault}, 1, identical ? 0 : 1);
}

int run(const Options& options) {
  if (options.help) {
    std::fputs(help(), stdout);
    return 0;
  }
  return options.at ? explain_one(options) : replay_all(options);
}

}  // namespace
}  // namespace replay
}  // namespace hidwa_local_planner

int main(int argc, char** argv) {
  using namespace hidwa_local_planner::replay;
  try {
    return run(parse(std::vector<std::string>(argv + 1, argv + argc)));
  } catch (const std::exception& error) {
    std::fflush(stdout);
    say(error.what());
    return 2;
  }
}
