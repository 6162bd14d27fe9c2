// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace hidwa_local_planner {

/// Durations of the last cycles. Not thread-safe.
class CycleStatistics {
 public:
  struct Summary {
    std::uint64_t cycles = 0;                // since the start
    std::uint64_t late = 0;                  // longer than the period, since the start
    double p50 = 0.0, p99 = 0.0, max = 0.0;  // of the last kWindow cycles [s]
  };
  static constexpr std::size_t kWindow = 1000;

  void add(double duration, double period);  // [s]
  Summary summary() const;

 private:
  std::array<double, kWindow> durations_{};  // ring [s]
  std::uint64_t cycles_ = 0;
  std::uint64_t late_ = 0;
};

}  // namespace hidwa_local_planner
