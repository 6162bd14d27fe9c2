// SPDX-License-Identifier: BSD-3-Clause
// hidwa_benchmark: how long a cycle takes, by the candidate, the map, the robot and the room it has, and how
// much faster than real time whole drives run. Google Benchmark's options, and --quick for a tenth of the cycles.
// scripts/bench runs it and reads its output.
#include <algorithm>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include "benchmark/cases.hpp"

int main(int argc, char** argv) {
  using hidwa_local_planner::test::Effort;
  std::vector<char*> arguments(argv, argv + argc);
  const auto asks = [](const char* argument) { return std::string(argument) == "--quick"; };
  const auto kept = std::remove_if(arguments.begin() + 1, arguments.end(), asks);
  const bool quick = kept != arguments.end();
  arguments.erase(kept, arguments.end());

  // A case decides itself how many cycles it needs: one call of it is enough.
  std::string once = "--benchmark_min_time=0";
  arguments.insert(arguments.begin() + 1, once.data());
  int count = static_cast<int>(arguments.size());
  benchmark::Initialize(&count, arguments.data());
  if (benchmark::ReportUnrecognizedArguments(count, arguments.data())) return 1;

  const Effort cycles = quick ? Effort{200, 64, 6.0} : Effort{};
  const Effort naive_cycles = quick ? Effort{64, 64, 60.0} : Effort{256, 64, 60.0};
  hidwa_local_planner::test::register_cycles(cycles);
  hidwa_local_planner::test::register_naive_cycles(naive_cycles);
  hidwa_local_planner::test::register_drives(cycles);
  hidwa_local_planner::test::register_samples(cycles);
  if (benchmark::RunSpecifiedBenchmarks() == 0) return 1;  // nothing is named so
  return 0;
}
