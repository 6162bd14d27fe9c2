// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "person.hpp"

namespace hidwa_local_planner::input {
namespace {

using State = OperatorStateId;

StickMessage stamped(double stamp, double received, float angular) {
  StickMessage message = stick_at(received, angular);
  message.stamp = stamp;
  return message;
}

/// A link that is cut at 2.0 s and delivers at 5.0 s all that was sent meanwhile: the stick deflected
/// from 2.1 s to 4.9 s, centred before and after. `clock` is the sender's clock minus ours [s]; empty stamps
/// where `stamps` is false.
void deliver_burst(Person& person, bool stamps, double clock) {
  const auto send = [&](double sent, double received, float angular) {
    person.machine.receive(stamped(stamps ? sent + clock : 0.0, received, angular));
  };
  for (int i = 0; i <= 20; ++i) {
    const double time = 1.0 + 0.05 * i;
    send(time, time, 0.0F);
    EXPECT_EQ(person.cycle(time).state, State::autonomy);
  }
  for (int i = 0; i < 58; ++i) EXPECT_EQ(person.cycle(2.05 + 0.05 * i).state, State::autonomy);
  for (int i = 1; i <= 60; ++i) {
    const double sent = 2.0 + 0.05 * i;
    send(sent, 5.0, sent > 2.08 && sent < 4.92 ? 1.0F : 0.0F);
  }
}

TEST(Transport, ABurstAfterAGapHasNoEffect) {
  for (const bool stamps : {true, false}) {
    for (const double clock : {0.0, -0.7, 1e5}) {
      Person person;
      deliver_burst(person, stamps, clock);
      for (int i = 0; i <= 60; ++i) {
        expect_intent(person.cycle(5.0 + 0.05 * i), State::autonomy, Influence::none, 0.0, 0.0);
      }
      // Sent at 2.05 ... 4.45 with lags of 2.95 ... 0.55 s: 49 messages.
      EXPECT_EQ(person.machine.dropped(), stamps ? 49U : 0U);
    }
  }
}

// The same, with a cycle between any two messages of the burst: what is older than input_timeout still has
// none.
TEST(Transport, ABurstHasNoEffectBetweenItsMessagesEither) {
  Person person;
  person.machine.receive(stamped(2.0, 2.0, 0.0F));
  person.cycle(2.0);
  for (int i = 1; i <= 60; ++i) {
    const double sent = 2.0 + 0.05 * i;
    person.machine.receive(stamped(sent, 5.0 + 1e-4 * i, sent < 4.4 ? 1.0F : 0.0F));
    EXPECT_EQ(person.cycle(5.0 + 1e-4 * i).state, State::autonomy) << sent;
  }
}

TEST(Transport, ABurstOfSteeringAfterALossHasNoEffect) {
  for (const bool stamps : {true, false}) {
    Person person;
    person.machine.receive(stamped(stamps ? 2.0 : 0.0, 2.0, 0.0F));
    person.machine.receive(stamped(stamps ? 2.05 : 0.0, 2.05, 1.0F));
    EXPECT_EQ(person.cycle(2.05).state, State::shared);
    EXPECT_EQ(person.cycle(4.5).state, State::lost);
    for (int i = 1; i <= 60; ++i) {
      person.machine.receive(stamped(stamps ? 2.05 + 0.05 * i : 0.0, 5.05, 1.0F));
      expect_intent(person.cycle(5.05), State::lost, Influence::none, 0.0, 0.0);
    }
  }
}

// No cycle ran during the gap (no goal was active): the gap is a loss all the same.
TEST(Transport, AGapWithoutCyclesIsALossToo) {
  Person person;
  person.steer(1.0);
  person.stick(4.0, 1.0F);
  EXPECT_EQ(person.cycle(4.0).state, State::lost);
}

TEST(Transport, BacklogDoesNotKeepInputAlive) {
  Person person;
  person.machine.receive(stamped(1.0, 1.0, 0.0F));
  person.machine.receive(stamped(1.05, 1.05, 1.0F));
  EXPECT_EQ(person.cycle(1.05).state, State::shared);
  // From here on everything comes 1 s late.
  for (int i = 0; i < 40; ++i) {
    const double now = 1.1 + 0.05 * i;
    EXPECT_NE(person.machine.receive(stamped(now - 1.0 + 0.06, now, 1.0F)), "");
    EXPECT_EQ(person.cycle(now + 1e-3).state == State::shared, now <= 1.52) << now;  // at most 0.5 s from 1.05
  }
  EXPECT_EQ(person.machine.dropped(), 40U);
  EXPECT_NE(person.machine.advice().find("synchronise the clocks"), std::string::npos);
}

TEST(Transport, EmptyStampsSteer) {
  Person person;
  for (int i = 0; i < 200; ++i) {
    const double time = 1.0 + 0.01 * i;
    EXPECT_EQ(person.stick(time, i == 0 ? 0.0F : 1.0F), "");
    EXPECT_EQ(person.cycle(time).state, i == 0 ? State::autonomy : State::shared);
  }
}

TEST(Transport, ARepeaterThatDoesNotRefreshItsStampSteers) {
  Person person;
  person.machine.receive(stamped(1.0, 1.0, 0.0F));
  for (int i = 1; i < 200; ++i) {
    const double time = 1.0 + 0.05 * i;
    EXPECT_EQ(person.machine.receive(stamped(1.05, time, 1.0F)), "");
    EXPECT_EQ(person.cycle(time).state, State::shared);
  }
}

TEST(Transport, ClocksOfTwoMachinesNeedNotAgree) {
  for (const double clock : {-3600.0, 0.5, 3600.0}) {
    Person person;
    for (int i = 0; i < 100; ++i) {
      const double time = 5000.0 + 0.05 * i;
      EXPECT_EQ(person.machine.receive(stamped(time + clock, time + 0.02, i == 0 ? 0.0F : 1.0F)), "");
      EXPECT_EQ(person.cycle(time + 0.03).state, i == 0 ? State::autonomy : State::shared);
    }
  }
}

TEST(Transport, ASendersClockThatWasSetBackIsLearntAndTheStickMustBeSeenCentred) {
  Person person;
  person.machine.receive(stamped(100.0, 1.0, 0.0F));
  person.machine.receive(stamped(100.05, 1.05, 1.0F));
  EXPECT_EQ(person.cycle(1.05).state, State::shared);
  for (int i = 0; i < 120; ++i) {
    const double now = 1.1 + 0.05 * i;
    person.machine.receive(stamped(3.0 + 0.05 * i, now + 1e-6 * i, 1.0F));
    EXPECT_EQ(person.cycle(now + 1e-3).state, now <= 1.52 ? State::shared : State::lost) << now;
  }
  EXPECT_EQ(person.machine.dropped(), 100U);  // 5 s at 20 Hz
  person.machine.receive(stamped(9.0, 7.1, 0.0F));
  person.machine.receive(stamped(9.05, 7.15, -1.0F));
  EXPECT_EQ(person.cycle(7.15).state, State::shared);
}

TEST(Transport, ASendersClockThatWasSetBackMakesANewDevice) {
  Person person;
  person.machine.receive(stamped(100.0, 1.0, 0.0F));  // centred: nothing is lost while its messages are dropped
  for (int i = 0; i <= 120; ++i) {
    const double now = 1.1 + 0.05 * i;
    person.machine.receive(stamped(3.0 + 0.05 * i, now, 1.0F));
    EXPECT_EQ(person.cycle(now).state, State::autonomy) << now;
  }
  EXPECT_LT(person.machine.dropped(), 110U);
}

TEST(Transport, AnotherDeviceMustBeSeenCentred) {
  Person person;
  person.steer(1.0);
  StickMessage other = stick_at(1.1, 1.0F);
  other.buttons.push_back(0);
  person.machine.receive(other);
  EXPECT_EQ(person.cycle(1.1).state, State::hold);
  other = stick_at(1.15, 0.0F);
  other.buttons.push_back(0);
  person.machine.receive(other);
  other = stick_at(1.2, 1.0F);
  other.buttons.push_back(0);
  person.machine.receive(other);
  EXPECT_EQ(person.cycle(1.2).state, State::shared);
  other.received = 1.25;
  other.sender = "/another_joy_node";
  person.machine.receive(other);
  EXPECT_EQ(person.cycle(1.25).state, State::hold);
}

/// A message at `time` [s] from `sender`.
StickMessage sent_by(const std::string& sender, double time, float angular) {
  StickMessage message = stick_at(time, angular);
  message.sender = sender;
  return message;
}

TEST(Transport, TwoSendersInTurnSteerNothingAndAreNamed) {
  Person person;
  for (int i = 0; i < 20; ++i) {
    const double time = 1.0 + 0.05 * i;
    person.machine.receive(sent_by("/here", time, 1.0F));
    EXPECT_EQ(person.cycle(time).state, State::autonomy);
    person.machine.receive(sent_by("/there", time + 0.02, 0.0F));
    EXPECT_EQ(person.cycle(time + 0.02).state, State::autonomy);
  }
  EXPECT_NE(person.machine.advice().find("/here and /there"), std::string::npos) << person.machine.advice();
  // One of them goes; a hundred messages of the other make it the only one.
  for (int i = 0; i < 100; ++i) person.machine.receive(sent_by("/there", 2.0 + 0.05 * i, 0.0F));
  EXPECT_EQ(person.machine.advice(), "");
  person.machine.receive(sent_by("/there", 7.0, 1.0F));
  EXPECT_EQ(person.cycle(7.0).state, State::shared);
}

TEST(Transport, ASenderThatTakesOverIsNoRival) {
  Person person;
  for (int i = 0; i < 100; ++i) person.machine.receive(sent_by("/here", 1.0 + 0.05 * i, 0.0F));
  for (int i = 0; i < 100; ++i) person.machine.receive(sent_by("/there", 6.0 + 0.05 * i, 0.0F));
  person.machine.receive(sent_by("/here", 11.0, 0.0F));
  EXPECT_EQ(person.machine.advice(), "");
}

TEST(Transport, ASilentStickCountsWhereTheTimeoutIsOff) {
  Parameters p;
  p.input_timeout = 0.0;
  Person person(p);
  person.steer(1.0);
  expect_intent(person.cycle(61.0), State::shared, Influence::shared, 0.5, 1.0);
  person.stick(61.5, 0.0F);
  EXPECT_EQ(person.cycle(61.5).state, State::hold);  // it was deflected until 61.5
  EXPECT_EQ(person.cycle(63.49).state, State::hold);
  EXPECT_EQ(person.cycle(63.51).state, State::autonomy);
  EXPECT_EQ(person.machine.advice(), "");
}

// Where nothing is ever lost, a late release must not be dropped: the stick would stay deflected for ever.
TEST(Transport, WithoutATimeoutALateReleaseCounts) {
  Parameters p;
  p.input_timeout = 0.0;
  Person person(p);
  person.machine.receive(stamped(1.0, 1.0, 0.0F));
  person.machine.receive(stamped(1.05, 1.05, 1.0F));
  EXPECT_EQ(person.cycle(1.05).state, State::shared);
  EXPECT_EQ(person.machine.receive(stamped(1.5, 4.5, 0.0F)), "");
  EXPECT_EQ(person.cycle(4.5).state, State::hold);
}

TEST(Transport, AStickThatSendsOnlyChangesIsReportedWithTheRemedy) {
  Person person;
  person.steer(1.0);
  EXPECT_EQ(person.machine.advice(), "");
  person.cycle(1.6);
  const std::string once = person.machine.advice();
  EXPECT_NE(once.find("autorepeat_rate to 20"), std::string::npos);
  EXPECT_NE(once.find("input_timeout to 0"), std::string::npos);
  EXPECT_NE(once.find("once"), std::string::npos);
  person.stick(2.0, 0.0F);
  person.stick(2.1, 1.0F);
  person.cycle(2.1);
  person.stick(4.0, 0.0F);  // noticed without a cycle, too
  EXPECT_NE(person.machine.advice().find("2 times"), std::string::npos);
}

TEST(Transport, TheReportGoesAwayOnceTheStickRepeats) {
  Person person;
  person.steer(1.0);
  person.cycle(1.6);
  EXPECT_NE(person.machine.advice(), "");
  person.stick(2.0, 0.0F);
  for (int i = 1; i <= 220; ++i) person.stick(2.0 + 0.05 * i, 1.0F);  // 10.95 s deflected without a silence
  EXPECT_EQ(person.machine.advice(), "");
}

TEST(Transport, TheReportGoesAwayWithTheRemedy) {
  Person person;
  person.steer(1.0);
  person.cycle(1.6);
  person.stick(1.7, 0.0F);
  EXPECT_NE(person.machine.advice(), "");
  person.p.input_timeout = 5.0;
  person.machine.configure(person.p);
  EXPECT_EQ(person.machine.advice(), "");
}

TEST(Transport, TimeThatJumpsBackResets) {
  Person person;
  person.steer(100.0);
  EXPECT_EQ(person.cycle(100.1).state, State::shared);
  expect_intent(person.cycle(1.0), State::autonomy, Influence::none, 0.0, 0.0);
  EXPECT_LT(person.machine.input_age(1.0), 0.0);
  person.stick(1.05, 1.0F);
  EXPECT_EQ(person.cycle(1.05).state, State::autonomy);  // as at the start: not yet seen centred
  person.stick(1.1, 0.0F);
  person.stick(1.15, 1.0F);
  EXPECT_EQ(person.cycle(1.15).state, State::shared);
}

TEST(Transport, TimeThatJumpsBackResetsWhereTheLastMessageIsOlder) {
  Parameters p;
  p.input_timeout = 0.0;
  Person person(p);
  person.steer(50.0);
  EXPECT_EQ(person.cycle(100.0).state, State::shared);
  EXPECT_EQ(person.cycle(60.0).state, State::autonomy);
}

TEST(Transport, TimeThatJumpsBackInAMessageResets) {
  Person person;
  person.steer(100.0);
  person.stick(1.0, 1.0F);
  EXPECT_EQ(person.machine.state(), State::autonomy);
  EXPECT_EQ(person.cycle(1.05).state, State::autonomy);
}

TEST(Transport, AMessageFromBeforeTheJumpIsForgotten) {
  Person person;
  person.stick(100.0, 0.0F);
  person.stick(100.05, 1.0F);  // no cycle yet
  EXPECT_EQ(person.cycle(1.0).state, State::autonomy);
  EXPECT_LT(person.machine.input_age(1.0), 0.0);
}

TEST(Transport, ThreadsMayReadTheClockOutOfTurn) {
  Person person;
  person.steer(1.0);
  person.stick(1.101, 1.0F);
  EXPECT_EQ(person.cycle(1.1).state, State::shared);
  EXPECT_DOUBLE_EQ(person.machine.input_age(1.1), 0.0);
  person.stick(1.099, 1.0F);
  EXPECT_EQ(person.cycle(1.098).state, State::shared);
}

}  // namespace
}  // namespace hidwa_local_planner::input
