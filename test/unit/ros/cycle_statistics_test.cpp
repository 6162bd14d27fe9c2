// SPDX-License-Identifier: BSD-3-Clause
#include "ros/cycle_statistics.hpp"

#include <gtest/gtest.h>

namespace hidwa_local_planner {
namespace {

TEST(CycleStatistics, NothingYet) {
  const CycleStatistics::Summary summary = CycleStatistics().summary();
  EXPECT_EQ(summary.cycles, 0u);
  EXPECT_EQ(summary.p50, 0.0);
}

TEST(CycleStatistics, QuantilesOfTheLastThousand) {
  CycleStatistics statistics;
  for (int i = 0; i < 500; ++i) statistics.add(9.0, 1.0);                     // forgotten but for its count
  for (int i = 1; i <= 1000; ++i) statistics.add(1e-3 * (1001 - i), 0.9995);  // 1.000, 0.999, ... 0.001
  const CycleStatistics::Summary summary = statistics.summary();
  EXPECT_EQ(summary.cycles, 1500u);
  EXPECT_EQ(summary.late, 501u);        // the 500, and 1.000
  EXPECT_DOUBLE_EQ(summary.p50, 0.5);   // the 500th of 1000
  EXPECT_DOUBLE_EQ(summary.p99, 0.99);  // index 999 * 99 / 100 = 989
  EXPECT_DOUBLE_EQ(summary.max, 1.0);
}

}  // namespace
}  // namespace hidwa_local_planner
