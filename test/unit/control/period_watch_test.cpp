// SPDX-License-Identifier: BSD-3-Clause
#include "hidwa_local_planner/control/period_watch.hpp"

#include <gtest/gtest.h>

namespace hidwa_local_planner {
namespace {

constexpr double kPeriod = 0.05;  // [s]

TEST(PeriodWatch, AtFirstThePeriodItself) { EXPECT_EQ(PeriodWatch().longest(kPeriod), kPeriod); }

TEST(PeriodWatch, CyclesOnTimeChangeNothing) {
  PeriodWatch watch;
  for (int k = 1; k < 200; ++k) watch.observe(kPeriod * k, k % 2 > 0 ? 0.045 : 0.05);
  EXPECT_EQ(watch.longest(kPeriod), kPeriod);
}

TEST(PeriodWatch, TheLongestCountsUpToThreePeriods) {
  PeriodWatch watch;
  watch.observe(10.0, 0.08);
  watch.observe(10.05, 0.05);
  EXPECT_EQ(watch.longest(kPeriod), 0.08);
  watch.observe(10.1, 0.4);
  EXPECT_NEAR(watch.longest(kPeriod), 0.15, 1e-12);  // 3 * 0.05
  EXPECT_EQ(watch.longest(0.2), 0.4);                // of another period: 3 * 0.2 is more
}

// It is kept for 3 s, to the quarter of a second in which it came: no less than 2.75 s.
TEST(PeriodWatch, ForgetsAfterThreeSeconds) {
  PeriodWatch watch;
  watch.observe(10.2, 0.1);
  watch.observe(12.9, kPeriod);
  EXPECT_EQ(watch.longest(kPeriod), 0.1);
  watch.observe(12.95, kPeriod);
  EXPECT_EQ(watch.longest(kPeriod), 0.1);
  watch.observe(13.0, kPeriod);
  EXPECT_EQ(watch.longest(kPeriod), kPeriod);
}

TEST(PeriodWatch, AfterALongSilenceNothingIsLeft) {
  PeriodWatch watch;
  watch.observe(10.0, 0.1);
  watch.observe(1e6, kPeriod);
  EXPECT_EQ(watch.longest(kPeriod), kPeriod);
}

TEST(PeriodWatch, TimeThatGoesBackForgets) {
  PeriodWatch watch;
  watch.observe(100.0, 0.1);
  watch.observe(-7.3, 0.06);
  EXPECT_EQ(watch.longest(kPeriod), 0.06);
  watch.observe(-7.2, kPeriod);
  EXPECT_EQ(watch.longest(kPeriod), 0.06);
}

TEST(PeriodWatch, ResetForgets) {
  PeriodWatch watch;
  watch.observe(1.0, 0.1);
  watch.reset();
  EXPECT_EQ(watch.longest(kPeriod), kPeriod);
}

}  // namespace
}  // namespace hidwa_local_planner
