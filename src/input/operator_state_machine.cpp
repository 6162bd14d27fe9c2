// SPDX-License-Identifier: BSD-3-Clause
#include "hidwa_local_planner/input/operator_state_machine.hpp"

#include <algorithm>
#include <cmath>

#include "hidwa_local_planner/input/transition.hpp"
#include "words.hpp"

namespace hidwa_local_planner::input {
namespace {

// Times that threads read before they take turns, or that a simulated clock ticks apart, differ by less; a
// larger step back is a clock that was set back.
constexpr double kClockJitter = 0.2;  // [s]

bool same_mapping(const Parameters& a, const Parameters& b) {
  return a.axis_angular == b.axis_angular && a.axis_linear == b.axis_linear &&
         a.axis_angular_sign == b.axis_angular_sign && a.axis_linear_sign == b.axis_linear_sign &&
         a.enable_button == b.enable_button;
}

std::string late(double excess, double limit) {
  return "it arrived " + number(excess) + " s later than the link needs at best, more than input_timeout (" +
         number(limit) +
         " s): the link holds messages back, or the sender's clock runs differently (synchronise the " +
         "clocks, or leave the stamps empty)";
}

}  // namespace

OperatorStateMachine::OperatorStateMachine() { configure(Parameters()); }

void OperatorStateMachine::configure(const Parameters& parameters) {
  const bool other_mode = parameters.mode != parameters_.mode;
  const bool other_mapping = !same_mapping(parameters, parameters_);
  const bool other_device = parameters.joy_topic != parameters_.joy_topic;
  if (parameters.input_timeout != parameters_.input_timeout) rhythm_.reset();
  parameters_ = parameters;
  channel_.configure(parameters_.input_timeout, parameters_.require_neutral);
  if (other_mode) {
    reset();
  } else if (other_device) {
    new_device();
  } else if (other_mapping) {
    channel_.demand_neutral();
  } else {
    channel_.remap(wish_of(reading_, parameters_));
  }
}

std::string OperatorStateMachine::receive(const StickMessage& message) {
  if (parameters_.mode == OperatorMode::off) return {};
  if (!std::isfinite(message.stamp) || !std::isfinite(message.received)) {
    return drop("its time is not a finite number: look at the sender");
  }
  if (message.received < received_ - kClockJitter) reset();
  received_ = std::max(received_, message.received);

  StickReading reading;
  const std::string fault = read_stick(message, parameters_, reading);
  if (!fault.empty()) return drop(fault);
  if (device_.changed(message)) new_device();
  const double timeout = parameters_.input_timeout;
  if (timeout > 0.0) {
    const BacklogGate::Verdict verdict = backlog_.judge(message.stamp, received_, timeout);
    if (verdict == BacklogGate::Verdict::backlog) return drop(late(backlog_.excess(), timeout));
    if (verdict == BacklogGate::Verdict::new_clock) channel_.demand_neutral();
  }
  reading_ = reading;
  const Wish wish = wish_of(reading_, parameters_);
  channel_.accept(wish, received_);
  rhythm_.heard(received_, wish.active, timeout);
  fault_.clear();
  return {};
}

OperatorIntent OperatorStateMachine::update(double now) {
  const bool before_message = channel_.heard() && now < channel_.time() - kClockJitter;
  if (now < now_ - kClockJitter || before_message) reset();
  now_ = std::max(now_, now);
  channel_.check(now_);
  rhythm_.check(now_, parameters_.input_timeout);
  if (is_steering(state_) && !channel_.active()) begin_hold();

  Facts facts;
  facts.enabled = parameters_.mode != OperatorMode::off;
  facts.lost = channel_.lost();
  facts.active = channel_.active();
  facts.blocked = blocked_.blocked(now_, parameters_.blocked_time);
  facts.holding = hold_.running(now_, parameters_.delta);
  facts.at_goal = goal_latched_ && !parameters_.operator_in_goal_window;
  state_ = next_state(state_, facts);

  if (is_steering(state_) || facts.at_goal) hold_.end();
  if (!is_steering(state_)) blocked_.reset();
  return intent(now_);
}

void OperatorStateMachine::debrief(double now, const CycleFeedback& feedback) {
  goal_latched_ = feedback.goal_latched;
  commanded_ = true;
  own_v_ = feedback.command.v;
  blocked_.observe(now, is_steering(state_) && feedback.own_command_refused && feedback.at_rest);
  const bool straight_on = state_ == OperatorStateId::hold || state_ == OperatorStateId::lost;
  if (straight_on && feedback.own_command_refused && parameters_.hold_ends_when_refused) hold_.end();
}

void OperatorStateMachine::new_goal() {
  goal_latched_ = false;
  blocked_.reset();
}

void OperatorStateMachine::reset() {
  device_.reset();
  backlog_.reset();
  channel_.reset();
  rhythm_.reset();
  hold_.end();
  blocked_.reset();
  state_ = OperatorStateId::autonomy;
  goal_latched_ = false;
  commanded_ = false;
  now_ = -std::numeric_limits<double>::infinity();
  received_ = -std::numeric_limits<double>::infinity();
  fault_.clear();
}

double OperatorStateMachine::input_age(double now) const {
  return channel_.heard() ? std::max(0.0, now - channel_.time()) : -1.0;
}

std::string OperatorStateMachine::advice() const {
  std::string text;
  if (!fault_.empty()) text = "The last message was dropped: " + fault_ + ".";
  const auto add = [&text](const std::string& sentence) {
    if (!text.empty() && !sentence.empty()) text += ' ';
    text += sentence;
  };
  add(rhythm_.advice(parameters_.input_timeout));
  if (device_.contested()) {
    add("Two nodes take turns on joy_topic, " + device_.rival() + " and " + device_.sender() +
        ": each counts as a new device after the other. Let only one of them send.");
  }
  if (channel_.waits_for_neutral()) {
    add("The input does not count before it was seen released once (require_neutral): let go of the stick "
        "and of the "
        "enable button; if nobody touches it, raise dead_zone.");
  }
  return text;
}

std::string OperatorStateMachine::drop(const std::string& fault) {
  ++dropped_;
  fault_ = fault;
  return fault_;
}

void OperatorStateMachine::new_device() {
  backlog_.reset();
  channel_.demand_neutral();
  rhythm_.reset();
}

// A loss is a release only where the policy says so.
void OperatorStateMachine::begin_hold() {
  if (channel_.lost() && parameters_.on_input_lost != OnInputLost::hold) return;
  const bool from_robot = parameters_.hold_linear == HoldLinear::robot && commanded_;
  hold_.begin(channel_.ended_at(), from_robot ? own_v_ : channel_.u_h().v);
}

OperatorIntent OperatorStateMachine::intent(double now) const {
  OperatorIntent wanted;
  wanted.state = state_;
  const bool lost = state_ == OperatorStateId::lost;
  if (is_steering(state_)) {
    wanted.influence = Influence::shared;
    wanted.u_h = channel_.u_h();
  } else if (lost && parameters_.on_input_lost == OnInputLost::stop) {
    wanted.influence = Influence::stop;
  } else if (state_ == OperatorStateId::hold || (lost && parameters_.on_input_lost == OnInputLost::hold &&
                                                 hold_.running(now, parameters_.delta))) {
    wanted.influence = Influence::shared;
    wanted.u_h = {hold_.v(), 0.0};
  }
  return wanted;
}

}  // namespace hidwa_local_planner::input
