// SPDX-License-Identifier: BSD-3-Clause
// Messages arrive later than their stamps say: a link becomes slower and stays so, a sender's computer slept, a clock
// was set. When a link is taken to be slower: backlog_gate_test.cpp.
#include <memory>
#include <string>

#include <gtest/gtest.h>

#include "person.hpp"

namespace hidwa_local_planner::input {
namespace {

/// A stick at 20 Hz with a clock of its own, and a cycle for each of its messages.
struct Remote : Person {
  using Person::Person;
  std::string send(double stamp, double received, float angular) {
    StickMessage message = stamped(stamp, stick_at(received, angular));
    message.connection = connection;
    newest = stamp;
    fault = machine.receive(message);
    cycle(received);
    return fault;
  }
  struct Played {
    State state;  // of the last cycle
    int taken;    // number of messages that were taken
  };
  /// For `seconds`; each message arrives `lag` [s] later than it is sent.
  Played play(double seconds, float angular, double lag) {
    int taken = 0;
    for (int i = 0; 0.05 * i < seconds - 1e-9; ++i, sent += 0.05) taken += send(sent, sent + lag, angular).empty();
    return {machine.state(), taken};
  }

  double sent = 100.0;  // the next message is [s]
  double newest = 0.0;  // stamp [s]
  std::string fault;    // of the last message
  std::shared_ptr<const void> connection = std::make_shared<int>();
};

TEST(SlowLink, IsTakenAsItIsAfterTwoSecondsAndANeutral) {
  Remote remote;
  EXPECT_EQ(remote.play(1.0, 0.0F, 0.02).state, State::autonomy);
  EXPECT_EQ(remote.play(1.0, 1.0F, 0.02).state, State::shared);
  EXPECT_EQ(remote.play(1.9, 1.0F, 0.62).state, State::lost);
  for (const char* part : {"it arrived 0.6 s later than the link needs at best, more than input_timeout (0.5 s)",
                           "within 0.1 s for 2 s"}) {
    EXPECT_TRUE(says(remote.fault, part)) << remote.fault;
  }
  EXPECT_EQ(remote.play(1.0, 1.0F, 0.62).state, State::lost);  // 2.9 s of it: heard, but to be seen centred once
  EXPECT_EQ(remote.fault, "");
  for (const char* part : {"require_neutral", "What comes on joy_topic arrives 0.6 s later than at best"}) {
    EXPECT_TRUE(says(remote.machine.advice(), part)) << remote.machine.advice();
  }
  EXPECT_NE(remote.play(0.1, 0.0F, 0.62).state, State::shared);
  EXPECT_EQ(remote.play(10.0, 1.0F, 0.62).state, State::shared);
  EXPECT_NEAR(remote.machine.dropped(), 40, 1);  // 2 s at 20 Hz
}

TEST(SlowLink, BeyondTheMostIsRefusedWithItsDelay) {
  Remote remote;
  remote.play(1.0, 0.0F, 0.02);
  EXPECT_EQ(remote.play(20.0, 1.0F, 1.22).state, State::autonomy);
  EXPECT_TRUE(says(remote.fault, "it arrived 1.2 s later than the link needs at best, more than input_lag_max (1 s)"))
      << remote.fault;
  EXPECT_TRUE(says(remote.machine.advice(), "1.2 s later"));
  remote.p.input_lag_max = 1.5;
  remote.configure();
  remote.play(2.1, 0.0F, 1.22);
  EXPECT_EQ(remote.play(0.1, 1.0F, 1.22).state, State::shared);
}

TEST(SlowLink, MayBeForbidden) {
  Parameters p;
  p.input_lag_max = 0.0;
  Remote remote(p);
  remote.play(1.0, 0.0F, 0.02);
  EXPECT_EQ(remote.play(0.5, 1.0F, 0.42).state, State::shared);  // less than input_timeout
  EXPECT_EQ(remote.play(20.0, 1.0F, 0.62).state, State::lost);
  for (const char* part :
       {"more than input_timeout (0.5 s): the link holds messages back, or", "synchronise the clocks"}) {
    EXPECT_TRUE(says(remote.fault, part)) << remote.fault;
  }
}

/// The sender's clock stood still for 10 s: centred before, deflected for 3 s after.
struct Slept : Remote {
  Slept() {
    play(5.0, 0.0F, 0.02);
    EXPECT_EQ(play(3.0, 1.0F, 10.02).taken, 0);
  }
};

/// Centred, then deflected.
State steer_again(Remote& remote, double lag) {
  remote.play(0.2, 0.0F, lag);
  return remote.play(0.2, 1.0F, lag).state;
}

// At 20 Hz that looks like a queue that is drained at the sender's pace, and is refused for as long as it goes on, with
// the remedy: excess 10 s, and half a second more.
TEST(Offset, ASteadyLagIsRefusedWithTheRemedy) {
  Slept sender;
  EXPECT_EQ(sender.play(600.0, 1.0F, 10.02).taken, 0);
  EXPECT_TRUE(says(sender.machine.advice(), "send nothing for 11 s, or restart the sender")) << sender.machine.advice();
}

// A gap of 10.5 s and more would have emptied any queue. What comes then with the same lag is live, after neutral, and
// that is told once.
TEST(Offset, AGapLongerThanTheExcessProvesAClock) {
  for (const double gap : {10.45, 10.6}) {
    Slept sender;
    sender.sent += gap - 0.05;  // since the last message
    const bool believed = gap > 10.5;
    EXPECT_EQ(sender.play(1.0, 1.0F, 10.02).taken, believed ? 20 : 0) << gap;
    EXPECT_NE(sender.machine.state(), State::shared);  // deflected since before: neutral is demanded
    EXPECT_EQ(says(sender.machine.take_warnings(), "was set or stood still"), believed);
    EXPECT_EQ(steer_again(sender, 10.02) == State::shared, believed);
    EXPECT_EQ(sender.machine.take_warnings(), "");
  }
}

// A queue that the gap has shortened is one.
TEST(Offset, AfterAGapALagThatChangedProvesNothing) {
  Slept sender;
  sender.sent = 120.0;
  EXPECT_EQ(sender.play(1.0, 1.0F, 9.88).taken, 0);  // 0.14 s less
  sender.sent = 140.0;
  EXPECT_EQ(sender.play(1.0, 1.0F, 10.05).taken, 0);  // 0.17 s more
}

// Messages whose stamps are not refreshed fill a queue too: there is no gap.
TEST(Offset, RepeatedStampsAreNoGap) {
  Slept sender;
  for (int i = 0; i < 300; ++i) sender.send(sender.newest, 118.0 + 0.05 * i, 1.0F);  // until 133 s
  sender.sent = 123.03;
  EXPECT_EQ(sender.play(1.0, 1.0F, 10.02).taken, 0);
}

// A lag that a slower link may have is judged as before, however long the gap.
TEST(Offset, AGapProvesNothingForALagOfALink) {
  Remote sender;
  sender.play(5.0, 0.0F, 0.02);
  sender.play(0.5, 1.0F, 0.82);
  sender.sent = 110.0;
  EXPECT_EQ(sender.play(1.0, 1.0F, 0.82).taken, 0);
}

TEST(Offset, ANewConnectionBeginsWithoutABacklog) {
  Slept sender;
  sender.connection = std::make_shared<int>();
  EXPECT_EQ(sender.play(1.0, 1.0F, 10.02).taken, 20);
  EXPECT_NE(sender.machine.state(), State::shared);
  EXPECT_TRUE(says(sender.machine.take_warnings(), "was set or stood still"));
  EXPECT_EQ(steer_again(sender, 10.02), State::shared);
}

// A connection that was cut and is there again changes nothing where the clocks are as they were.
TEST(Offset, ANewConnectionAloneChangesNothing) {
  Remote sender;
  sender.play(5.0, 0.0F, 0.02);
  sender.play(1.0, 1.0F, 0.02);
  sender.connection = std::make_shared<int>();
  EXPECT_EQ(sender.play(0.3, 1.0F, 0.02).state, State::shared);
}

// The robot's clock is set forward by 5 s at 110 s, while a stick is held; `tells`: the machine is told of its clock.
TEST(Offset, TheRobotsOwnClockIsKnown) {
  for (const bool tells : {false, true}) {
    Remote sender;
    int taken = 0;  // after the step
    for (int i = 0; i < 220; ++i, sender.sent += 0.05) {
      const double step = i < 200 ? 0.0 : 5.0;
      const double received = sender.sent + 0.02 + step;
      if (tells) sender.machine.heartbeat(received - 0.01, 1e9 + step);
      const bool live = sender.send(sender.sent, received, i < 40 ? 0.0F : 1.0F).empty();
      taken += i >= 200 && live;
    }
    EXPECT_EQ(taken, tells ? 20 : 0);
    if (!tells) continue;
    EXPECT_NE(sender.machine.state(), State::shared);  // after neutral
    EXPECT_TRUE(says(sender.machine.take_warnings(), "The robot's clock was set forward by 5 s"));
    EXPECT_EQ(steer_again(sender, 5.02), State::shared);
    EXPECT_EQ(sender.machine.take_warnings(), "");
  }
}

// A busy machine, whose heartbeats come late, has no other clock.
TEST(Offset, LateHeartbeatsAreNoStep) {
  Remote sender;
  for (int i = 0; i < 10; ++i) {
    const double now = 100.0 + 3.0 * i;
    sender.machine.heartbeat(now, 1e9);
    sender.send(now, now + 0.02, 0.0F);
  }
  EXPECT_EQ(sender.machine.take_warnings(), "");
}

}  // namespace
}  // namespace hidwa_local_planner::input
