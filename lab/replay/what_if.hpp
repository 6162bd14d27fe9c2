// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fstream>
#include <string>

#include "record/cycle_replay.hpp"

namespace hidwa_local_planner {
namespace replay {

/// Cycles that came out differently, as lines and, in a what-if, all of them as CSV. With unchanged parameters a cycle
/// differs by one bit of its decision; with changed ones every sum is another, so that only what is sent, or what the
/// person is taken to want, makes a difference.
class WhatIf {
 public:
  /// `csv`: the file, or empty for a replay with unchanged parameters. Throws UsageError where it cannot be written.
  explicit WhatIf(const std::string& csv);
  /// `time` [s] since the first record.
  void add(double time, const record::CycleRecord& recorded, const record::ReplayedCycle& replayed);
  /// All cycles were added: the CSV is complete.
  void close() { csv_.close(); }
  long differences() const { return differences_; }
  /// What the differences come to; empty where there are none.
  std::string summary() const;

 private:
  static constexpr long kShown = 20;

  std::ofstream csv_;
  bool differs(const record::CycleRecord& recorded, const record::ReplayedCycle& replayed) const;

  long differences_ = 0, outcomes_ = 0, intents_ = 0, commands_ = 0;
  long sums_ = 0;                 // cycles that only weigh differently
  double v_ = 0.0, omega_ = 0.0;  // sums of the commands' changes [m/s, rad/s]
  double most_v_ = 0.0, most_omega_ = 0.0;
};

}  // namespace replay
}  // namespace hidwa_local_planner
