// SPDX-License-Identifier: BSD-3-Clause
#include "input/operator_state_machine.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/util/words.hpp"

namespace hidwa_local_planner::input {
namespace {

// Times that threads read before they take turns, or that a simulated clock ticks apart, differ by less; a
// larger step back is a clock that was set back.
constexpr double kClockJitter = 0.2;  // [s]

// Longer without a cycle, and nobody drives: a press of the button would hand over what nobody sees.
constexpr double kDriving = 1.0;  // [s]

// Repeating devices send more often. A stop that no message asked for in so long may be ended by others.
constexpr double kUnattended = 1.0;  // [s]

std::string late(double excess, const BacklogGate::Limits& limits) {
  const bool may_settle = excess <= limits.lag_max;
  const bool beyond_settling = !may_settle && limits.lag_max > limits.late;
  std::string text = "it arrived " + worded(excess, 3) + " s later than the link needs at best, more than ";
  text += beyond_settling ? "input_lag_max (" + worded(limits.lag_max, 3) : "input_timeout (" + worded(limits.late, 3);
  text += " s): the link holds messages back";
  if (may_settle) text += " (a delay that stays within 0.1 s for 2 s is accepted)";
  text += ", or the sender's clock runs differently (synchronise the clocks, or leave the stamps empty)";
  if (may_settle) return text;
  return text + ". If that clock stood still or was set, as that of a computer that slept, send nothing for " +
         worded(std::ceil(BacklogGate::proving_gap(excess, limits)), 6) + " s, or restart the sender";
}

std::string silent(double timeout) {
  return "The device fell silent for more than input_timeout (" + worded(timeout, 3) +
         " s) while it steered. If it sends only changes, as joy_node does without autorepeat, set joy_node's "
         "autorepeat_rate to 20, or input_timeout to 0; if it repeats by itself, look at the link.";
}

std::string fault_of_times(const OperatorMessage& message) {
  if (std::isfinite(message.stamp) && std::isfinite(message.received)) return {};
  return "its time is not a finite number: look at the sender";
}

}  // namespace

OperatorStateMachine::OperatorStateMachine(Sources sources) : sources_(std::move(sources)) { configure(Parameters()); }

void OperatorStateMachine::configure(const Parameters& parameters) {
  const bool other_mode = parameters.mode != parameters_.mode;
  parameters_ = parameters;
  channel_.configure(parameters_.input_timeout, parameters_.require_neutral);
  const SourceList::Change change = sources_.configure(source_parameters());
  if (other_mode) {
    restart();
    handover_ = {};
    pauses_.restart();
    stop_.dismiss();  // who stopped the robot did not let go of it; but whoever is gone cannot
  } else if (change != SourceList::Change::none) {
    for (SourceList::Connection& connection : sources_.all()) {
      if (change == SourceList::Change::device) connection.stream.forget_lag();
      connection.stream.demand_neutral();
    }
    expect_new_device();
    stop_.demand_neutral();
  } else {
    channel_.remap(sources_.steering().command());
  }
}

void OperatorStateMachine::set_goalless(bool goalless) {
  if (goalless == goalless_) return;
  goalless_ = goalless;
  handover_.end();
  const bool steered = channel_.active();
  sources_.configure(source_parameters());
  const OperatorCommand command = sources_.steering().command();  // with a goal one axis alone may have counted
  if (goalless && (steered || command.active)) channel_.demand_neutral();
  channel_.remap(command);
}

Parameters OperatorStateMachine::source_parameters() const {
  Parameters parameters = parameters_;
  if (goalless_) parameters.linear = LinearPolicy::axis;
  return parameters;
}

std::string OperatorStateMachine::receive(const OperatorMessage& message) {
  SourceList::Connection* const connection = sources_.listener(message);
  if (connection == nullptr) return {};
  note_arrival(message.received);
  const ParsedMessage parsed = connection->source->parse(message);
  std::string fault = fault_of_times(message);
  if (fault.empty()) fault = parsed.fault;
  bool beside = false;
  if (fault.empty()) fault = admit(*connection, message, parsed.idle, beside);
  // A stop counts from every message, however faulty or late; only one that is in order ends it.
  if (parsed.stop) {
    stop_.take(connection->source->kind().name, message.sender, *parsed.stop, fault.empty(), parameters_, received_);
  }
  if (beside) return {};
  if (fault.empty()) fault = take(*connection, message);
  if (!fault.empty()) ++dropped_;
  connection->fault = fault;
  return fault;
}

void OperatorStateMachine::take_control(bool manual) {
  if (parameters_.mode == OperatorMode::switching) handover_.request(manual);
}

void OperatorStateMachine::stop(bool stop) {
  stop_.request(stop);
  if (!stop) stop_.dismiss();
}

void OperatorStateMachine::heartbeat(double now, const std::optional<double>& clock_ahead) {
  pauses_.expect_heartbeats();
  note_alive(now);
  if (clock_ahead) watch_clock(*clock_ahead);
}

OperatorIntent OperatorStateMachine::update(double now) {
  if (now < std::max(now_, received_) - kClockJitter) set_back(now);
  note_alive(now);
  pauses_.begin_cycle();
  handover_.apply_request(now - now_ < kDriving);
  now_ = std::max(now_, now);
  channel_.check(now_);
  check_steering_source(now_);
  add_sentence(warnings_, stop_.end_dismissed(now_, unattended_after()));
  return control_.update({now_, stop_.requested(), manual(), goalless_, channel_, parameters_});
}

void OperatorStateMachine::debrief(double now, const CycleFeedback& feedback) {
  control_.debrief(now, feedback, parameters_);
}

double OperatorStateMachine::input_age(double now) const {
  return channel_.received_any() ? std::max(0.0, now - channel_.time()) : -1.0;
}

std::string OperatorStateMachine::take_warnings() {
  std::string warnings;
  warnings.swap(warnings_);
  return warnings;
}

std::string OperatorStateMachine::advice() const {
  const double timeout = parameters_.input_timeout;
  const double now = std::max(now_, received_);
  std::string text = sources_.faults();
  add_sentence(text, pauses_.advice(now));
  if (timeout > 0.0) add_sentence(text, stop_.advice(now, unattended_after()));
  if (timeout > 0.0 && channel_.fell_silent(now)) add_sentence(text, silent(timeout));
  add_sentence(text, sources_.link_advice());
  const std::string of_source = sources_.steering().advice();
  if (!of_source.empty()) {
    add_sentence(text, of_source);
  } else if (channel_.waits_for_neutral()) {
    add_sentence(text,
                 "The input does not count until it was neutral once (require_neutral): release the stick and the "
                 "enable button. If nobody touches them, raise dead_zone.");
  }
  return text;
}

void OperatorStateMachine::save(ArchiveWriter& state) const {
  sources_.save(state);
  archive(*this, state);
}

void OperatorStateMachine::load(ArchiveReader& state) {
  sources_.load(state);
  archive(*this, state);
  sources_.configure(source_parameters());
}

void OperatorStateMachine::note_arrival(double received) {
  if (!std::isfinite(received)) return;
  if (received < received_ - kClockJitter) set_back(received);
  received_ = std::max(received_, received);
  note_alive(received);
}

// Whether a well-formed message is live; the fault in words, else empty. `beside`: it is, and nothing but its stop
// counts.
std::string OperatorStateMachine::admit(SourceList::Connection& connection, const OperatorMessage& message, bool idle,
                                        bool& beside) {
  const BacklogGate::Limits limits{parameters_.input_timeout, parameters_.input_lag_max};
  const bool gives_command = connection.source.get() == &sources_.steering();
  const bool steers = gives_command ? channel_.active() : !connection.stream.in_use().idle;
  const bool lost = gives_command && channel_.lost();
  const MessageStream::Use use{idle, steers, lost, channel_.armed()};
  switch (connection.stream.judge(message, use, received_, limits)) {
    case MessageStream::Arrival::late:
      return late(connection.stream.excess(), limits);
    case MessageStream::Arrival::beside:
      beside = true;
      break;
    case MessageStream::Arrival::other_device:
      change_device(connection);
      break;
    case MessageStream::Arrival::new_device:
      expect_new_device();
      break;
    case MessageStream::Arrival::new_clock:
      add_sentence(warnings_, "The clock of the sender on " + connection.source->topic(parameters_).label +
                                  " was set or stood still: from now on its messages count again. Centre the device.");
      channel_.demand_neutral();
      break;
    case MessageStream::Arrival::slower_link:
      channel_.demand_neutral();
      break;
    case MessageStream::Arrival::live:
      break;
  }
  return {};
}

// What a live message says. The fault in words where that is that the device lost what it steers with.
std::string OperatorStateMachine::take(SourceList::Connection& connection, const OperatorMessage& message) {
  const bool steers = connection.source.get() == &sources_.steering();
  if (steers) check_steering_source(received_);
  const SourceReading reading = connection.source->take(message, received_);
  if (!reading.fault.empty()) {
    if (steers) channel_.lose();
    return reading.fault;
  }
  const bool catching_up = connection.stream.catching_up(received_, parameters_.input_timeout);
  if (reading.buttons) take_buttons(*reading.buttons, catching_up);
  if (reading.command && steers) channel_.accept(*reading.command, received_);
  return {};
}

void OperatorStateMachine::take_buttons(const Buttons& buttons, bool catching_up) {
  const bool switching = parameters_.mode == OperatorMode::switching;
  if (switching) handover_.take_button(buttons.toggle, cycles_run() && !catching_up);
  const std::optional<OperatorCommand> command = sources_.steering().take_buttons(buttons, received_);
  if (command) channel_.accept(*command, received_);
}

void OperatorStateMachine::check_steering_source(double now) {
  if (sources_.steering().gone(now)) {
    channel_.lose();
    sources_.steering().lose();
  }
  if (channel_.lost()) sources_.steering().lose();
}

void OperatorStateMachine::expect_new_device() {
  channel_.demand_neutral();
  handover_.forget_button();
  sources_.steering().lose();
}

// A device that is known takes the place of another one that does not steer.
void OperatorStateMachine::change_device(const SourceList::Connection& connection) {
  const MessageStream::Device& device = connection.stream.in_use();
  handover_.forget_button();
  if (device.was_idle) handover_.take_button(false, false);
  if (connection.source.get() != &sources_.steering()) return;
  channel_.demand_neutral(device.armed);
  sources_.steering().lose();
}

void OperatorStateMachine::note_alive(double now) {
  const double pause = pauses_.observe(now);
  if (pause == 0.0) return;
  channel_.exclude_pause(pause);
  for (SourceList::Connection& connection : sources_.all()) connection.source->exclude_pause(pause);
  if (channel_.active() || channel_.lost()) pauses_.report(pause, now);
}

// What a clock that was set forward adds to every lag is no lag. Back: see set_back().
void OperatorStateMachine::watch_clock(double ahead) {
  const double step = clock_ahead_ ? ahead - *clock_ahead_ : 0.0;
  clock_ahead_ = ahead;
  if (step <= kClockJitter) return;
  for (SourceList::Connection& connection : sources_.all()) connection.stream.add_to_lag(step);
  channel_.demand_neutral();
  add_sentence(warnings_, "The robot's clock was set forward by " + worded(step, 3) +
                              " s. Centre the device. Let the clocks of the robot agree before it drives.");
}

// Who stopped the robot or took control did so in words or by a button, and sees no clock.
void OperatorStateMachine::set_back(double now) {
  restart();
  stop_.set_back(now);
  handover_.set_back();
  pauses_.set_back();
}

// All but the stop, who has control, and what is known of pauses.
void OperatorStateMachine::restart() {
  sources_.reset();
  channel_.reset();
  control_ = {};
  now_ = received_ = kNever;
}

bool OperatorStateMachine::cycles_run() const { return std::abs(received_ - now_) < kDriving; }

double OperatorStateMachine::unattended_after() const { return std::max(kUnattended, parameters_.input_timeout); }

}  // namespace hidwa_local_planner::input
