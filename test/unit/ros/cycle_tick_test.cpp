// SPDX-License-Identifier: BSD-3-Clause
#include "ros/host/cycle_tick.hpp"

#include <optional>

#include <gtest/gtest.h>

namespace hidwa_local_planner {
namespace {

/// A call `interval` [s] after the one before, of a host that calls every 0.05 s.
CycleTick after(double interval) { return cycle_tick(100.0 + interval, 0.05, 100.0); }

TEST(CycleTick, TheFirstCallFollowsAPause) {
  const CycleTick first = cycle_tick(100.0, 0.05, std::nullopt);
  EXPECT_TRUE(first.paused);
  EXPECT_EQ(first.interval, 0.0);
  EXPECT_FALSE(after(0.01).paused);
  EXPECT_FALSE(after(0.2).paused);  // three late cycles are no pause
  EXPECT_NEAR(after(0.2).interval, 0.2, 1e-9);
  EXPECT_TRUE(after(0.75).paused);
}

TEST(CycleTick, TimeThatJumpsBackIsAPause) {
  EXPECT_TRUE(after(-95.0).jumped_back);
  EXPECT_TRUE(after(-95.0).paused);
  EXPECT_FALSE(after(0.05).jumped_back);
}

// A pause is longer than 0.3 s, see is_pause().
TEST(HostWasAway, OnlyWhereItDidNotCallForAWhile) {
  CycleTick tick;
  EXPECT_FALSE(host_was_away(tick, 0.05, 10.0));  // no pause
  tick.paused = true;
  EXPECT_TRUE(host_was_away(tick, 0.05, 0.05));  // simulated time may run fast
  tick.jumped_back = true;
  EXPECT_FALSE(host_was_away(tick, 0.05, 0.05));  // a bag that begins anew
  EXPECT_TRUE(host_was_away(tick, 0.05, 0.31));
}

}  // namespace
}  // namespace hidwa_local_planner
