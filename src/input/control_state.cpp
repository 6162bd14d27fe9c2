// SPDX-License-Identifier: BSD-3-Clause
#include "input/control_state.hpp"

namespace hidwa_local_planner::input {

OperatorIntent ControlState::update(const CycleInput& cycle) {
  if (is_steering(state_) && !cycle.channel.active() && !cycle.goalless) begin_hold(cycle);
  const Facts present = facts(cycle);
  state_ = next_state(state_, present);
  const bool in_command =
      is_steering(state_) || state_ == OperatorStateId::stopped || state_ == OperatorStateId::manual;
  if (in_command || present.at_goal) hold_.end();
  if (!is_steering(state_)) blocked_.reset();
  return intent(cycle);
}

void ControlState::debrief(double now, const CycleFeedback& feedback, const Parameters& parameters) {
  if (feedback.new_goal) new_goal();
  goal_latched_ = feedback.goal_latched;
  last_v_ = feedback.command.v;
  blocked_.observe(now, is_steering(state_) && feedback.operator_command_rejected && feedback.stands);
  const bool straight_on = state_ == OperatorStateId::hold || state_ == OperatorStateId::lost;
  if (straight_on && feedback.operator_command_rejected && parameters.method == Method::hidwa) hold_.end();
}

void ControlState::new_goal() {
  goal_latched_ = false;
  blocked_.reset();
}

// A loss is a release only where the policy says so.
void ControlState::begin_hold(const CycleInput& cycle) {
  const Parameters& p = cycle.parameters;
  if (cycle.channel.lost() && p.on_input_lost != OnInputLost::hold) return;
  const bool from_robot = p.linear == LinearPolicy::current;
  hold_.begin(cycle.channel.ended_at(), from_robot ? last_v_.value_or(cycle.channel.u_h().v) : cycle.channel.u_h().v);
}

Facts ControlState::facts(const CycleInput& cycle) const {
  const Parameters& p = cycle.parameters;
  const bool switching = p.mode == OperatorMode::switching;
  Facts facts;
  facts.enabled = p.mode != OperatorMode::off;
  facts.stop = cycle.stop;
  facts.manual = cycle.manual;
  facts.goalless = cycle.goalless;
  facts.lost = cycle.channel.lost() && (!switching || cycle.manual || cycle.goalless);
  facts.active = cycle.channel.active() && (!switching || cycle.goalless);
  facts.blocked = blocked_.for_at_least(p.blocked_time, cycle.now);
  facts.holding = hold_.running(cycle.now, p.delta);
  facts.at_goal = goal_latched_ && p.method == Method::hidwa;
  return facts;
}

OperatorIntent ControlState::intent(const CycleInput& cycle) const {
  const Parameters& p = cycle.parameters;
  OperatorIntent intent;
  intent.state = state_;
  const bool lost = state_ == OperatorStateId::lost;
  const bool stops = state_ == OperatorStateId::stopped ||
                     (lost && (cycle.manual || cycle.goalless || p.on_input_lost == OnInputLost::stop));
  const bool straight_on = state_ == OperatorStateId::hold ||
                           (lost && p.on_input_lost == OnInputLost::hold && hold_.running(cycle.now, p.delta));
  if (stops) {
    intent.influence = Influence::stop;
  } else if (state_ == OperatorStateId::manual) {
    intent.influence = Influence::direct;
    intent.guarded = p.guard == Guard::nearest || cycle.goalless;
    if (cycle.channel.active()) intent.u_h = cycle.channel.u_h();
  } else if (is_steering(state_)) {
    intent.influence = Influence::shared;
    intent.u_h = cycle.channel.u_h();
    if (p.linear == LinearPolicy::current) intent.u_h.v = last_v_.value_or(0.0);
  } else if (straight_on) {
    intent.influence = Influence::shared;
    intent.u_h = {hold_.v(), 0.0};
  }
  return intent;
}

}  // namespace hidwa_local_planner::input
