// SPDX-License-Identifier: BSD-3-Clause
#include "control/period_watch.hpp"

#include <gtest/gtest.h>

namespace hidwa_local_planner {
namespace {

constexpr double kPeriod = 0.05;  // [s]

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

// It is kept for 3 s and one period of up to 0.25 s more, then to the end of a slot of 0.25 s: no longer than 3.5 s.
TEST(PeriodWatch, CountsForThreeSecondsAndAPeriodWheneverItCame) {
  for (const double period : {0.025, 0.05, 0.1, 0.2, 0.25}) {
    for (int begin = 0; begin < 100; ++begin) {
      const double late = 10.0 + 0.0099 * begin;  // at all places in its slot [s]
      PeriodWatch watch;
      watch.observe(late, 2.5 * period);
      double now = late;
      while (now + period <= late + 3.0 + period) {
        now += period;
        watch.observe(now, period);
        ASSERT_EQ(watch.longest(period), 2.5 * period) << now - late << " s after it, at " << late;
      }
      watch.observe(late + 3.5, period);
      EXPECT_EQ(watch.longest(period), period) << late;
    }
  }
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
