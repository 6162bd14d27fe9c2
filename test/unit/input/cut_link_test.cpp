// SPDX-License-Identifier: BSD-3-Clause
// A link that is cut at full deflection, for everything that can steer.
#include <functional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "person.hpp"

namespace hidwa_local_planner::input {
namespace {

using State = OperatorStateId;
using Send = std::function<void(Person&, double)>;
constexpr double kPeriod = 0.05;    // of the cycle and of the messages [s]
constexpr double kTimeout = 0.5;    // input_timeout [s]
constexpr double kDelta = 2.0;      // [s]
constexpr double kRounding = 1e-9;  // of the times below [s]

struct Steerer {
  std::string name;
  Parameters p;
  Send at_rest;    // no input
  Send full;       // fully deflected
  Send after_cut;  // what is still heard
  bool manual = false;
  double heard_on = 0.0;  // what counts is still heard for so long [s]
};

Steerer by_stick() {
  Steerer s;
  s.name = "stick";
  s.at_rest = [](Person& person, double time) { person.stick(time, 0.0F); };
  s.full = [](Person& person, double time) { person.stick(time, 1.0F, 1.0F); };
  s.after_cut = [](Person&, double) {};
  return s;
}

Steerer by_twist() {
  Steerer s;
  s.name = "Twist";
  s.p.twist_topic = "operator_twist";
  s.at_rest = [](Person& person, double time) { person.twist(time, 0.0, 0.0); };
  s.full = [](Person& person, double time) { person.twist(time, 0.5, 1.0); };
  s.after_cut = [](Person& person, double time) { person.stick(time, 0.0F); };  // another link
  return s;
}

Steerer by_hand() {
  Steerer s;
  s.name = "hand";
  s.p.mode = OperatorMode::gesture;
  s.p.gesture_range = 0.2;
  s.at_rest = [](Person& person, double time) {
    person.stick(time, 0.0F);
    person.hand(time, 0.0);
  };
  s.full = [](Person& person, double time) {
    person.button(time, 0);
    person.hand(time, time < 1.07 ? 0.0 : 0.25);  // the first one is the origin
  };
  s.after_cut = [](Person&, double) {};
  return s;
}

std::vector<Steerer> steerers() {
  Steerer on_axis = by_stick();
  on_axis.name = "stick on both axes";
  on_axis.p.linear = LinearPolicy::axis;
  Steerer no_poses = by_hand();
  no_poses.name = "hand whose poses are cut";
  no_poses.after_cut = [](Person& person, double time) { person.button(time, 0); };
  Steerer no_clutch = by_hand();
  no_clutch.name = "hand whose clutch is cut";
  no_clutch.heard_on = kTimeout;  // the hand, until the silence of its clutch is noticed
  no_clutch.after_cut = [](Person& person, double time) { person.hand(time, 0.4); };
  Steerer manual = by_stick();
  manual.name = "stick in control";
  manual.manual = true;
  Steerer manual_twist = by_twist();
  manual_twist.name = "Twist in control";
  manual_twist.manual = true;
  for (Steerer* s : {&manual, &manual_twist}) s->p.mode = OperatorMode::switching;
  return {by_stick(), on_axis, by_twist(), by_hand(), no_poses, no_clutch, manual, manual_twist};
}

/// For how long each command counted after the cut, and what holds 8 s later.
struct Cut {
  double omega = 0.0;  // [s]
  double v = 0.0;      // [s]
  OperatorIntent last;
};

Cut cut_link(const Steerer& s, OnInputLost policy, double phase) {
  Person person(s.p);
  person.p.on_input_lost = policy;
  person.machine.configure(person.p);
  s.at_rest(person, 1.0);
  person.cycle(1.0);
  if (s.manual) person.machine.take_control(true);
  double cut = 0.0;
  OperatorIntent intent;
  for (int i = 1; i <= 20; ++i) {
    cut = 1.0 + kPeriod * i;
    s.full(person, cut);
    intent = person.cycle(cut + phase);
  }
  EXPECT_EQ(intent.state, s.manual ? State::manual : State::shared);
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
        if (policy == OnInputLost::hold && !s.manual) {
          // Straight on for delta from the last active input: at most delta longer than the turn.
          EXPECT_LE(cut.v, s.heard_on + kDelta + kPeriod + kRounding);
          EXPECT_GT(cut.v, s.heard_on + kDelta - kPeriod);
        } else {
          EXPECT_LE(cut.v, kTimeout + kPeriod + kRounding);
        }
        EXPECT_EQ(cut.last.state, State::lost);
        const bool stops = s.manual || policy == OnInputLost::stop;
        EXPECT_EQ(cut.last.influence, stops ? Influence::stop : Influence::none);
      }
    }
  }
}

TEST(CutLink, ALongTimeoutAndAShortDeltaLeaveNothingToHold) {
  for (Steerer& s : steerers()) {
    SCOPED_TRACE(s.name);
    s.p.delta = 0.2;
    const double longest = s.heard_on > 0.0 ? s.heard_on + s.p.delta : kTimeout;
    EXPECT_LE(cut_link(s, OnInputLost::hold, 0.02).v, longest + kPeriod + kRounding);
  }
}

/// What is sent while the link is down comes at once when it is up again: input of 2.8 s between no input.
struct Burst {
  std::string name;
  Parameters p;
  // Sends what was sent at `sent` [s], to arrive at `received` [s]; `stamp`: 0 for none.
  std::function<void(Person&, double sent, double received, double stamp)> send;
};

bool deflected(double sent) { return sent > 2.08 && sent < 4.92; }

StickMessage stick_sent(double received, double stamp, float angular, int button = 0) {
  StickMessage message = stick_at(received, angular);
  message.buttons[0] = button;
  message.stamp = stamp;
  return message;
}

std::vector<Burst> bursts() {
  Burst stick;
  stick.name = "stick";
  stick.send = [](Person& person, double sent, double received, double stamp) {
    person.machine.receive(stick_sent(received, stamp, deflected(sent) ? 1.0F : 0.0F));
  };
  Burst twist;
  twist.name = "Twist";
  twist.p.twist_topic = "operator_twist";
  twist.send = [](Person& person, double sent, double received, double stamp) {
    TwistMessage message = twist_at(received, deflected(sent) ? 0.5 : 0.0, 0.0);
    message.stamp = stamp;
    person.machine.receive(message);
  };
  Burst hand;
  hand.name = "hand";
  hand.p.mode = OperatorMode::gesture;
  hand.send = [](Person& person, double sent, double received, double stamp) {
    person.machine.receive(stick_sent(received, stamp, 0.0F, deflected(sent) ? 1 : 0));
    HandMessage message = hand_at(received, 0.0, deflected(sent - 0.1) ? 0.25 : 0.0, 1.0);
    message.stamp = stamp;
    person.machine.receive(message);
  };
  Burst toggles;  // seven presses, one of them in the last half second
  toggles.name = "toggle presses";
  toggles.p.mode = OperatorMode::switching;
  toggles.send = [](Person& person, double sent, double received, double stamp) {
    const int step = static_cast<int>((sent - 2.0) / 0.2 + 1e-6);
    const bool held = deflected(sent) && step % 2 == 1;
    person.machine.receive(stick_sent(received, stamp, 0.0F, held ? 1 : 0));
  };
  return {stick, twist, hand, toggles};
}

// `spread` [s]: between two messages of the burst, with a cycle after each; 0: none.
void expect_no_effect(const Burst& burst, bool stamps, double spread) {
  Person person(burst.p);
  const auto send = [&](double sent, double received) { burst.send(person, sent, received, stamps ? sent : 0.0); };
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
  for (int i = 1; i <= 60; ++i) {
    send(5.0 + 0.05 * i, 5.0 + 0.05 * i);
    const OperatorIntent intent = person.cycle(5.0 + 0.05 * i);
    // A cycle may have seen the last half second and holds after it.
    const bool held = spread > 0.0 && intent.state == State::hold;
    ASSERT_TRUE(intent.state == State::autonomy || held) << to_string(intent.state);
  }
  EXPECT_FALSE(person.machine.manual());
  if (stamps) {
    EXPECT_GE(person.machine.dropped(), 49U);
  }  // lags of 2.95 ... 0.55 s at 20 Hz
}

TEST(CutLink, WhatALinkHeldBackHasNoEffect) {
  for (const Burst& burst : bursts()) {
    for (const bool stamps : {true, false}) {
      SCOPED_TRACE(burst.name + (stamps ? ", stamped" : ", without stamps"));
      expect_no_effect(burst, stamps, 0.0);
    }
  }
}

TEST(CutLink, WhatALinkHeldBackHasNoEffectBetweenItsMessagesEither) {
  for (const Burst& burst : bursts()) {
    SCOPED_TRACE(burst.name);
    expect_no_effect(burst, true, 1e-4);
  }
}

// Without stamps nobody can tell a deflection's age, but a press that was held back is known by its hurry.
TEST(CutLink, HeldBackPressesWithoutStampsHaveNoEffectBetweenCycles) {
  const Burst toggles = bursts().back();
  ASSERT_EQ(toggles.p.mode, OperatorMode::switching);
  expect_no_effect(toggles, false, 1e-4);
}

TEST(CutLink, HeldBackPressesDoNotGiveControlBackEither) {
  Parameters p;
  p.mode = OperatorMode::switching;
  Person person(p);
  person.stick(1.0, 0.0F);
  person.cycle(1.0);
  person.machine.take_control(true);
  EXPECT_EQ(person.cycle(1.05).state, State::manual);
  for (int i = 0; i < 60; ++i) person.cycle(1.1 + 0.05 * i);
  for (const int held : {0, 1, 0}) person.machine.receive(stick_sent(4.1, 0.0, 0.0F, held));
  EXPECT_EQ(person.cycle(4.1).state, State::manual);
  person.machine.receive(stick_sent(4.3, 0.0, 0.0F, 0));
  person.machine.receive(stick_sent(4.35, 0.0, 0.0F, 1));  // and 0.25 s later a press is one again
  EXPECT_EQ(person.cycle(4.35).state, State::autonomy);
}

// A stick that sends only changes: a press always ends a silence.
TEST(CutLink, APressThatEndsASilenceCounts) {
  for (const double timeout : {0.0, 0.5}) {
    Parameters p;
    p.mode = OperatorMode::switching;
    p.input_timeout = timeout;
    Person person(p);
    person.stick(1.0, 0.0F);
    for (int i = 0; i <= 200; ++i) person.cycle(1.0 + 0.05 * i);
    person.button(11.02, 0);
    EXPECT_EQ(person.cycle(11.05).state, State::manual);
    person.stick(11.15, 0.0F);
    for (int i = 0; i <= 200; ++i) person.cycle(11.15 + 0.05 * i);
    person.button(21.17, 0);
    EXPECT_EQ(person.cycle(21.2).state, State::autonomy);
  }
}

TEST(CutLink, AStickThatSendsOnlyChangesSteersWithoutATimeout) {
  Parameters p;
  p.input_timeout = 0.0;
  Person shared(p);
  shared.steer(1.0);
  for (int i = 1; i < 200; ++i) {
    expect_intent(shared.cycle(1.05 + 0.05 * i), State::shared, Influence::shared, 0.5, 1.0);
  }
  shared.stick(11.02, 0.0F);
  expect_intent(shared.cycle(11.05), State::hold, Influence::shared, 0.5, 0.0);
  EXPECT_EQ(shared.cycle(13.01).state, State::hold);  // delta from the release at 11.02
  EXPECT_EQ(shared.cycle(13.03).state, State::autonomy);
  EXPECT_EQ(shared.machine.advice(), "");

  p.mode = OperatorMode::switching;
  Person manual(p);
  manual.stick(1.0, 0.0F);
  manual.cycle(1.0);
  manual.button(1.3, 0);
  manual.cycle(1.3);
  manual.stick(1.35, -1.0F, 1.0F);
  for (int i = 0; i < 200; ++i) {
    expect_intent(manual.cycle(1.35 + 0.05 * i), State::manual, Influence::direct, 0.5, -1.0);
  }
  manual.stick(11.35, 0.0F);
  expect_intent(manual.cycle(11.35), State::manual, Influence::direct, 0.0, 0.0);
  EXPECT_EQ(manual.machine.advice(), "");
}

TEST(CutLink, AStickThatSendsOnlyChangesIsToldTheCauseInBothModes) {
  for (const OperatorMode mode : {OperatorMode::joystick, OperatorMode::switching}) {
    Parameters p;
    p.mode = mode;
    Person person(p);
    person.stick(1.0, 0.0F);
    person.cycle(1.0);
    person.machine.take_control(true);
    person.cycle(1.02);
    person.stick(1.05, 1.0F);
    person.cycle(1.05);
    EXPECT_EQ(person.machine.advice(), "");
    EXPECT_EQ(person.cycle(1.6).state, State::lost);
    const std::string advice = person.machine.advice();
    EXPECT_NE(advice.find("sends only changes"), std::string::npos) << advice;
    EXPECT_NE(advice.find("autorepeat_rate"), std::string::npos) << advice;
    EXPECT_NE(advice.find("input_timeout to 0"), std::string::npos) << advice;
  }
}

}  // namespace
}  // namespace hidwa_local_planner::input
