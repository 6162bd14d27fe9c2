// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <exception>
#include <optional>
#include <string>

#include <benchmark/benchmark.h>

#include "benchmark/cases.hpp"
#include "benchmark/cycle_case.hpp"
#include "benchmark/cycle_times.hpp"
#include "benchmark/naive_cycle.hpp"
#include "support/naive_planner.hpp"

namespace hidwa_local_planner::test {
namespace {

void report(benchmark::State& state, const CycleTimes& times, const CycleCase::Size& size) {
  times.report(state, size.candidates, size.poses);
}

void run_cycle(benchmark::State& state, const Effort& effort, CycleCase& cycles) {
  CycleTimes times;
  times.measure(state, effort, cycles.size(), [&](std::size_t k) { benchmark::DoNotOptimize(&cycles.plan(k)); });
  report(state, times, cycles.measure());
  state.counters["legal"] = cycles.legal_part();
}

void run_watched_cycle(benchmark::State& state, const Effort& effort, CycleCase& cycles) {
  cycles.watch();
  run_cycle(state, effort, cycles);
}

constexpr std::size_t kPeople = 20;

void run_cycle_among(benchmark::State& state, const Effort& effort, CycleCase& cycles) {
  cycles.add_people(kPeople);
  run_cycle(state, effort, cycles);
}

void run_autonomy(benchmark::State& state, const Effort& effort, CycleCase& cycles) {
  cycles.let_drive();
  run_cycle(state, effort, cycles);
}

void run_autonomy_among(benchmark::State& state, const Effort& effort, CycleCase& cycles) {
  cycles.let_drive();
  run_cycle_among(state, effort, cycles);
}

void run_cached_cycle(benchmark::State& state, const Effort& effort, CycleCase& cycles) {
  CycleTimes times;
  times.measure(state, effort, cycles.size(), [&](std::size_t /*k*/) { benchmark::DoNotOptimize(&cycles.plan(0)); });
  report(state, times, cycles.measure());
}

// The part of the situations in which both choose the same.
double agreement(CycleCase& cycles, const NaiveBody& body) {
  double agreeing = 0.0;
  for (std::size_t k = 0; k < cycles.size(); ++k) {
    const std::optional<NaiveChoice> naive = naive_cycle(cycles.scene(k), body);
    const Decision& decision = cycles.plan(k);
    const bool chosen = decision.outcome == Outcome::drive || decision.outcome == Outcome::hold;
    const bool same = chosen && naive && std::abs(naive->sample.v - decision.sample.v) < 1e-9 &&
                      std::abs(naive->sample.omega - decision.sample.omega) < 1e-9;
    if (same || (!chosen && !naive)) agreeing += 1.0;
  }
  return agreeing / static_cast<double>(cycles.size());
}

void run_naive_cycle(benchmark::State& state, const Effort& effort, CycleCase& cycles) {
  const NaiveBody body = naive_body(cycles.scene(0));
  CycleTimes times;
  times.measure(state, effort, cycles.size(),
                [&](std::size_t k) { benchmark::DoNotOptimize(naive_cycle(cycles.scene(k), body)); });
  report(state, times, cycles.measure());
  state.counters["agreeing"] = agreement(cycles, body);
}

using Run = void (*)(benchmark::State&, const Effort&, CycleCase&);

void add(const char* kind, Run run, const Effort& effort, const char* load_name, const Setting& setting) {
  const std::string name = std::string(kind) + "/" + load_name + "/" + std::to_string(setting.cells) + "/" +
                           to_string(setting.body) + "/" + to_string(setting.ground);
  const auto body = [=](benchmark::State& state) {
    try {
      CycleCase cycles(load(load_name), setting);
      run(state, effort, cycles);
    } catch (const std::exception& fault) {
      state.SkipWithError(fault.what());
    }
  };
  benchmark::RegisterBenchmark(name.c_str(), body)->Unit(benchmark::kMicrosecond);
}

// Every map, body and ground.
void add_all(const char* kind, Run run, const Effort& effort, const char* load_name) {
  for (const int cells : {120, 200}) {
    for (const Body body : {Body::circle, Body::polygon}) {
      for (const Ground ground : {Ground::open, Ground::tight}) {
        add(kind, run, effort, load_name, {cells, body, ground});
      }
    }
  }
}

void add_long_rollouts(const char* kind, Run run, const Effort& effort) {
  for (const Ground ground : {Ground::open, Ground::tight}) {
    add(kind, run, effort, "2000x56", {200, Body::polygon, ground});
  }
}

}  // namespace

void register_cycles(const Effort& effort) {
  for (const char* load_name : {"419", "819", "2000", "10000", "100000"}) {
    add_all("cycle", run_cycle, effort, load_name);
  }
  add_long_rollouts("cycle", run_cycle, effort);
  add_all("cycle", run_cycle, effort, "2400");
  add_all("cycle_among", run_cycle_among, effort, "2400");
  add_all("autonomy", run_autonomy, effort, "2400");
  add_all("autonomy_among", run_autonomy_among, effort, "2400");
  for (const char* load_name : {"2000", "100000"}) add_all("cycle_cached", run_cached_cycle, effort, load_name);
  for (const char* load_name : {"819", "2000"}) add_all("cycle_watched", run_watched_cycle, effort, load_name);
}

void register_naive_cycles(const Effort& effort) {
  for (const char* load_name : {"419", "819", "2000"}) add_all("naive_cycle", run_naive_cycle, effort, load_name);
  add_long_rollouts("naive_cycle", run_naive_cycle, effort);
}

}  // namespace hidwa_local_planner::test
