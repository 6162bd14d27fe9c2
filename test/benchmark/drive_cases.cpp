// SPDX-License-Identifier: BSD-3-Clause
// How much faster than real time whole drives run on one core.
#include <exception>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

#include <benchmark/benchmark.h>

#include "benchmark/cases.hpp"
#include "drive/drive.hpp"
#include "sim/avoiding_operator.hpp"
#include "support/office.hpp"

namespace hidwa_local_planner::test {
namespace {

using drive::DriveResult;
using drive::DriveSetup;

struct Work {
  double simulated = 0.0;  // [s]
  double driven = 0.0;     // [m]
  double planning = 0.0;   // [s], wall clock
};

DriveSetup office_drive(bool steered) {
  DriveSetup setup = office(0.0);
  if (steered) {
    setup.person = std::make_shared<sim::AvoidingOperator>(sim::OperatorTraits(), sim::RobotHabits(),
                                                           *setup.ground->map(), setup.regions, 1);
  }
  return setup;
}

void add(const DriveResult& result, Work& work) {
  if (!result.arrived || result.contacts > 0) {
    throw std::runtime_error(std::string("the drive ended otherwise: ") + to_string(result.ending));
  }
  work.simulated += result.duration;
  work.driven += result.length;
  work.planning += result.planning_time;
}

// Everything counts: reading the map, what is worked out of it, and the way there; then back.
void there_and_back(bool steered, Work& work) {
  DriveSetup setup = office_drive(steered);
  add(drive::drive(setup), work);
  std::swap(setup.start, setup.goal);
  setup.start.theta += M_PI;
  setup.goal.theta += M_PI;
  add(drive::drive(setup), work);
}

void run_drive(benchmark::State& state, std::size_t rounds, bool steered) {
  Work work;
  Moment begin, end;
  try {
    there_and_back(steered, work);  // warms up
    work = Work();
    begin = Moment::now();
    while (state.KeepRunningBatch(static_cast<benchmark::IterationCount>(rounds))) {
      for (std::size_t k = 0; k < rounds; ++k) there_and_back(steered, work);
    }
    end = Moment::now();
  } catch (const std::exception& fault) {
    state.SkipWithError(fault.what());
    return;
  }
  state.counters["times_real_time"] = work.simulated / (1e-6 * (end.wall - begin.wall));
  state.counters["times_real_time_cpu"] = work.simulated / (1e-6 * (end.cpu - begin.cpu));
  state.counters["planning"] = work.planning / (1e-6 * (end.wall - begin.wall));
  state.counters["driven_m"] = work.driven;
  state.counters["simulated_s"] = work.simulated;
}

}  // namespace

void register_drives(const Effort& effort) {
  const std::size_t rounds = effort.cycles >= 1000 ? 5 : 1;
  for (const bool steered : {false, true}) {
    const auto run = [rounds, steered](benchmark::State& state) { run_drive(state, rounds, steered); };
    benchmark::RegisterBenchmark(steered ? "drive/office/steered" : "drive/office/alone", run)
        ->Unit(benchmark::kMillisecond);
  }
}

}  // namespace hidwa_local_planner::test
