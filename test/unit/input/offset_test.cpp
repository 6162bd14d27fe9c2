// SPDX-License-Identifier: BSD-3-Clause
// The offset between the sender's clock and the robot's changes: a computer that slept, a clock that was set.
#include <memory>
#include <string>

#include <gtest/gtest.h>

#include "person.hpp"

namespace hidwa_local_planner::input {
namespace {

using State = OperatorStateId;

/// A stick at 20 Hz, with a cycle for each message.
struct Sender : Person {
  /// A message that is sent at `sent` and arrives at `received` [s].
  std::string send(double sent, double received, float angular) {
    StickMessage message = stick_at(received, angular);
    message.stamp = sent;
    message.connection = connection;
    const std::string fault = machine.receive(message);
    cycle(received);
    return fault;
  }
  /// For `seconds` from `sent` on, each message `lag` later. How many were taken.
  int play(double sent, double seconds, float angular, double lag) {
    int taken = 0;
    for (int i = 0; 0.05 * i < seconds - 1e-9; ++i)
      taken += send(sent + 0.05 * i, sent + lag + 0.05 * i, angular) == "";
    return taken;
  }
  std::shared_ptr<const void> connection = std::make_shared<int>();
};

bool says(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

// Its clock stood still for 10 s. At 20 Hz that looks like a queue that is drained at the sender's pace, and is refused
// for as long as it goes on, with the remedy: excess 10 s, and half a second more.
TEST(Offset, ASteadyLagIsRefusedWithTheRemedy) {
  Sender sender;
  sender.play(100.0, 5.0, 0.0F, 0.02);
  EXPECT_EQ(sender.play(105.0, 600.0, 1.0F, 10.02), 0);
  EXPECT_TRUE(says(sender.machine.advice(), "send nothing for 11 s, or restart the sender")) << sender.machine.advice();
}

// A gap of 10.5 s and more would have emptied any queue. What comes then with the same lag is live, after neutral, and
// that is told once.
TEST(Offset, AGapLongerThanTheExcessProvesAClock) {
  for (const double gap : {10.45, 10.6}) {
    Sender sender;
    sender.play(100.0, 5.0, 0.0F, 0.02);
    sender.play(105.0, 3.0, 1.0F, 10.02);
    const double again = 107.95 + gap;
    const bool believed = gap > 10.5;
    EXPECT_EQ(sender.play(again, 1.0, 1.0F, 10.02), believed ? 20 : 0) << gap;
    EXPECT_NE(sender.machine.state(), State::shared);  // deflected since before: neutral is demanded
    EXPECT_EQ(says(sender.machine.take_warnings(), "was set or stood still"), believed);
    sender.play(again + 1.0, 0.2, 0.0F, 10.02);
    sender.play(again + 1.2, 0.2, 1.0F, 10.02);
    EXPECT_EQ(sender.machine.state() == State::shared, believed);
    EXPECT_EQ(sender.machine.take_warnings(), "");
  }
}

// A queue that the gap has shortened is one.
TEST(Offset, AfterAGapALagThatChangedProvesNothing) {
  Sender sender;
  sender.play(100.0, 5.0, 0.0F, 0.02);
  sender.play(105.0, 3.0, 1.0F, 10.02);
  EXPECT_EQ(sender.play(120.0, 1.0, 1.0F, 9.88), 0);   // 0.14 s less
  EXPECT_EQ(sender.play(140.0, 1.0, 1.0F, 10.05), 0);  // 0.17 s more
}

// Messages whose stamps are not refreshed fill a queue too: there is no gap.
TEST(Offset, RepeatedStampsAreNoGap) {
  Sender sender;
  sender.play(100.0, 5.0, 0.0F, 0.02);
  sender.play(105.0, 3.0, 1.0F, 10.02);
  for (int i = 0; i < 300; ++i) sender.send(107.95, 118.0 + 0.05 * i, 1.0F);  // until 133 s
  EXPECT_EQ(sender.play(123.03, 1.0, 1.0F, 10.02), 0);
}

// A lag that a slower link may have is judged as before, however long the gap.
TEST(Offset, AGapProvesNothingForALagOfALink) {
  Sender sender;
  sender.play(100.0, 5.0, 0.0F, 0.02);
  sender.play(105.0, 0.5, 1.0F, 0.82);
  EXPECT_EQ(sender.play(110.0, 1.0, 1.0F, 0.82), 0);
}

TEST(Offset, ANewConnectionBeginsWithoutABacklog) {
  Sender sender;
  sender.play(100.0, 5.0, 0.0F, 0.02);
  EXPECT_EQ(sender.play(105.0, 3.0, 1.0F, 10.02), 0);
  sender.connection = std::make_shared<int>();
  EXPECT_EQ(sender.play(108.0, 1.0, 1.0F, 10.02), 20);
  EXPECT_NE(sender.machine.state(), State::shared);
  EXPECT_TRUE(says(sender.machine.take_warnings(), "was set or stood still"));
  sender.play(109.0, 0.2, 0.0F, 10.02);
  sender.play(109.2, 0.2, 1.0F, 10.02);
  EXPECT_EQ(sender.machine.state(), State::shared);
}

// A connection that was cut and is there again changes nothing where the clocks are as they were.
TEST(Offset, ANewConnectionAloneChangesNothing) {
  Sender sender;
  sender.play(100.0, 5.0, 0.0F, 0.02);
  sender.play(105.0, 1.0, 1.0F, 0.02);
  sender.connection = std::make_shared<int>();
  EXPECT_EQ(sender.play(106.0, 0.3, 1.0F, 0.02), 6);
  EXPECT_EQ(sender.machine.state(), State::shared);
}

/// A robot whose clock is set forward by 5 s at 110 s, while a stick is held at 20 Hz; `tells`: the machine is
/// told of its clock. Returns how many messages were taken in the second after that; centred before it, if `centred`.
int taken_after_a_step(Sender& sender, bool tells, float angular) {
  int taken = 0;
  for (int i = 0; i < 220; ++i) {
    const double sent = 100.0 + 0.05 * i, step = i < 200 ? 0.0 : 5.0;
    const double received = sent + 0.02 + step;
    if (tells) sender.machine.heartbeat(received - 0.01, 1e9 + step);
    const bool ok = sender.send(sent, received, i < 40 ? 0.0F : angular) == "";
    taken += i >= 200 && ok;
  }
  return taken;
}

TEST(Offset, TheRobotsOwnClockIsKnown) {
  Sender deaf;
  EXPECT_EQ(taken_after_a_step(deaf, false, 1.0F), 0);
  Sender sender;
  EXPECT_EQ(taken_after_a_step(sender, true, 1.0F), 20);
  EXPECT_NE(sender.machine.state(), State::shared);  // after neutral
  EXPECT_TRUE(says(sender.machine.take_warnings(), "The robot's clock was set forward by 5 s"));
  sender.play(111.0, 0.2, 0.0F, 5.02);
  sender.play(111.2, 0.2, 1.0F, 5.02);
  EXPECT_EQ(sender.machine.state(), State::shared);
  EXPECT_EQ(sender.machine.take_warnings(), "");
}

// A busy machine, whose heartbeats come late, has no other clock.
TEST(Offset, LateHeartbeatsAreNoStep) {
  Sender sender;
  for (int i = 0; i < 10; ++i) {
    const double now = 100.0 + 3.0 * i;
    sender.machine.heartbeat(now, 1e9);
    sender.send(now, now + 0.02, 0.0F);
  }
  EXPECT_EQ(sender.machine.take_warnings(), "");
}

}  // namespace
}  // namespace hidwa_local_planner::input
