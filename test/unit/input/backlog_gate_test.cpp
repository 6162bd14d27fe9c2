// SPDX-License-Identifier: BSD-3-Clause
#include "input/backlog_gate.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace hidwa_local_planner::input {
namespace {

using Arrival = BacklogGate::Arrival;
constexpr BacklogGate::Limits kLimit{0.5, 1.0};

TEST(BacklogGate, EmptyStampsAlwaysPass) {
  BacklogGate gate;
  for (int i = 0; i < 100; ++i) EXPECT_EQ(gate.judge(0.0, 10.0 + i, kLimit), Arrival::live);
}

// Received at one and the same time, so that no drift comes in: late by just the bound is live, by 2^-10 s more is not.
TEST(BacklogGate, AtTheBoundIsLive) {
  BacklogGate gate;
  EXPECT_EQ(gate.judge(10.0, 10.0, kLimit), Arrival::live);
  EXPECT_EQ(gate.judge(9.5, 10.0, kLimit), Arrival::live);  // lag 10 - 9.5 = 0.5
  EXPECT_EQ(gate.excess(), 0.5);
  EXPECT_EQ(gate.judge(9.5 - 0x1p-10, 10.0, kLimit), Arrival::backlog);
}

// The sender's clock is ahead by 1000 s: lags are -1000 s and only their excess counts.
TEST(BacklogGate, ClockOffsetDoesNotMatter) {
  for (const double offset : {-1000.0, 0.0, 1e6}) {
    BacklogGate gate;
    EXPECT_EQ(gate.judge(2e6 + offset, 2e6, kLimit), Arrival::live);
    EXPECT_EQ(gate.judge(2e6 + 1.0 + offset, 2e6 + 1.49, kLimit), Arrival::live);     // 0.49 s late
    EXPECT_EQ(gate.judge(2e6 + 1.1 + offset, 2e6 + 1.61, kLimit), Arrival::backlog);  // 0.51 s late
    EXPECT_NEAR(gate.excess(), 0.51, 1e-3);
    EXPECT_EQ(gate.judge(2e6 + 2.0 + offset, 2e6 + 2.0, kLimit), Arrival::live);
  }
}

TEST(BacklogGate, TheSmallestLagIsWhatCounts) {
  BacklogGate gate;
  EXPECT_EQ(gate.judge(10.0, 10.4, kLimit), Arrival::live);
  EXPECT_EQ(gate.judge(11.0, 11.8, kLimit), Arrival::live);     // 0.8 - 0.4
  EXPECT_EQ(gate.judge(12.0, 12.1, kLimit), Arrival::live);     // the smallest: 0.1
  EXPECT_EQ(gate.judge(13.0, 13.8, kLimit), Arrival::backlog);  // 0.8 - 0.1
}

// 60 messages queued for 3 s arrive at once: all but the last half second is backlog.
TEST(BacklogGate, Burst) {
  BacklogGate gate;
  EXPECT_EQ(gate.judge(10.0, 10.0, kLimit), Arrival::live);
  int backlog = 0;
  for (int i = 1; i <= 60; ++i) {
    const Arrival arrival = gate.judge(10.0 + 0.05 * i, 13.0, kLimit);
    EXPECT_EQ(arrival == Arrival::backlog, 3.0 - 0.05 * i > 0.501) << i;
    backlog += arrival == Arrival::backlog ? 1 : 0;
  }
  EXPECT_EQ(backlog, 49);  // lags 2.95 ... 0.55; that of 0.5 passes: 60 - 11
}

TEST(BacklogGate, RepeatedStampIsJudgedOnce) {
  BacklogGate gate;
  EXPECT_EQ(gate.judge(10.0, 10.0, kLimit), Arrival::live);
  EXPECT_EQ(gate.judge(10.0, 19.0, kLimit), Arrival::live);  // held still for 9 s, the stamp not refreshed
  EXPECT_EQ(gate.judge(19.05, 19.05, kLimit), Arrival::live);
  EXPECT_EQ(gate.judge(20.0, 23.0, kLimit), Arrival::backlog);
  EXPECT_EQ(gate.judge(20.0, 23.0, kLimit), Arrival::backlog);
}

TEST(BacklogGate, TwoMessagesMayChangePlaces) {
  BacklogGate gate;
  EXPECT_EQ(gate.judge(50.1, 10.2, kLimit), Arrival::live);
  EXPECT_EQ(gate.judge(50.05, 10.25, kLimit), Arrival::live);  // 0.1 s late
  EXPECT_EQ(gate.judge(50.15, 10.26, kLimit), Arrival::live);
}

// Old messages among live ones are backlog, however long that lasts.
TEST(BacklogGate, OldMessagesAmongLiveOnes) {
  BacklogGate gate;
  for (int i = 0; i < 400; ++i) {
    const double now = 10.0 + 0.05 * i;
    EXPECT_EQ(gate.judge(now, now, kLimit), Arrival::live);
    EXPECT_EQ(gate.judge(now - 3.0, now, kLimit), Arrival::backlog);
  }
}

// The sender's clock was set back by 50 s while the stick kept sending: learnt again after 5 s.
TEST(BacklogGate, SendersClockSetBack) {
  BacklogGate gate;
  EXPECT_EQ(gate.judge(100.0, 10.0, kLimit), Arrival::live);
  for (int i = 0; i < 100; ++i) {
    ASSERT_EQ(gate.judge(50.0 + 0.05 * i, 10.1 + 0.05 * i, kLimit), Arrival::backlog) << i;
  }
  EXPECT_EQ(gate.judge(55.05, 15.15, kLimit), Arrival::new_clock);
  EXPECT_EQ(gate.judge(55.1, 15.2, kLimit), Arrival::live);
}

TEST(BacklogGate, StampsThatLeapForwardPass) {
  BacklogGate gate;
  EXPECT_EQ(gate.judge(10.0, 10.0, kLimit), Arrival::live);
  EXPECT_EQ(gate.judge(1e6, 10.05, kLimit), Arrival::live);
  EXPECT_EQ(gate.judge(1e6 + 0.05, 10.1, kLimit), Arrival::live);
}

// Two clocks that part by 100 ppm for a day: 8.6 s in the end, and never a message dropped.
TEST(BacklogGate, ClocksMayDrift) {
  BacklogGate gate;
  for (int i = 0; i <= 86400; ++i) {
    const double received = 1000.0 + i;
    ASSERT_EQ(gate.judge(received - 1e-4 * i, received, kLimit), Arrival::live) << i;
  }
}

// The receiver's clock was set forward by a day while the stick kept sending: learnt again after 5 s.
TEST(BacklogGate, ReceiversClockSetForward) {
  BacklogGate gate;
  EXPECT_EQ(gate.judge(5.0, 5.0, kLimit), Arrival::live);
  for (int i = 0; i < 100; ++i) {
    ASSERT_EQ(gate.judge(6.0 + 0.05 * i, 86406.0 + 0.05 * i, kLimit), Arrival::backlog) << i;
  }
  EXPECT_EQ(gate.judge(11.05, 86411.05, kLimit), Arrival::new_clock);
  EXPECT_EQ(gate.judge(11.1, 86411.1, kLimit), Arrival::live);
}

// 100 s of messages delivered at twice their pace: the lag falls all the time, so it is a backlog and no
// clock.
TEST(BacklogGate, AThinLinkWorksOffALongBacklog) {
  BacklogGate gate;
  EXPECT_EQ(gate.judge(5.0, 5.0, kLimit), Arrival::live);
  for (int i = 1; i < 1980; ++i) {  // the last one 1 s late
    ASSERT_EQ(gate.judge(5.0 + 0.1 * i, 105.0 + 0.05 * i, kLimit), Arrival::backlog) << i;
  }
}

// A link that is late by 3 s stays late: that is no clock.
TEST(BacklogGate, SteadilyLateStaysDropped) {
  BacklogGate gate;
  EXPECT_EQ(gate.judge(5.0, 5.0, kLimit), Arrival::live);
  for (int i = 0; i < 1200; ++i) {
    ASSERT_EQ(gate.judge(6.0 + 0.05 * i, 9.0 + 0.05 * i, kLimit), Arrival::backlog) << i;
  }
}

/// A link whose lag is 0.02 s until 10 s, from then on what `lag` says of the time since [s], at 20 Hz. Returns when it
/// is taken to be slower [s after 10]; negative where it is not within 20 s.
template <typename Lag>
double slower_after(Lag lag) {
  BacklogGate gate;
  for (int i = 0; i < 20; ++i) gate.judge(9.0 + 0.05 * i, 9.02 + 0.05 * i, kLimit);
  double received = 10.0;
  for (int i = 0; i < 400; ++i) {
    const double sent = 10.0 + 0.05 * i;
    received = std::max(received, sent + lag(0.05 * i));
    const Arrival arrival = gate.judge(sent, received, kLimit);
    if (arrival == Arrival::slower_link) return 0.05 * i;
    EXPECT_NE(arrival, Arrival::new_clock);
  }
  return -1.0;
}

// A lag that is steady within 0.1 s for 2 s is the link's, up to 1 s more than at best.
TEST(BacklogGate, ALinkThatBecameSlowerIsTakenAsItIs) {
  EXPECT_NEAR(slower_after([](double) { return 0.62; }), 2.0, 0.051);
  EXPECT_NEAR(slower_after([](double time) { return 0.62 + 0.045 * std::sin(9.0 * time); }), 2.0, 0.051);
  EXPECT_NEAR(slower_after([](double) { return 1.01; }), 2.0, 0.051);  // 0.99 s more
  EXPECT_LT(slower_after([](double) { return 1.04; }), 0.0);           // 1.02 s more
}

// What its lag is beyond the best one may be input_lag_max, and no bit more.
TEST(BacklogGate, AtTheBoundALinkIsTakenAsItIs) {
  double excess = 0.0;
  const auto after_two_seconds = [&excess](double lag_max) {
    BacklogGate gate;
    gate.judge(9.0, 9.0, kLimit);
    for (int i = 0; i < 32; ++i) gate.judge(10.0 + i / 16.0, 10.625 + i / 16.0, kLimit);
    const Arrival arrival = gate.judge(12.0, 12.625, {0.5, lag_max});  // 32 / 16 = 2 s after the first
    excess = gate.excess();
    return arrival;
  };
  EXPECT_EQ(after_two_seconds(1.0), Arrival::slower_link);
  EXPECT_NEAR(excess, 0.625, 1e-3);
  EXPECT_EQ(after_two_seconds(excess), Arrival::slower_link);
  EXPECT_EQ(after_two_seconds(std::nextafter(excess, 0.0)), Arrival::backlog);
}

TEST(BacklogGate, ALagThatGrowsIsNotTakenAsItIs) {
  EXPECT_LT(slower_after([](double time) { return 0.55 + 0.06 * time; }), 0.0);  // 0.12 s in 2 s
  EXPECT_LT(slower_after([](double time) { return 0.6 + 0.1 * std::sin(9.0 * time); }), 0.0);
  // Grows for 3 s, then stays: 2 s after that, a message more or less.
  EXPECT_NEAR(slower_after([](double time) { return 0.55 + 0.1 * std::min(time, 3.0); }), 4.5, 0.55);
}

// 0.6 s more for good, then quick again: what is 0.6 s late then was held back.
TEST(BacklogGate, ALinkThatIsQuickAgainIsMeasuredByThat) {
  BacklogGate gate;
  gate.judge(9.0, 9.0, kLimit);
  for (int i = 0; i < 100; ++i) gate.judge(10.0 + 0.05 * i, 10.6 + 0.05 * i, kLimit);
  EXPECT_NEAR(gate.slowness(), 0.6, 2e-3);
  EXPECT_EQ(gate.judge(15.0, 15.99, kLimit), Arrival::live);     // 0.39 s later than the link, 0.99 s in all
  EXPECT_EQ(gate.judge(15.05, 16.1, kLimit), Arrival::backlog);  // 1.05 s in all
  EXPECT_EQ(gate.judge(16.2, 16.2, kLimit), Arrival::live);
  EXPECT_EQ(gate.slowness(), 0.0);
  EXPECT_EQ(gate.judge(16.25, 16.85, kLimit), Arrival::backlog);
}

// Late once before a silence and once after it, by the same time: nobody knows what it was meanwhile.
TEST(BacklogGate, AGapIsNoSteadyLag) {
  BacklogGate gate;
  gate.judge(9.0, 9.0, kLimit);
  EXPECT_EQ(gate.judge(10.0, 10.6, kLimit), Arrival::backlog);
  EXPECT_EQ(gate.judge(13.0, 13.6, kLimit), Arrival::backlog);
  EXPECT_EQ(gate.judge(13.05, 13.65, kLimit), Arrival::backlog);
}

// A sender that does not refresh its stamps is still heard of.
TEST(BacklogGate, RepeatedStampsAreNoGap) {
  BacklogGate gate;
  gate.judge(9.0, 9.0, kLimit);
  for (int i = 0; i < 40; ++i) EXPECT_EQ(gate.judge(10.0, 10.6 + 0.05 * i, kLimit), Arrival::backlog);
  EXPECT_EQ(gate.judge(12.05, 12.65, kLimit), Arrival::slower_link);  // 2.05 s after the first
}

}  // namespace
}  // namespace hidwa_local_planner::input
