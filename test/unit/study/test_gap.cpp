// SPDX-License-Identifier: BSD-3-Clause
// Gaps: who arrives came through the gap, and the narrowest one is what cells allow.
#include <cmath>

#include <gtest/gtest.h>

#include "study/gap_drive.hpp"

namespace hidwa_local_planner {
namespace study {
namespace {

GapSubject without_noise() {
  GapSubject subject;
  subject.subject.parameters.cycle_budget = -1.0;  // the same on any computer
  subject.noise = 0.0;
  return subject;
}

// The wall's faces are at x = -0.1 and 0.1.
TEST(Gaps, TheWayLeadsThroughTheGapOrEndsBeforeTheWall) {
  const drive::DriveResult wide = drive_gap(without_noise(), "circle", 0.9, 0.3, 1);
  ASSERT_TRUE(wide.arrived);
  EXPECT_EQ(wide.contacts, 0);
  int within = 0;
  for (const drive::DriveSample& sample : wide.samples) {
    if (std::abs(sample.pose.x) > 0.1) continue;
    ++within;
    EXPECT_LE(std::abs(sample.pose.y), 0.5 * 0.9 - 0.3);
  }
  EXPECT_GT(within, 5);

  const drive::DriveResult narrow = drive_gap(without_noise(), "circle", 0.5, 0.3, 1);
  EXPECT_FALSE(narrow.arrived);
  EXPECT_EQ(narrow.contacts, 0);
  for (const drive::DriveSample& sample : narrow.samples) EXPECT_LT(sample.pose.x, -0.1);
}

// 0.62 m takes n = 13 cells of 0.05 m: a gap of 14 cells has them wherever it lies, one of less than 13 nowhere.
TEST(Gaps, AreAsNarrowAsTheirCellsSay) {
  for (const double phase : {0.0, 0.5}) {
    EXPECT_TRUE(drive_gap(without_noise(), "circle", 14 * 0.05 + 0.01, phase, 1).arrived) << phase;
    EXPECT_FALSE(drive_gap(without_noise(), "circle", 13 * 0.05 - 0.01, phase, 1).arrived) << phase;
  }
}

}  // namespace
}  // namespace study
}  // namespace hidwa_local_planner
