// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "hidwa_local_planner/core/operator_intent.hpp"
#include "hidwa_local_planner/core/parameters.hpp"
#include "hidwa_local_planner/input/operator_state_machine.hpp"

namespace hidwa_local_planner::control {

/// The operator's state machine, as a control cycle uses it. Where messages arrive in another thread, a class derived
/// from this one locks it.
class Operator {
 public:
  virtual ~Operator() = default;
  /// See OperatorStateMachine, whose functions of the same names these are.
  virtual void configure(const Parameters& parameters) = 0;
  virtual OperatorIntent update(double now) = 0;
  virtual void debrief(double now, const input::CycleFeedback& feedback) = 0;
  virtual void new_goal() = 0;
  virtual bool manual() const = 0;
};

/// The machine alone, where everything happens in one thread.
class LoneOperator : public Operator {
 public:
  input::OperatorStateMachine& machine() { return machine_; }
  void configure(const Parameters& parameters) override { machine_.configure(parameters); }
  OperatorIntent update(double now) override { return machine_.update(now); }
  void debrief(double now, const input::CycleFeedback& feedback) override { machine_.debrief(now, feedback); }
  void new_goal() override { machine_.new_goal(); }
  bool manual() const override { return machine_.manual(); }

 private:
  input::OperatorStateMachine machine_;
};

}  // namespace hidwa_local_planner::control
