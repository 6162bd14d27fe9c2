// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "hidwa_local_planner/core/operator_intent.hpp"
#include "hidwa_local_planner/core/planner.hpp"
#include "hidwa_local_planner/record/cycle_recorder.hpp"
#include "hidwa_local_planner/ros/cycle_result.hpp"
#include "hidwa_local_planner/ros/operator_input.hpp"
#include "hidwa_local_planner/ros/parameter_set.hpp"

namespace hidwa_local_planner {

/// The records of the shell's cycles, for `~cycle`. While nobody wants them every call returns at once.
class CycleRecording {
 public:
  /// Parameters are in force from now on.
  void take(const ParameterSet& set);
  /// Somebody new listens, or the outline changed.
  void demand_key() { recorder_.demand_key(); }

  /// A cycle begins; `wanted`: it is to be recorded.
  void begin(double now, bool wanted);
  /// Where the person's part is to be noted; null where it is not wanted.
  OperatorInput::Before* before() { return wanted_ ? &before_ : nullptr; }
  /// What the machine said, and whether the host stops the robot whatever that is.
  void heard(const OperatorIntent& intent, bool host_stops);
  /// Before the planner plans, or the fault brake answers, with the same. `outline`: the planner's, unpadded [m].
  void plans(const Planner& planner, const Polygon& outline, const Situation& situation, const GridView& grid,
             const Sampling& sampling);
  void brakes(const Planner& planner, const Polygon& outline, const FaultBrake& brake, const record::BrakeInput& input);
  /// The record as bytes, which stay valid until the next cycle; empty where it was not wanted.
  const Bytes& finish(const CycleResult& result, const Planner& planner);

 private:
  void open(const Planner& planner, const Polygon& outline);

  record::CycleRecorder recorder_;
  OperatorInput::Before before_;
  unsigned recorded_revision_ = 0;  // of the operator's parameters, in the last record
  OperatorIntent intent_;
  bool host_stops_ = false;
  std::string critics_;  // see record::Setup
  double now_ = 0.0;     // [s]
  bool wanted_ = false;
  const Bytes nothing_;
};

}  // namespace hidwa_local_planner
