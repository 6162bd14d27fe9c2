// SPDX-License-Identifier: BSD-3-Clause
#include "input/backlog_gate.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace hidwa_local_planner::input {
namespace {

using Arrival = BacklogGate::Arrival;
constexpr BacklogGate::Limits kLimit{0.5, 1.0};

struct Message {
  double stamp, received;  // [s]
  Arrival arrival;
};

struct Story {
  const char* name;
  std::vector<Message> messages;
};

TEST(BacklogGate, FewMessages) {
  const Arrival live = Arrival::live, backlog = Arrival::backlog;
  const Story stories[] = {
      {"empty stamps always pass", {{0.0, 10.0, live}, {0.0, 11.0, live}, {0.0, 99.0, live}}},
      {"the smallest lag is what counts",
       {{10.0, 10.4, live},
        {11.0, 11.8, live},       // 0.8 - 0.4
        {12.0, 12.1, live},       // the smallest: 0.1
        {13.0, 13.8, backlog}}},  // 0.8 - 0.1
      {"a repeated stamp is judged once",
       {{10.0, 10.0, live},
        {10.0, 19.0, live},  // held still for 9 s, the stamp not refreshed
        {19.05, 19.05, live},
        {20.0, 23.0, backlog},
        {20.0, 23.0, backlog}}},
      {"two messages may change places",
       {{50.1, 10.2, live},
        {50.05, 10.25, live},  // 0.1 s late
        {50.15, 10.26, live}}},
      {"stamps that leap forward pass", {{10.0, 10.0, live}, {1e6, 10.05, live}, {1e6 + 0.05, 10.1, live}}},
      // Late once before a silence and once after it, by the same time: nobody knows what it was meanwhile.
      {"a gap is no steady lag",
       {{9.0, 9.0, live}, {10.0, 10.6, backlog}, {13.0, 13.6, backlog}, {13.05, 13.65, backlog}}},
  };
  for (const Story& story : stories) {
    BacklogGate gate;
    for (const Message& message : story.messages) {
      EXPECT_EQ(gate.judge(message.stamp, message.received, kLimit), message.arrival)
          << story.name << ": " << message.received;
    }
  }
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

// Old messages among live ones are backlog, however long that lasts.
TEST(BacklogGate, OldMessagesAmongLiveOnes) {
  BacklogGate gate;
  for (int i = 0; i < 400; ++i) {
    const double now = 10.0 + 0.05 * i;
    EXPECT_EQ(gate.judge(now, now, kLimit), Arrival::live);
    EXPECT_EQ(gate.judge(now - 3.0, now, kLimit), Arrival::backlog);
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

// Two clocks that part by 100 ppm for a day: 8.6 s in the end, and never a message dropped.
TEST(BacklogGate, ClocksMayDrift) {
  BacklogGate gate;
  for (int i = 0; i <= 86400; ++i) {
    const double received = 1000.0 + i;
    ASSERT_EQ(gate.judge(received - 1e-4 * i, received, kLimit), Arrival::live) << i;
  }
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

// A sender that does not refresh its stamps is still heard of.
TEST(BacklogGate, RepeatedStampsAreNoGap) {
  BacklogGate gate;
  gate.judge(9.0, 9.0, kLimit);
  for (int i = 0; i < 40; ++i) EXPECT_EQ(gate.judge(10.0, 10.6 + 0.05 * i, kLimit), Arrival::backlog);
  EXPECT_EQ(gate.judge(12.05, 12.65, kLimit), Arrival::slower_link);  // 2.05 s after the first
}

}  // namespace
}  // namespace hidwa_local_planner::input
