// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <chrono>
#include <thread>

namespace hidwa_local_planner {
namespace sim {

/// Spaces steps evenly in wall time. A short lateness is caught up; after a longer one the time lost stays
/// lost, so that simulated time never races ahead of the nodes that follow it.
class Pacer {
 public:
  /// Sleeps until the next step is due, `period` [s] of wall time after the one before.
  void wait(double period) {
    const auto step = std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(period));
    next_ = std::max(next_ + step, Clock::now() - kCatchUp);
    std::this_thread::sleep_until(next_);
  }

 private:
  using Clock = std::chrono::steady_clock;
  static constexpr std::chrono::milliseconds kCatchUp{5};

  Clock::time_point next_ = Clock::now();
};

}  // namespace sim
}  // namespace hidwa_local_planner
