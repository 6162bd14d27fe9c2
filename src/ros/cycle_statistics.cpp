// SPDX-License-Identifier: BSD-3-Clause
#include "ros/cycle_statistics.hpp"

#include <algorithm>

namespace hidwa_local_planner {

void CycleStatistics::add(double duration, double period) {
  durations_[cycles_ % kWindow] = duration;
  ++cycles_;
  if (duration > period) ++late_;
}

CycleStatistics::Summary CycleStatistics::summary() const {
  Summary summary;
  summary.cycles = cycles_;
  summary.late = late_;
  std::array<double, kWindow> sorted = durations_;
  const std::size_t count = static_cast<std::size_t>(std::min<std::uint64_t>(summary.cycles, kWindow));
  if (count == 0) return summary;
  std::sort(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(count));
  summary.p50 = sorted[(count - 1) / 2];
  summary.p99 = sorted[(count - 1) * 99 / 100];
  summary.max = sorted[count - 1];
  return summary;
}

}  // namespace hidwa_local_planner
