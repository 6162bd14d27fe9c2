// SPDX-License-Identifier: BSD-3-Clause
// A link that is cut at full deflection, for everything that can steer.
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "person.hpp"

namespace hidwa_local_planner::input {
namespace {

constexpr double kPeriod = 0.05;    // of the cycle and of the messages [s]
constexpr double kTimeout = 0.5;    // input_timeout [s]
constexpr double kDelta = 2.0;      // [s]
constexpr double kRounding = 1e-9;  // of the times below [s]

enum class Deflection { none, begins, full };

/// Something that gives an operator command or takes control; fully deflected it asks for 0.5 m/s and 1 rad/s.
struct Device {
  std::string name;
  Parameters p;
  void (*send)(Person&, double received, double stamp, Deflection);
  unsigned messages = 1;  // that it sends at a time
};

void send_stick(Person& person, double received, double stamp, Deflection deflection) {
  const float axis = deflection == Deflection::none ? 0.0F : 1.0F;
  person.machine.receive(stamped(stamp, stick_at(received, axis, axis)));
}

void send_twist(Person& person, double received, double stamp, Deflection deflection) {
  const double full = deflection == Deflection::none ? 0.0 : 1.0;
  person.machine.receive(stamped(stamp, twist_at(received, 0.5 * full, full)));
}

void send_button(Person& person, double received, double stamp, Deflection deflection) {
  const bool held = deflection != Deflection::none;
  person.machine.receive(stamped(stamp, held ? button_at(received, 0) : stick_at(received, 0.0F)));
}

// The hand's pose at the press of the clutch is the origin.
void send_hand(Person& person, double received, double stamp, Deflection deflection) {
  send_button(person, received, stamp, deflection);
  person.machine.receive(stamped(stamp, hand_at(received, 1.0, deflection == Deflection::full ? 0.25 : 0.0, 1.0)));
}

Device stick() { return {"stick", Parameters(), send_stick}; }

Device twist() {
  Device device{"Twist", Parameters(), send_twist};
  device.p.twist_topic = "operator_twist";
  return device;
}

Device hand() {
  Device device{"hand", in_mode(OperatorMode::gesture), send_hand, 2};
  device.p.gesture_range = 0.2;
  return device;
}

Device toggle() { return {"toggle presses", in_mode(OperatorMode::switching), send_button}; }

struct Steerer {
  Device device;
  std::string name = device.name;
  void (*after_cut)(Person&, double) = [](Person&, double) {};  // sends what is still heard
  double heard_on = 0.0;                                        // time after the cut in which messages still come [s]
  bool manual() const { return device.p.mode == OperatorMode::switching; }
};

std::vector<Steerer> steerers() {
  Steerer on_axis{stick(), "stick on both axes"};
  on_axis.device.p.linear = LinearPolicy::axis;
  Steerer by_twist{twist()};
  by_twist.after_cut = [](Person& person, double time) { person.stick(time, 0.0F); };  // another link
  Steerer no_poses{hand(), "hand whose poses are cut"};
  no_poses.after_cut = [](Person& person, double time) { person.button(time, kClutch); };
  Steerer no_clutch{hand(), "hand whose clutch is cut"};
  no_clutch.after_cut = [](Person& person, double time) { person.hand(time, 0.4); };
  no_clutch.heard_on = kTimeout;  // the hand, until the silence of its clutch is noticed
  Steerer manual{stick(), "stick in control"};
  Steerer manual_twist{twist(), "Twist in control"};
  for (Steerer* s : {&manual, &manual_twist}) s->device.p.mode = OperatorMode::switching;
  return {{stick()}, on_axis, by_twist, {hand()}, no_poses, no_clutch, manual, manual_twist};
}

/// For how long each command counted after the cut, and what holds 8 s later.
struct Cut {
  double omega = 0.0;  // [s]
  double v = 0.0;      // [s]
  OperatorIntent last;
};

Cut cut_link(const Steerer& s, OnInputLost policy, double phase) {
  Person person(s.device.p);
  person.p.on_input_lost = policy;
  person.configure();
  s.device.send(person, 1.0, 0.0, Deflection::none);
  person.cycle(1.0);
  person.machine.take_control(true);  // in mode switching
  double cut = 0.0;
  OperatorIntent intent;
  for (int i = 1; i <= 20; ++i) {
    cut = 1.0 + kPeriod * i;
    s.device.send(person, cut, 0.0, i == 1 ? Deflection::begins : Deflection::full);
    intent = person.cycle(cut + phase);
  }
  EXPECT_EQ(intent.state, s.manual() ? State::manual : State::shared);
  EXPECT_EQ(intent.u_h.v, 0.5);
  EXPECT_EQ(intent.u_h.omega, 1.0);
  Cut result;
  for (int i = 21; i <= 180; ++i) {
    const double now = 1.0 + kPeriod * i + phase;
    s.after_cut(person, now - phase);
    result.last = person.cycle(now);
    const bool counts = result.last.influence == Influence::shared || result.last.influence == Influence::direct;
    // A command counts until the next cycle replaces it.
    if (counts && result.last.u_h.omega != 0.0) result.omega = now - cut + kPeriod;
    if (counts && result.last.u_h.v != 0.0) result.v = now - cut + kPeriod;
  }
  return result;
}

TEST(CutLink, EverySteererUnderEveryPolicy) {
  for (const Steerer& s : steerers()) {
    for (const OnInputLost policy : {OnInputLost::hold, OnInputLost::stop, OnInputLost::autonomy}) {
      for (const double phase : {0.0, 0.001, 0.025, 0.049}) {
        SCOPED_TRACE(s.name + ", policy " + std::to_string(static_cast<int>(policy)));
        const Cut cut = cut_link(s, policy, phase);
        EXPECT_LE(cut.omega, kTimeout + kPeriod + kRounding);
        EXPECT_GT(cut.omega, kTimeout);  // and not less: the person may rely on it
        if (policy == OnInputLost::hold && !s.manual()) {
          // Straight on for delta from the last active input: at most delta longer than the turn.
          EXPECT_LE(cut.v, s.heard_on + kDelta + kPeriod + kRounding);
          EXPECT_GT(cut.v, s.heard_on + kDelta - kPeriod);
        } else {
          EXPECT_LE(cut.v, kTimeout + kPeriod + kRounding);
        }
        EXPECT_EQ(cut.last.state, State::lost);
        const bool stops = s.manual() || policy == OnInputLost::stop;
        EXPECT_EQ(cut.last.influence, stops ? Influence::stop : Influence::none);
      }
    }
  }
}

TEST(CutLink, ALongTimeoutAndAShortDeltaLeaveNothingToHold) {
  for (Steerer& s : steerers()) {
    SCOPED_TRACE(s.name);
    s.device.p.delta = 0.2;
    const double longest = s.heard_on > 0.0 ? s.heard_on + s.device.p.delta : kTimeout;
    EXPECT_LE(cut_link(s, OnInputLost::hold, 0.02).v, longest + kPeriod + kRounding);
  }
}

/// How a device is deflected that sends from 1 s on; from 2 s to 5 s its link is down.
using When = Deflection (*)(double sent);

Deflection for_long(double sent) {
  if (sent < 2.08 || sent > 4.92) return Deflection::none;
  return sent < 2.12 ? Deflection::begins : Deflection::full;
}

// Seven times, one of them in the last half second.
Deflection in_turn(double sent) {
  const int step = static_cast<int>((sent - 2.0) / 0.2 + 1e-6);
  return step % 2 == 1 ? for_long(sent) : Deflection::none;
}

/// What was sent while the link was down comes at once when it is up again. `clock` [s]: the sender's minus ours;
/// without one it leaves its stamps empty. `spread` [s]: between two messages of the burst, with a cycle after each; 0:
/// none.
void expect_no_effect(const Device& device, When when, const std::optional<double>& clock, double spread) {
  SCOPED_TRACE(device.name + (clock ? ", the sender's clock " + std::to_string(*clock) : ", without stamps"));
  Person person(device.p);
  const auto send = [&](double sent, double received) {
    device.send(person, received, clock ? sent + *clock : 0.0, when(sent));
  };
  for (int i = 0; i <= 20; ++i) {
    const double time = 1.0 + 0.05 * i;
    send(time, time);
    ASSERT_EQ(person.cycle(time).state, State::autonomy);
  }
  for (int i = 0; i < 58; ++i) ASSERT_EQ(person.cycle(2.05 + 0.05 * i).state, State::autonomy);
  double now = 5.0;
  for (int i = 1; i <= 60; ++i) {
    send(2.0 + 0.05 * i, now);
    now += spread;
    // The last half second is not older than input_timeout: it may count.
    if (spread > 0.0 && i < 49) {
      ASSERT_EQ(person.cycle(now).state, State::autonomy) << i;
    }
  }
  // Lags of 2.95 ... 0.55 s at 20 Hz: 49 messages. Where the burst is spread, the next one has more than 0.5 s, too.
  const unsigned late = clock ? (spread > 0.0 ? 50U : 49U) : 0U;
  EXPECT_EQ(person.machine.dropped(), late * device.messages);
  for (int i = 1; i <= 60; ++i) {
    send(5.0 + 0.05 * i, 5.0 + 0.05 * i);
    const OperatorIntent intent = person.cycle(5.0 + 0.05 * i);
    // A cycle may have seen the last half second and holds after it.
    const bool held = spread > 0.0 && intent.state == State::hold;
    ASSERT_TRUE(intent.state == State::autonomy || held) << to_string(intent.state);
  }
  EXPECT_FALSE(person.machine.manual());
}

TEST(CutLink, WhatALinkHeldBackHasNoEffect) {
  for (const Device& device : {stick(), twist(), hand(), toggle()}) {
    const When when = device.send == send_button ? in_turn : for_long;
    expect_no_effect(device, when, std::nullopt, 0.0);
    for (const double clock : {0.0, -0.7, 1e5}) expect_no_effect(device, when, clock, 0.0);
    expect_no_effect(device, when, 0.0, 1e-4);  // nor has it between its messages
  }
  // Without stamps nobody can tell a deflection's age, but a press that was held back is known by its hurry.
  expect_no_effect(toggle(), in_turn, std::nullopt, 1e-4);
}

}  // namespace
}  // namespace hidwa_local_planner::input
