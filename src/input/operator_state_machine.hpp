// SPDX-License-Identifier: BSD-3-Clause
// From an operator's messages to the intent of a cycle.
//
// The way of a message, receive():
// 1. the source that takes its kind parses it (OperatorSource);
// 2. its stream finds another device and what the link held back (MessageStream);
// 3. its stop counts in any case (StopRequest); then faulty and late messages are dropped;
// 4. its buttons hand control over (ControlHandover) or clutch the source that steers;
// 5. where its source steers, its command goes on to the InputChannel, which knows neutral and silence.
//
// A cycle, update(): the machine notices silence, and ControlState makes the operator intent.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "hidwa_local_planner/core/operator_intent.hpp"
#include "hidwa_local_planner/core/parameters.hpp"
#include "hidwa_local_planner/core/util/archive.hpp"
#include "input/control_handover.hpp"
#include "input/control_state.hpp"
#include "input/input_channel.hpp"
#include "input/pause_detector.hpp"
#include "input/source_list.hpp"
#include "input/stop_request.hpp"

namespace hidwa_local_planner::input {

/// Turns an operator's messages into states and intents. Knows no clock and no kind of device: time is always an
/// argument [s], and each kind of device is an OperatorSource. Not thread-safe.
class OperatorStateMachine {
 public:
  explicit OperatorStateMachine(Sources sources = built_in_sources());

  /// Takes a valid set of parameters; at any time. Another mode starts afresh. After another topic, other
  /// axes or another enable button the device must be seen neutral. Everything else takes effect with the next
  /// update(), without an interruption.
  void configure(const Parameters& parameters);
  /// The sources by `parameters`, which need not be in force.
  std::vector<ListedSource> sources(const Parameters& parameters) const { return sources_.listed(parameters); }

  /// A message arrived. Returns the fault in words when it was dropped, empty when it was taken or when
  /// nobody listens to its kind.
  std::string receive(const OperatorMessage& message);
  /// In words instead of by a button: hand control over (mode switching), or stop for as long as it is true.
  /// As with the button, control is handed over only while cycles run, and by the next of them.
  void take_control(bool manual);
  /// False also ends the stops of devices that are gone.
  void stop(bool stop);
  /// The thread that takes messages is at work. Told at least every 0.1 s, the machine tells a pause of the whole
  /// planner from a silence of the device. Never told, it knows no pauses. `clock_ahead`: how far the clock by which
  /// senders' stamps are judged is ahead of one that nobody can set [s]; by it the machine notices that it was set
  /// forward.
  void heartbeat(double now, const std::optional<double>& clock_ahead = std::nullopt);
  /// The planner stood still since the last cycle: what arrived meanwhile should be taken before the next.
  bool paused_since_last_cycle(double now) const { return pauses_.since_last_cycle(now); }

  /// What the operator asks for now. Call once a cycle, before plan(). Where `now` went back, steering and holding end,
  /// but a stop goes on. An operator who has control keeps it; the robot brakes until their next message.
  OperatorIntent update(double now);
  /// The operator gives input that counts.
  bool steers() const { return channel_.active(); }
  /// Whether the host has no goal: then whoever steers drives (MANUAL), in every mode but off, and both axes of their
  /// device count. Whoever steers when a goal ends must be seen neutral before they drive on. Control that was taken
  /// ends with the goal.
  void set_goalless(bool goalless);
  bool goalless() const { return goalless_; }
  /// What became of it. Call once a cycle, after plan().
  void debrief(double now, const CycleFeedback& feedback);
  /// A new goal: the old one's latch no longer keeps the operator from steering, and a blockage is measured
  /// anew. Steering, holding and a loss go on: the goal changed, the hand on the stick did not.
  void new_goal() { control_.new_goal(); }

  /// That of the cycle just run.
  OperatorStateId state() const { return control_.state(); }
  /// Mode `switching`: the operator has taken control and has not given it back. The state may still be LOST or
  /// STOPPED.
  bool manual() const { return parameters_.mode == OperatorMode::switching && !goalless_ && handover_.manual(); }
  /// The node whose device gives the operator command; empty where none does.
  const std::string& sender() const { return sources_.sender(); }
  double input_age(double now) const;                 // [s]; negative when none was accepted yet
  std::uint32_t dropped() const { return dropped_; }  // messages dropped since the start
  /// The planner stood still, and that is why the input is lost at `now` [s].
  bool lost_by_pauses(double now) const { return channel_.lost_by_pauses(now); }
  /// What a log should tell, since the last call; mostly empty.
  std::string take_warnings();
  /// Sentences with the remedy where something about the input needs attention; empty where nothing does.
  std::string advice() const;

  /// All that the next update() depends on besides the parameters. A machine with the same parameters that loads it
  /// gives the same intent. What only judges future messages (their sender, their lag) is not included.
  void save(ArchiveWriter& state) const;
  void load(ArchiveReader& state);

 private:
  template <typename Self, typename Archive>
  static void archive(Self& self, Archive& io) {
    io(self.stop_, self.handover_, self.channel_, self.control_, self.pauses_, self.now_, self.received_,
       self.goalless_);
  }
  Parameters source_parameters() const;
  void note_arrival(double received);
  std::string admit(SourceList::Connection& connection, const OperatorMessage& message, bool idle, bool& beside);
  std::string take(SourceList::Connection& connection, const OperatorMessage& message);
  void take_buttons(const Buttons& buttons, bool catching_up);
  void check_steering_source(double now);
  void expect_new_device();
  void change_device(const SourceList::Connection& connection);
  void note_alive(double now);
  void watch_clock(double ahead);
  void set_back(double now);
  void restart();
  bool cycles_run() const;
  double unattended_after() const;

  Parameters parameters_;
  SourceList sources_;
  StopRequest stop_;
  ControlHandover handover_;
  InputChannel channel_;  // of what steers
  ControlState control_;
  PauseDetector pauses_;
  // Newest times [s]: of a cycle, of any message.
  static constexpr double kNever = -std::numeric_limits<double>::infinity();
  double now_ = kNever;
  double received_ = kNever;
  std::optional<double> clock_ahead_;  // told last [s]
  bool goalless_ = false;
  std::string warnings_;
  std::uint32_t dropped_ = 0;
};

}  // namespace hidwa_local_planner::input
