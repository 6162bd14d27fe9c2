// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <cstddef>
#include <ostream>

namespace hidwa_local_planner {
namespace study {

/// Tells how many runs are made and how long the rest may take: a line every few seconds.
class Progress {
 public:
  Progress(std::ostream& stream, std::size_t total) : stream_(stream), total_(total) {}

  /// One more is made.
  void step();

  double elapsed() const;  // [s], by the wall clock

 private:
  using Clock = std::chrono::steady_clock;
  std::ostream& stream_;
  std::size_t total_;
  std::size_t done_ = 0;
  Clock::time_point begin_ = Clock::now();
  double told_ = 0.0;  // [s], since the begin
};

}  // namespace study
}  // namespace hidwa_local_planner
