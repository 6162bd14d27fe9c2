// SPDX-License-Identifier: BSD-3-Clause
#include "ros/host/cycle_clock.hpp"

#include <optional>
#include <string>

#include <gtest/gtest.h>

namespace hidwa_local_planner {
namespace {

/// Remembers when the cycle before was, as the control loop does.
class Clock : public CycleClock {
 public:
  Tick tick(double now, double period) {
    const Tick tick = CycleClock::tick(now, period, last_);
    last_ = now;
    return tick;
  }

 private:
  std::optional<double> last_;  // [s]
};

TEST(CycleClock, TheFirstCallFollowsAPause) {
  Clock clock;
  EXPECT_TRUE(clock.tick(100.0, 0.05).paused);
  EXPECT_EQ(clock.tick(100.01, 0.02).period, 0.02);
  EXPECT_FALSE(clock.tick(100.05, 0.05).paused);
  EXPECT_FALSE(clock.tick(100.25, 0.05).paused);  // three late cycles are no pause
  EXPECT_TRUE(clock.tick(101.0, 0.05).paused);
}

TEST(CycleClock, TimeThatJumpsBackIsAPause) {
  Clock clock;
  clock.tick(100.0, 0.05);
  const CycleClock::Tick tick = clock.tick(5.0, 0.05);
  EXPECT_TRUE(tick.jumped_back);
  EXPECT_TRUE(tick.paused);
  EXPECT_FALSE(clock.tick(5.05, 0.05).jumped_back);
}

std::string complaint_at(double interval, double period) {
  Clock clock;
  std::string said;
  for (int i = 0; i < 200; ++i) {
    clock.tick(interval * i, period);
    said += clock.complaint();
  }
  return said;
}

TEST(CycleClock, ComplainsOnceOfAWrongRate) {
  EXPECT_EQ(complaint_at(0.05, 0.05), "");
  EXPECT_EQ(complaint_at(0.06, 0.05), "");  // 17 % slow
  const std::string said = complaint_at(0.1, 0.05);
  EXPECT_NE(said.find("10.0 Hz"), std::string::npos) << said;
  EXPECT_EQ(said.find("10.0 Hz"), said.rfind("10.0 Hz"));
  EXPECT_NE(said.find("controller_frequency"), std::string::npos);
}

// A pause is longer than 0.3 s, see is_pause().
TEST(HostWasAway, OnlyWhereItDidNotCallForAWhile) {
  CycleClock::Tick tick;
  tick.period = 0.05;
  EXPECT_FALSE(host_was_away(tick, 10.0));  // no pause
  tick.paused = true;
  EXPECT_TRUE(host_was_away(tick, 0.05));  // simulated time may run fast
  tick.jumped_back = true;
  EXPECT_FALSE(host_was_away(tick, 0.05));  // a bag that begins anew
  EXPECT_TRUE(host_was_away(tick, 0.31));
}

}  // namespace
}  // namespace hidwa_local_planner
