// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "hidwa_local_planner/control/fault_brake.hpp"
#include "hidwa_local_planner/record/cycle_record.hpp"

namespace hidwa_local_planner {
namespace record {

/// Makes the records of cycles that follow one another: in each begin(), the input, finish(). A key record, from which
/// reading can begin, is made at the start, when one is demanded, and every hundredth cycle.
class CycleRecorder {
 public:
  static constexpr int kKeyEvery = 100;  // cycles

  /// The next record is to stand for itself: somebody new listens, what stays the same changed, or cycles were left
  /// out.
  void demand_key() { cycles_since_key_ = kKeyEvery; }
  /// True when this cycle's will be a key record: setup() is wanted.
  bool begin(double time);
  void setup(Setup setup) { record_.setup = std::move(setup); }
  /// Filled by whoever has the operator machine, before its update.
  Bytes& operator_state() { return record_.operator_state; }
  /// What the machine said, and whether the host stops the robot whatever that is.
  void intent(const OperatorIntent& intent, bool host_stops = false) {
    record_.intent = intent;
    record_.host_stops = host_stops;
  }
  /// Before Planner::plan() with the same.
  void plans(const Planner& planner, const Situation& situation, const GridView& grid, const Sampling& sampling);
  /// Before FaultBrake::answer() with the same.
  void brakes(const FaultBrake& brake, const BrakeInput& input);
  /// What came of it, as bytes; they stay valid until the next record's.
  const Bytes& finish(const Verdict& verdict);

 private:
  CycleRecord record_;
  GridChain grids_;
  Bytes bytes_;
  std::uint32_t sequence_ = 0;
  int cycles_since_key_ = kKeyEvery;
};

}  // namespace record
}  // namespace hidwa_local_planner
