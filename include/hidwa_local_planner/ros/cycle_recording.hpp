// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "hidwa_local_planner/control/control_loop.hpp"
#include "hidwa_local_planner/core/operator_intent.hpp"
#include "hidwa_local_planner/core/planner.hpp"
#include "hidwa_local_planner/record/cycle_recorder.hpp"
#include "hidwa_local_planner/ros/cycle_result.hpp"
#include "hidwa_local_planner/ros/parameter_set.hpp"

namespace hidwa_local_planner {

/// The records of the shell's cycles, for `~cycle`. While nobody wants them every call returns at once.
class CycleRecording : public control::Witness {
 public:
  /// Parameters are in force from now on.
  void take(const ParameterSet& set);
  /// Somebody new listens, or the outline changed.
  void demand_key() { recorder_.demand_key(); }

  /// A cycle begins; `wanted`: it is to be recorded.
  void begin(double now, bool wanted);
  /// Where the operator's machine is to be saved before it is asked; null where that is not wanted.
  Bytes* before() { return wanted_ ? &before_ : nullptr; }
  void heard(const OperatorIntent& intent, bool host_stops) override;
  void plans(const Planner& planner, const Situation& situation, const GridView& costmap,
             const Sampling& sampling) override;
  void brakes(const Planner& planner, const FaultBrake& brake, const control::BrakeSituation& situation) override;
  /// The record as bytes, which stay valid until the next cycle; empty where it was not wanted.
  const Bytes& finish(const CycleResult& result, const Planner& planner);

 private:
  void open(const Planner& planner);

  record::CycleRecorder recorder_;
  Bytes before_;  // the operator's machine
  OperatorIntent intent_;
  bool host_stops_ = false;
  std::string critics_;  // see record::Setup
  double now_ = 0.0;     // [s]
  bool wanted_ = false;
  const Bytes nothing_;
};

}  // namespace hidwa_local_planner
