// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "hidwa_local_planner/control/control_loop.hpp"
#include "hidwa_local_planner/record/cycle_recorder.hpp"
#include "hidwa_local_planner/ros/parameter_set.hpp"

namespace hidwa_local_planner {

/// The records of the shell's cycles, for `~cycle`. While nobody wants them every call returns at once.
class CycleRecording {
 public:
  /// Parameters are in force from now on.
  void take(const ParameterSet& set) { recorder_.take(foreign_content(set)); }
  /// Somebody new listens, or the outline changed.
  void demand_key() { recorder_.demand_key(); }

  /// A cycle begins; `wanted`: it is to be recorded. Where the operator's state machine is to be saved before the
  /// cycle; null where that is not wanted.
  Bytes* begin(bool wanted);
  /// Before ControlLoop::step() with the same.
  void steps(const control::ControlLoop& loop, const control::Observation& observation, const Sampling& sampling) {
    if (wanted_) recorder_.begin(loop, observation, sampling);
  }
  /// The record as bytes, which stay valid until the next cycle; empty where it was not wanted.
  const Bytes& finish(const control::Result& result, const Planner& planner) {
    return wanted_ ? recorder_.finish(result, planner) : nothing_;
  }

 private:
  record::CycleRecorder recorder_;
  bool wanted_ = false;
  const Bytes nothing_{};
};

}  // namespace hidwa_local_planner
