// SPDX-License-Identifier: BSD-3-Clause
#include "benchmark/cycle_times.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <numeric>

namespace hidwa_local_planner::test {
namespace {

double microseconds(clockid_t clock) {
  timespec time{};
  clock_gettime(clock, &time);
  return 1e6 * static_cast<double>(time.tv_sec) + 1e-3 * static_cast<double>(time.tv_nsec);
}

}  // namespace

Moment Moment::now() { return {microseconds(CLOCK_MONOTONIC), microseconds(CLOCK_THREAD_CPUTIME_ID)}; }

double quantile(std::vector<double> values, double part) {
  const double rank = std::max(0.0, std::ceil(part * static_cast<double>(values.size())) - 1.0);
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(rank);
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

std::size_t CycleTimes::worth(const Effort& effort) {
  const double mean = std::accumulate(wall_.begin(), wall_.end(), 0.0) / static_cast<double>(wall_.size());
  const double all = static_cast<double>(effort.cycles) * mean * 1e-6;
  const std::size_t count = all <= effort.seconds ? effort.cycles : effort.few;
  for (std::vector<double>* times : {&wall_, &cpu_}) {
    times->clear();
    times->reserve(count);
  }
  return count;
}

void CycleTimes::report(benchmark::State& state, std::size_t candidates, std::size_t poses) const {
  state.counters["p50_us"] = quantile(wall_, 0.5);
  state.counters["p99_us"] = quantile(wall_, 0.99);
  state.counters["p50_cpu_us"] = quantile(cpu_, 0.5);
  state.counters["p99_cpu_us"] = quantile(cpu_, 0.99);
  state.counters["cycles"] = static_cast<double>(wall_.size());
  state.counters["allocations"] = allocations_;
  state.counters["candidates"] = static_cast<double>(candidates);
  state.counters["poses"] = static_cast<double>(poses);
  state.counters["ns_per_pose"] = 1e3 * quantile(cpu_, 0.5) / static_cast<double>(poses);
}

}  // namespace hidwa_local_planner::test
