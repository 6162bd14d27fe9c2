// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "control/control_loop.hpp"
#include "record/cycle_record.hpp"

namespace hidwa_local_planner {
namespace record {

/// Makes the records of cycles that follow one another: for each begin(), ControlLoop::step(), finish(). A key record,
/// from which reading can begin, is made at the start, when one is demanded, and every hundredth cycle.
class CycleRecorder {
 public:
  static constexpr int kKeyEvery = 100;  // cycles

  /// The next record is to stand for itself: somebody new listens, what stays the same changed, or cycles were left
  /// out.
  void demand_key() { cycles_since_key_ = kKeyEvery; }
  /// New parameters are in force; `critics`: see Setup.
  void take(std::string critics) {
    critics_ = std::move(critics);
    demand_key();
  }
  /// Before ControlLoop::step() with the same.
  void begin(const control::ControlLoop& loop, const control::Observation& observation, const Sampling& sampling);
  /// To be written before finish(): what OperatorStateMachine::save() says before the cycle.
  Bytes& operator_state() { return record_.operator_state; }
  /// What came of it, as bytes; they stay valid until the next record's.
  const Bytes& finish(const control::Result& result, const Planner& planner);

 private:
  void take_setup(const control::ControlLoop& loop);
  void take_plan(const std::vector<Pose2>& plan, bool key);

  std::string critics_;
  CycleRecord record_;
  std::vector<Pose2> plan_;  // of the record before
  Bytes bytes_;
  int cycles_since_key_ = kKeyEvery;
};

}  // namespace record
}  // namespace hidwa_local_planner
