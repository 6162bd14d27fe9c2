// SPDX-License-Identifier: BSD-3-Clause
#include "core/motion/command_ramp.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "support/naive_ramp.hpp"
#include "support/random.hpp"

namespace hidwa_local_planner {
namespace {

constexpr double kPeriod = 0.05;  // [s]

AxisLimits axis(double acc, double braking) { return {-5.0, 5.0, acc, braking}; }

AxisLimits random_axis(test::Random& random) {
  const double acc = random.uniform(0.5, 5.0), braking = random.uniform(0.5, 5.0);
  return axis(acc, braking);
}

TEST(AxisRamp, NothingToDo) {
  const AxisRamp ramp(axis(2.5, 2.5), 0.3, 0.3, kPeriod);
  EXPECT_EQ(ramp.at(0.0), 0.3);
  EXPECT_EQ(ramp.at(0.02), 0.3);
  EXPECT_EQ(ramp.spread(kPeriod), 0.0);
  EXPECT_EQ(ramp.spread(0.0), 0.0);
}

// Random velocities that the limits allow within the period, or not.
struct Ramp {
  Ramp(test::Random& random) : limits(random_axis(random)), from(random.uniform(-1.0, 1.0)) {
    const double most = 0.1 * random.uniform(0.2, 5.0);
    to = random.chance(0.3) ? -random.uniform(0.0, 1.0) * from : from + random.uniform(-most, most);
    if (random.chance(0.3)) from *= 0.05, to *= 0.05;
    naive = {limits.acc, limits.braking, period};
  }
  // A way between the two ends: at each time a share of the one and the rest of the other.
  double between(double share, double t) const {
    const double limit = test::naive_at_limit(naive, from, to, t);
    const bool one = !test::naive_has_time(naive, from, to);
    return one ? limit : share * limit + (1.0 - share) * test::naive_evenly(naive, from, to, t);
  }
  AxisLimits limits;
  double from, to = 0.0, period = kPeriod;
  test::NaiveAxis naive{};
};

// And none gets farther than at(), where it does not turn round.
TEST(AxisRamp, NoWayBetweenTheTwoEndsIsFartherOffThanTheSpread) {
  test::Random random(11);
  double tightest = 1.0;
  int free = 0, turning = 0;
  for (int k = 0; k < 2000; ++k) {
    const Ramp r(random);
    const AxisRamp ramp(r.limits, r.from, r.to, r.period);
    constexpr int kSteps = 400;
    const double dt = kPeriod / kSteps;
    double off = 0.0, share = random.chance(0.5) ? 0.0 : 1.0;
    for (int step = 0; step < kSteps; ++step) {
      const double t = (step + 0.5) * dt;
      if (random.chance(0.01)) share = random.uniform(0.0, 1.0);
      const double here = ramp.at(t), there = r.between(share, t);
      const bool turns_round = r.from * r.to < 0.0;
      ASSERT_TRUE(turns_round || std::abs(here) >= std::abs(there) - 1e-9) << k;
      off += std::abs(here - there) * dt;
      ASSERT_LE(off, ramp.spread((step + 1) * dt) + 1e-6) << k;
    }
    ASSERT_NEAR(ramp.at(kPeriod), r.between(share, kPeriod), 1e-9) << k;
    free += ramp.spread(kPeriod) > 1e-6;
    turning += r.from * r.to < 0.0 && ramp.spread(kPeriod) > 1e-6;
    if (ramp.spread(kPeriod) > 1e-4) tightest = std::min(tightest, 1.0 - off / ramp.spread(kPeriod));
  }
  EXPECT_GT(free, 500);
  EXPECT_GT(turning, 50);
  EXPECT_LT(tightest, 0.01);  // it is no larger than it must be
}

TEST(AxisRamp, AsTheTwin) {
  test::Random random(12);
  for (int k = 0; k < 5000; ++k) {
    const Ramp r(random);
    const AxisRamp ramp(r.limits, r.from, r.to, r.period), lagging(r.limits, r.from, r.to, r.period, true);
    const double t = random.uniform(0.0, 2.0 * kPeriod);
    ASSERT_NEAR(ramp.at(t), test::naive_farthest(r.naive, r.from, r.to, t), 1e-8) << k;
    ASSERT_NEAR(lagging.at(t), test::naive_lagging(r.naive, r.from, r.to, t), 1e-8) << k;
    for (const bool lags : {false, true}) {
      const AxisRamp& one = lags ? lagging : ramp;
      const std::vector<double> corners = test::naive_corners(r.naive, r.from, r.to, lags);
      ASSERT_NEAR(one.corner(), corners.front(), 1e-9) << k;
      ASSERT_NEAR(one.reached(), corners.back(), 1e-9) << k;
      ASSERT_NEAR(one.spread(t), test::naive_spread(r.naive, r.from, r.to, t), 1e-8) << k;
    }
  }
}

// The next command takes effect before this one is reached. Two bases that did it differently differ then, and still on
// the way to the next one.
TEST(AxisRamp, CutShortTheSpreadCoversWhatFollows) {
  test::Random random(14);
  int cut_short = 0;
  for (int k = 0; k < 2000; ++k) {
    const Ramp r(random);
    const AxisRamp ramp(r.limits, r.from, r.to, r.period);
    const double cut = random.uniform(0.3, 1.0) * kPeriod;
    if (ramp.spread(cut) < 1e-6) continue;
    ++cut_short;
    const double next = ramp.at(cut), share = random.uniform(0.0, 1.0);
    const double other = r.between(share, cut);
    constexpr int kSteps = 1000;
    const double dt = 3.0 * kPeriod / kSteps;
    double off = 0.0;
    for (int step = 0; step < kSteps; ++step) {
      const double t = (step + 0.5) * dt;
      const double here = t < cut ? ramp.at(t) : next;  // what it has is the next command
      const double there = t < cut ? r.between(share, t) : test::naive_evenly(r.naive, other, next, t - cut);
      off += std::abs(here - there) * dt;
    }
    ASSERT_LE(off, ramp.spread(cut) + 1e-6) << k;
  }
  EXPECT_GT(cut_short, 300);
}

TEST(CommandRamp, CornersOfBothAxesInOrder) {
  VelocityLimits limits;
  limits.x = axis(2.5, 2.5);
  limits.theta = axis(3.2, 3.2);
  const CommandRamp ramp(limits, {0.3, 0.0}, {0.35, 0.08}, kPeriod);  // 0.02 s and 0.025 s
  const auto corners = ramp.corners(0.06);
  EXPECT_NEAR(corners[0], 0.02, 1e-12);
  EXPECT_NEAR(corners[1], 0.02, 1e-12);
  EXPECT_NEAR(corners[2], 0.025, 1e-12);
  EXPECT_NEAR(corners[3], 0.025, 1e-12);
  EXPECT_EQ(corners[4], 0.06);
  EXPECT_EQ(ramp.corners(0.01)[0], 0.01);
  EXPECT_NEAR(ramp.at(0.0225).omega, 0.072, 1e-12);
  EXPECT_EQ(ramp.at(0.0225).v, 0.35);
  EXPECT_NEAR(ramp.spread(kPeriod).v, 0.00075, 1e-12);
  EXPECT_NEAR(ramp.spread(kPeriod).omega, 0.08 * 0.025 / 2.0, 1e-12);
}

}  // namespace
}  // namespace hidwa_local_planner
