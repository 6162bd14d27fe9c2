// SPDX-License-Identifier: BSD-3-Clause
#include "hidwa_local_planner/input/operator_state_machine.hpp"

#include <algorithm>
#include <cmath>

#include "core/util/words.hpp"

namespace hidwa_local_planner::input {
namespace {

// Times that threads read before they take turns, or that a simulated clock ticks apart, differ by less; a
// larger step back is a clock that was set back.
constexpr double kClockJitter = 0.2;  // [s]

// Longer without a cycle, and nobody drives: a press of the button would hand over what nobody sees.
constexpr double kDriving = 1.0;  // [s]

// What follows the end of a silence at once may be what a link held back meanwhile: a press of a button in it
// is an old one. The message that ends the silence is none of these: a stick may send only changes.
constexpr double kCatchingUp = 0.2;  // [s]

// Repeating devices are heard more often. A stop that nobody sent for so long may be let go by others.
constexpr double kGone = 1.0;  // [s]

// Pauses of the planner's own that a person may notice, and how long they are told.
constexpr double kWorthTelling = 0.3;  // [s]
constexpr double kToldFor = 10.0;      // [s]

bool same_mapping(const Parameters& a, const Parameters& b) {
  return a.axis_angular == b.axis_angular && a.axis_linear == b.axis_linear &&
         a.axis_angular_sign == b.axis_angular_sign && a.axis_linear_sign == b.axis_linear_sign &&
         a.enable_button == b.enable_button && a.stop_button == b.stop_button && a.toggle_button == b.toggle_button &&
         a.clutch_button == b.clutch_button && a.clutch_axis == b.clutch_axis &&
         a.clutch_axis_sign == b.clutch_axis_sign && a.gesture_axis == b.gesture_axis &&
         a.gesture_axis_sign == b.gesture_axis_sign && a.gesture_linear_axis == b.gesture_linear_axis &&
         a.gesture_linear_sign == b.gesture_linear_sign;
}

bool same_topics(const Parameters& a, const Parameters& b) {
  return a.joy_topic == b.joy_topic && a.twist_topic == b.twist_topic && a.gesture_topic == b.gesture_topic &&
         a.gesture_frame == b.gesture_frame && a.gesture_parent_frame == b.gesture_parent_frame;
}

std::string late(double excess, const BacklogGate::Limits& limits) {
  const bool may_settle = excess <= limits.lag_max;
  const bool beyond_settling = !may_settle && limits.lag_max > limits.late;
  std::string text = "it arrived " + worded(excess, 3) + " s later than the link needs at best, more than ";
  text += beyond_settling ? "input_lag_max (" + worded(limits.lag_max, 3) : "input_timeout (" + worded(limits.late, 3);
  text += " s): the link holds messages back";
  if (may_settle) text += " (a delay that is steady within 0.1 s for 2 s is taken as it is)";
  return text + ", or the sender's clock runs differently (synchronise the clocks, or leave the stamps empty)";
}

template <typename Message>
std::string fault_of_times(const Message& message) {
  if (std::isfinite(message.stamp) && std::isfinite(message.received)) return {};
  return "its time is not a finite number: look at the sender";
}

template <typename Message>
Envelope envelope_of(const Message& message, double received) {
  Envelope envelope;
  envelope.sender = message.sender;
  envelope.stamp = message.stamp;
  envelope.received = received;
  return envelope;
}

}  // namespace

OperatorStateMachine::OperatorStateMachine() { configure(Parameters()); }

void OperatorStateMachine::configure(const Parameters& parameters) {
  const bool other_mode = parameters.mode != parameters_.mode;
  const bool other_mapping = !same_mapping(parameters, parameters_);
  const bool other_device = !same_topics(parameters, parameters_);
  if (parameters.input_timeout != parameters_.input_timeout) rhythm_.reset();
  parameters_ = parameters;
  channel_.configure(parameters_.input_timeout, parameters_.require_neutral);
  if (other_mode) {
    const StopRequest stop = stop_;  // who stopped the robot did not let go of it
    const SignsOfLife life = life_;
    reset();
    stop_ = stop;
    stop_.dismiss();  // but whoever is gone cannot
    life_ = life;
  } else if (other_device) {
    sticks_.forget_lag();
    twists_.forget_lag();
    hands_.forget_lag();
    new_device();
    stop_.demand_neutral();
  } else if (other_mapping) {
    channel_.demand_neutral();
    stop_.demand_neutral();
    control_.forget_button();
    gesture_.lose();
  } else {
    channel_.remap(present_wish());
  }
}

std::string OperatorStateMachine::receive(const StickMessage& message) {
  if (parameters_.mode == OperatorMode::off) return {};
  begin(message.received);
  StickReading reading;
  const std::string fault = judge(message, reading);
  stop_.hear(message.sender, read_stop(message, parameters_), fault.empty(), parameters_, received_);
  if (!fault.empty()) return drop(fault, stick_fault_);
  reading_ = reading;
  hear_stick();
  read_buttons();
  if (steered_by_stick()) feed(wish_of(reading_, parameters_));
  stick_fault_.clear();
  return {};
}

std::string OperatorStateMachine::receive(const TwistMessage& message) {
  if (parameters_.mode == OperatorMode::off || !steered_by_twist(parameters_)) return {};
  begin(message.received);
  std::string fault = fault_of_times(message);
  if (fault.empty()) fault = fault_of(message);
  if (fault.empty()) fault = admit(twists_, envelope_of(message, received_));
  if (!fault.empty()) return drop(fault, twist_fault_);
  twist_ = message;
  feed(wish_of(twist_, parameters_));
  twist_fault_.clear();
  return {};
}

std::string OperatorStateMachine::receive(const HandMessage& message) {
  if (parameters_.mode != OperatorMode::gesture) return {};
  begin(message.received);
  std::string fault = fault_of_times(message);
  if (fault.empty()) fault = admit(hands_, envelope_of(message, received_));
  if (!fault.empty()) return drop(fault, hand_fault_);
  watch_hand(received_);
  fault = gesture_.take(message, parameters_);
  if (!fault.empty()) {
    channel_.lose();
    return drop(fault, hand_fault_);
  }
  hand_.hear(received_);
  // A clutch that is still held after a loss says nothing: the loss lasts until it is let go.
  if (!gesture_.waits_for_release()) feed(gesture_.wish(parameters_));
  hand_fault_.clear();
  return {};
}

void OperatorStateMachine::take_control(bool manual) {
  if (parameters_.mode == OperatorMode::switching) said_control_ = manual;
}

void OperatorStateMachine::stop(bool stop) {
  stop_.say(stop);
  if (!stop) stop_.dismiss();
}

void OperatorStateMachine::listens(double now) {
  life_.expect();
  live(now);
}

OperatorIntent OperatorStateMachine::update(double now) {
  if (now < std::max(now_, received_) - kClockJitter) set_back(now);
  live(now);
  behind_ = false;
  if (said_control_ && now - now_ < kDriving) control_.say(*said_control_);
  said_control_.reset();
  now_ = std::max(now_, now);
  channel_.check(now_);
  rhythm_.check(now_, parameters_.input_timeout);
  watch_hand(now_);
  tell(stop_.check(now_, std::max(kGone, parameters_.input_timeout)));
  if (is_steering(state_) && !channel_.active()) begin_hold();
  const Facts present = facts();
  state_ = next_state(state_, present);
  const bool in_command =
      is_steering(state_) || state_ == OperatorStateId::stopped || state_ == OperatorStateId::manual;
  if (in_command || present.at_goal) hold_.end();
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
  sticks_.reset();
  twists_.reset();
  hands_.reset();
  reading_ = {};
  twist_ = {};
  gesture_.reset();
  stop_.reset();
  control_.reset();
  channel_.reset();
  rhythm_.reset();
  hold_.end();
  blocked_.reset();
  state_ = OperatorStateId::autonomy;
  goal_latched_ = false;
  commanded_ = false;
  own_v_ = 0.0;
  said_control_.reset();
  catching_up_ = false;
  life_ = {};
  behind_ = false;
  now_ = received_ = stick_back_ = paused_at_ = kNever;
  stick_ = hand_ = {};
  pause_ = 0.0;
  stick_fault_.clear();
  twist_fault_.clear();
  hand_fault_.clear();
}

double OperatorStateMachine::input_age(double now) const {
  return channel_.heard() ? std::max(0.0, now - channel_.time()) : -1.0;
}

std::string OperatorStateMachine::advice() const {
  std::string text;
  const auto add = [&text](const std::string& sentence) {
    if (!text.empty() && !sentence.empty()) text += ' ';
    text += sentence;
  };
  for (const std::string* fault : {&stick_fault_, &twist_fault_, &hand_fault_}) {
    if (!fault->empty()) add("The last message was dropped: " + *fault + ".");
  }
  const double timeout = parameters_.input_timeout;
  const double now = std::max(now_, received_);
  if (pause_ > 0.0 && now - paused_at_ < kToldFor) {
    add("The planner itself stood still for " + worded(pause_, 2) +
        " s and heard nobody meanwhile: its machine is too busy, the process was suspended, or the clock was set "
        "forward. Lighten the load.");
  }
  if (timeout > 0.0) add(stop_.advice(now, std::max(kGone, timeout)));
  add(rhythm_.advice(timeout));
  add(sticks_.advice("joy_topic"));
  add(twists_.advice("twist_topic"));
  add(hands_.advice("gesture_topic"));
  if (parameters_.mode == OperatorMode::gesture && gesture_.waits_for_release()) {
    add("The hand does not count before its clutch was let go and pressed anew: let go of it.");
  } else if (channel_.waits_for_neutral()) {
    add("The input does not count before it was seen released once (require_neutral): let go of the stick "
        "and of the "
        "enable button; if nobody touches it, raise dead_zone.");
  }
  return text;
}

bool OperatorStateMachine::steered_by_stick() const {
  return parameters_.mode != OperatorMode::gesture && !steered_by_twist(parameters_);
}

bool OperatorStateMachine::cycles_run() const { return std::abs(received_ - now_) < kDriving; }

// Who stopped the robot or took control did so in words or by a button, and sees no clock.
void OperatorStateMachine::set_back(double now) {
  StopRequest stop = stop_;
  stop.set_back(now);
  ControlSwitch control = control_;
  control.forget_button();
  SignsOfLife life = life_;
  life.forget_time();
  reset();
  stop_ = stop;
  control_ = control;
  life_ = life;
}

void OperatorStateMachine::live(double now) {
  const double pause = life_.observe(now);
  if (pause == 0.0) return;
  behind_ = true;
  channel_.excuse(pause);
  stick_.excuse(pause);
  hand_.excuse(pause);
  rhythm_.excuse(pause);
  if (pause < kWorthTelling || !(channel_.active() || channel_.lost())) return;
  pause_ = pause;
  paused_at_ = now;
}

void OperatorStateMachine::tell(const std::string& sentence) {
  if (!news_.empty() && !sentence.empty()) news_ += ' ';
  news_ += sentence;
}

std::string OperatorStateMachine::take_news() {
  std::string news;
  news.swap(news_);
  return news;
}

void OperatorStateMachine::begin(double received) {
  if (!std::isfinite(received)) return;
  if (received < received_ - kClockJitter) set_back(received);
  received_ = std::max(received_, received);
  live(received);
}

// Whether a stick's message is well-formed and live; the fault in words, else empty.
std::string OperatorStateMachine::judge(const StickMessage& message, StickReading& reading) {
  std::string fault = fault_of_times(message);
  if (fault.empty()) fault = read_stick(message, parameters_, reading);
  if (!fault.empty()) return fault;
  Envelope envelope = envelope_of(message, received_);
  envelope.axes = message.axes.size();
  envelope.buttons = message.buttons.size();
  return admit(sticks_, envelope);
}

std::string OperatorStateMachine::admit(MessageStream& stream, const Envelope& envelope) {
  const BacklogGate::Limits limits{parameters_.input_timeout, parameters_.input_lag_max};
  switch (stream.judge(envelope, limits)) {
    case MessageStream::Verdict::late:
      return late(stream.excess(), limits);
    case MessageStream::Verdict::new_device:
      new_device();
      break;
    case MessageStream::Verdict::slower_link:
    case MessageStream::Verdict::new_clock:
      channel_.demand_neutral();
      break;
    case MessageStream::Verdict::live:
      break;
  }
  return {};
}

void OperatorStateMachine::hear_stick() {
  const double timeout = parameters_.input_timeout;
  const bool back = timeout > 0.0 && received_ - stick_.time() > timeout;
  if (back) stick_back_ = received_;
  catching_up_ = timeout > 0.0 && !back && received_ - stick_back_ < kCatchingUp;
  stick_.hear(received_);
}

void OperatorStateMachine::read_buttons() {
  const bool counts = cycles_run() && !catching_up_;
  if (parameters_.mode == OperatorMode::switching) control_.take(reading_.toggle, counts);
  if (parameters_.mode != OperatorMode::gesture) return;
  gesture_.set_clutch(reading_.clutch);
  // A release is heard at once, not with the hand's next pose.
  if (!reading_.clutch) feed({});
}

void OperatorStateMachine::feed(const Wish& wish) {
  channel_.accept(wish, received_);
  rhythm_.heard(received_, wish.active, parameters_.input_timeout);
}

std::string OperatorStateMachine::drop(const std::string& fault, std::string& last_fault) {
  ++dropped_;
  last_fault = fault;
  return fault;
}

void OperatorStateMachine::new_device() {
  channel_.demand_neutral();
  control_.forget_button();
  gesture_.lose();
  rhythm_.reset();
}

// Poses may go on without the stick whose button is the clutch. And where poses fell silent, the origin is old.
void OperatorStateMachine::watch_hand(double now) {
  if (parameters_.mode != OperatorMode::gesture || !gesture_.clutch()) return;
  const double timeout = parameters_.input_timeout;
  const bool no_clutch = stick_.silence(now) > timeout;
  const bool no_hand = gesture_.engaged() && hand_.silence(now) > timeout;
  if (timeout > 0.0 && (no_clutch || no_hand)) {
    channel_.lose();
    gesture_.lose();
  }
  if (channel_.lost()) gesture_.lose();
}

// A loss is a release only where the policy says so.
void OperatorStateMachine::begin_hold() {
  if (channel_.lost() && parameters_.on_input_lost != OnInputLost::hold) return;
  const bool from_robot = parameters_.hold_linear == HoldLinear::robot || parameters_.linear == LinearPolicy::current;
  hold_.begin(channel_.ended_at(), from_robot && commanded_ ? own_v_ : channel_.u_h().v);
}

// What the newest messages ask for by the present parameters.
Wish OperatorStateMachine::present_wish() const {
  if (parameters_.mode == OperatorMode::gesture) return gesture_.wish(parameters_);
  return steered_by_stick() ? wish_of(reading_, parameters_) : wish_of(twist_, parameters_);
}

Facts OperatorStateMachine::facts() const {
  const bool switching = parameters_.mode == OperatorMode::switching;
  Facts facts;
  facts.enabled = parameters_.mode != OperatorMode::off;
  facts.stop = stop_.requested();
  facts.manual = manual();
  facts.lost = channel_.lost() && (!switching || facts.manual);
  facts.active = channel_.active() && !switching;
  facts.blocked = blocked_.for_at_least(parameters_.blocked_time, now_);
  facts.holding = hold_.running(now_, parameters_.delta);
  facts.at_goal = goal_latched_ && !parameters_.operator_in_goal_window;
  return facts;
}

OperatorIntent OperatorStateMachine::intent(double now) const {
  OperatorIntent wanted;
  wanted.state = state_;
  const bool lost = state_ == OperatorStateId::lost;
  const bool stops =
      state_ == OperatorStateId::stopped || (lost && (manual() || parameters_.on_input_lost == OnInputLost::stop));
  const bool straight_on = state_ == OperatorStateId::hold || (lost && parameters_.on_input_lost == OnInputLost::hold &&
                                                               hold_.running(now, parameters_.delta));
  if (stops) {
    wanted.influence = Influence::stop;
  } else if (state_ == OperatorStateId::manual) {
    wanted.influence = Influence::direct;
    wanted.guarded = parameters_.guard == Guard::nearest;
    if (channel_.active()) wanted.u_h = channel_.u_h();
  } else if (is_steering(state_)) {
    wanted.influence = Influence::shared;
    wanted.u_h = channel_.u_h();
    if (parameters_.linear == LinearPolicy::current) wanted.u_h.v = own_v_;
  } else if (straight_on) {
    wanted.influence = Influence::shared;
    wanted.u_h = {hold_.v(), 0.0};
  }
  return wanted;
}

}  // namespace hidwa_local_planner::input
