// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>

#include "hidwa_local_planner/core/operator_intent.hpp"
#include "hidwa_local_planner/core/parameters.hpp"
#include "hidwa_local_planner/core/types.hpp"
#include "hidwa_local_planner/core/util/archive.hpp"
#include "hidwa_local_planner/core/util/lasting.hpp"
#include "hidwa_local_planner/input/control_switch.hpp"
#include "hidwa_local_planner/input/gesture_source.hpp"
#include "hidwa_local_planner/input/hold.hpp"
#include "hidwa_local_planner/input/input_channel.hpp"
#include "hidwa_local_planner/input/input_rhythm.hpp"
#include "hidwa_local_planner/input/last_heard.hpp"
#include "hidwa_local_planner/input/message_stream.hpp"
#include "hidwa_local_planner/input/signs_of_life.hpp"
#include "hidwa_local_planner/input/stick_message.hpp"
#include "hidwa_local_planner/input/stick_source.hpp"
#include "hidwa_local_planner/input/stop_request.hpp"
#include "hidwa_local_planner/input/transition.hpp"
#include "hidwa_local_planner/input/twist_source.hpp"

namespace hidwa_local_planner::input {

/// What the cycle told the person: needed to know when a hold is refused and when the robot is blocked.
struct CycleFeedback {
  bool own_command_refused = false;  // u_h itself was refused
  bool at_rest = false;              // the command was zero and the robot stands
  bool goal_latched = false;
  Twist2 command;   // what was sent [m/s, rad/s]
  Twist2 velocity;  // measured [m/s, rad/s]
};

/// Turns a person's messages into states and intents. Knows no clock and no message type: time is always an
/// argument [s]. Not thread-safe.
///
/// The way of a message: its stream (another device, held back) -> its source, which makes a wish of it ->
/// InputChannel. One stream steers: the stick, or where there is a twist_topic the Twist, or in mode gesture
/// the hand. The stick's buttons count beside it.
/// The way of a cycle: facts -> next_state -> intent. States change in update() only, so state() is that of
/// the cycle just run, and only input that a cycle has seen can be released: what comes and goes between two
/// cycles has no effect.
class OperatorStateMachine {
 public:
  OperatorStateMachine();

  /// Takes a valid set of parameters; at any time. Another mode starts afresh. After another topic, other
  /// axes or another enable button the stick must be seen centred. Everything else takes effect with the next
  /// update(), without an interruption.
  void configure(const Parameters& parameters);
  /// A message arrived. Returns the fault in words when it was dropped, empty when it was taken or when
  /// nobody listens to its kind.
  std::string receive(const StickMessage& message);
  std::string receive(const TwistMessage& message);
  std::string receive(const HandMessage& message);
  /// In words instead of by a button: hand control over (mode switching), or stop for as long as it is true.
  /// As with the button, control is handed over only while cycles run, and by the next of them.
  void take_control(bool manual);
  /// False also lets go of the stops of devices that are gone.
  void stop(bool stop);
  /// The thread that takes messages is at work. Told at least every 0.1 s, the machine tells a pause of the whole
  /// planner from a silence of the device. Never told, it knows no pauses.
  void listens(double now);
  /// The planner stood still since the last cycle: what arrived meanwhile should be taken before the next.
  bool behind(double now) const { return behind_ || life_.still_for(now) > 0.0; }
  /// What the person wants now. Call once a cycle, before plan(). Where `now` went back, steering and holding end, a
  /// stop goes on, and whoever has control keeps it but must be heard anew: until then the robot brakes.
  OperatorIntent update(double now);
  /// What became of it. Call once a cycle, after plan().
  void debrief(double now, const CycleFeedback& feedback);
  /// A new goal: the old one's latch no longer keeps the person from steering, and a blockage is measured
  /// anew. Steering, holding and a loss go on: the goal changed, the hand on the stick did not.
  void new_goal();
  /// As at the start, except for dropped(): AUTONOMY, and the stick must be seen centred.
  void reset();

  OperatorStateId state() const { return state_; }
  /// SW: the person has taken control and has not given it back, whatever the state: a loss or a stop may be
  /// on top of it.
  bool manual() const { return parameters_.mode == OperatorMode::switching && control_.manual(); }
  double input_age(double now) const;                 // [s]; negative when none was accepted yet
  std::uint32_t dropped() const { return dropped_; }  // messages dropped since the start
  /// The planner stood still, and that is why the input is lost at `now` [s].
  bool lost_by_pauses(double now) const { return channel_.lost_by_pauses(now); }
  /// What a log should tell, since the last call; mostly empty.
  std::string take_news();
  /// A sentence with the remedy where something about the input needs attention; empty where nothing does.
  std::string advice() const;

  /// All that the next update() depends on besides the parameters: with the same ones, a machine that loads it says the
  /// same. What only judges messages to come (who sent, how late they are) is not in it.
  void save(ArchiveWriter& state) const { archive(*this, state); }
  void load(ArchiveReader& state) { archive(*this, state); }

 private:
  template <typename Self, typename Archive>
  static void archive(Self& self, Archive& io) {
    io(self.reading_, self.twist_.u, self.gesture_, self.stop_, self.control_, self.channel_, self.hold_, self.blocked_,
       self.state_, self.goal_latched_, self.commanded_, self.own_v_, self.said_control_, self.catching_up_, self.life_,
       self.now_, self.received_, self.stick_, self.stick_back_, self.hand_);
  }
  void set_back(double now);
  void live(double now);
  void tell(const std::string& sentence);
  bool steered_by_stick() const;
  bool cycles_run() const;
  void begin(double received);
  std::string judge(const StickMessage& message, StickReading& reading);
  std::string admit(MessageStream& stream, const Envelope& envelope);
  void hear_stick();
  void read_buttons();
  void feed(const Wish& wish);
  std::string drop(const std::string& fault, std::string& last_fault);
  void new_device();
  void watch_hand(double now);
  void begin_hold();
  Wish present_wish() const;
  Facts facts() const;
  OperatorIntent intent(double now) const;

  Parameters parameters_;
  MessageStream sticks_, twists_, hands_;
  StickReading reading_;  // of the newest stick message
  TwistMessage twist_;    // the newest
  GestureSource gesture_;
  StopRequest stop_;
  ControlSwitch control_;
  InputChannel channel_;  // of what steers
  InputRhythm rhythm_;    // of what steers
  Hold hold_;
  Lasting blocked_;  // refusals have held the steered robot at rest
  OperatorStateId state_ = OperatorStateId::autonomy;
  bool goal_latched_ = false;
  bool commanded_ = false;            // a command is known
  double own_v_ = 0.0;                // the robot's: what was commanded last [m/s]
  std::optional<bool> said_control_;  // in words, since the last cycle
  bool catching_up_ = false;          // the newest stick message may have been held back
  SignsOfLife life_;                  // of cycles and of the thread that takes messages
  bool behind_ = false;               // a pause ended since the last cycle
  // Newest times [s]: of a cycle, any message, the stick's that ended its last silence.
  static constexpr double kNever = -std::numeric_limits<double>::infinity();
  double now_ = kNever;
  double received_ = kNever;
  double stick_back_ = kNever;
  LastHeard stick_, hand_;
  double pause_ = 0.0;  // the newest one worth telling [s]; 0: none lately
  double paused_at_ = kNever;
  std::string news_;
  std::uint32_t dropped_ = 0;
  std::string stick_fault_, twist_fault_, hand_fault_;  // of the last one; empty where it was taken
};

}  // namespace hidwa_local_planner::input
