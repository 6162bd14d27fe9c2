// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include <benchmark/benchmark.h>

#include "support/allocation_counter.hpp"

namespace hidwa_local_planner::test {

/// How many cycles a case is worth: `cycles`, but `few` where so many would take more than `seconds`.
struct Effort {
  std::size_t cycles = 2000;
  std::size_t few = 200;
  double seconds = 60.0;
};

/// A moment, by the wall and by the time this thread has had.
struct Moment {
  double wall = 0.0;  // [us]
  double cpu = 0.0;   // [us]
  static Moment now();
};

/// The value that `part` of the values do not exceed.
double quantile(std::vector<double> values, double part);

/// Single cycles, each timed by itself: by the wall clock, which on a shared machine also counts the others'
/// work, and by the thread's own time.
class CycleTimes {
 public:
  /// Times cycle(k) for k = 0, 1, ... after two rounds of k < `round`: one warms up and tells how long a
  /// cycle takes, one counts allocations.
  template <typename Cycle>
  void measure(benchmark::State& state, const Effort& effort, std::size_t round, const Cycle& cycle) {
    for (std::size_t k = 0; k < round; ++k) time(cycle, k);
    count_allocations(round, cycle);
    const std::size_t count = worth(effort);
    while (state.KeepRunningBatch(static_cast<benchmark::IterationCount>(count))) {
      for (std::size_t k = 0; k < count; ++k) time(cycle, k);
    }
  }

  /// p50_us, p99_us, p50_cpu_us, p99_cpu_us, allocations a cycle, and ns_per_pose by the thread's time.
  void report(benchmark::State& state, std::size_t candidates, std::size_t poses) const;

 private:
  template <typename Cycle>
  void time(const Cycle& cycle, std::size_t k) {
    const Moment begin = Moment::now();
    cycle(k);
    const Moment end = Moment::now();
    wall_.push_back(end.wall - begin.wall);
    cpu_.push_back(end.cpu - begin.cpu);
  }
  template <typename Cycle>
  void count_allocations(std::size_t round, const Cycle& cycle) {
    std::size_t count = 0;
    for (std::size_t k = 0; k < round; ++k) {
      const AllocationCounter counter;
      cycle(k);
      count += counter.count();
    }
    allocations_ = static_cast<double>(count) / static_cast<double>(round);
  }
  // Forgets the warm-up.
  std::size_t worth(const Effort& effort);

  std::vector<double> wall_, cpu_;  // [us]
  double allocations_ = 0.0;
};

}  // namespace hidwa_local_planner::test
