// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "input/operator_state_machine.hpp"
#include "input/stick_reading.hpp"

namespace hidwa_local_planner::input {

/// One thing that happened to the state machine.
struct Event {
  enum class Kind { message, cycle, new_goal, say_stop, say_control, listens };
  Kind kind = Kind::cycle;
  double time = 0.0;       // [s]
  StickMessage message;    // messages: two axes; buttons: toggle, stop; no enable button
  CycleFeedback feedback;  // cycles: what the cycle came to
  bool said = false;       // words: stop, or take control
};

/// The slow, obvious twin of OperatorStateMachine with a stick (modes joystick and switching): keeps no state
/// of its own, but answers every question by looking through the whole history. Times never go back, stamps
/// neither.
class Twin {
 public:
  Twin(std::vector<Event> history, const Parameters& parameters);
  /// How often a link was taken to be slower from then on, and the planner stood still.
  std::size_t slower_links() const { return slower_.size(); }
  std::size_t pauses() const { return pauses_.size(); }
  /// The intent of every cycle, in order.
  std::vector<OperatorIntent> intents() const;
  std::uint32_t dropped() const;

 private:
  struct Heard {
    std::size_t event = 0;
    double time = 0.0;
    bool deflected = false;
    bool toggle = false;
    Twist2 u_h;
  };
  struct Cycle {
    std::size_t event = 0;
    double time = 0.0;
    OperatorStateId state = OperatorStateId::autonomy;
    CycleFeedback feedback;
  };
  enum class Device { quiet, active, lost };

  /// Nothing of the planner was at work.
  struct Pause {
    std::size_t event = 0;  // that ended it
    double length = 0.0;    // [s]
  };
  struct Pauses {
    double longest = 0.0, sum = 0.0;  // [s]
  };

  bool is_message(std::size_t event) const { return history_[event].kind == Event::Kind::message; }
  bool usable(std::size_t event) const;
  bool readable(const StickMessage& message) const;
  void judge_lags();
  void find_pauses();
  void follow_stops();
  Pauses pauses_between(std::size_t after, std::size_t up_to) const;
  std::optional<std::size_t> last_heard(std::size_t before_event) const;
  bool broken(std::size_t first, std::size_t last) const;
  std::optional<std::size_t> centred_before(std::size_t heard) const;
  bool slower_between(std::size_t first, std::size_t last) const;
  bool counts(std::size_t heard) const;
  bool silent(std::size_t heard, std::size_t event) const;
  Device device(std::size_t event) const;
  bool switching() const { return p_.mode == OperatorMode::switching; }
  bool pull_counts() const;
  bool held_up(std::size_t heard) const;
  bool press(std::size_t heard) const;
  std::optional<std::size_t> cycle_before(std::size_t event) const;
  bool manual(std::size_t event) const;
  bool latched(const std::vector<Cycle>& past, std::size_t event) const;
  bool blocked(const std::vector<Cycle>& past, std::size_t event, double now) const;
  std::optional<double> held_velocity(const std::vector<Cycle>& past, std::size_t event, double now) const;

  std::vector<Event> history_;
  Parameters p_;
  std::vector<Heard> heard_;
  std::vector<bool> late_;           // of every event: a message that was held back
  std::vector<std::size_t> slower_;  // messages from which on the link was slower
  std::vector<Pause> pauses_;
  std::vector<bool> stopped_;  // before every event
};

}  // namespace hidwa_local_planner::input
