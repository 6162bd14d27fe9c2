// SPDX-License-Identifier: BSD-3-Clause
#include "tracking/field_of_view.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "tracking/tracker.hpp"

namespace hidwa_local_planner {
namespace {

constexpr double kDegree = M_PI / 180.0;
constexpr float kNothing = std::numeric_limits<float>::quiet_NaN();

// A beam each degree, from `first` on; all end 3 m away.
RangeScan scan(double stamp, double first, std::size_t beams) {
  RangeScan scan;
  scan.stamp = stamp;
  scan.angle_min = kDegree * first;
  scan.angle_increment = kDegree;
  scan.range_min = 0.1;
  scan.range_max = 8.0;
  scan.ranges.assign(beams, 3.0F);
  return scan;
}

void silence(RangeScan& scan, std::size_t from, std::size_t to) {
  for (std::size_t i = from; i < to; ++i) scan.ranges[i] = kNothing;
}

SensorSectors seen_by(const std::vector<RangeScan>& scans) {
  Tracker tracker;
  for (const RangeScan& one : scans) EXPECT_EQ(tracker.update(one), ScanUse::used);
  return tracker.field_of_view();
}

TEST(FieldOfView, IsWhatTheScansCover) {
  const SensorSectors sectors = seen_by({scan(1.0, -135.0, 271)});
  ASSERT_EQ(sectors.size(), 1U);
  EXPECT_NEAR(sectors[0].pose.theta, 0.0, 1e-9);
  EXPECT_NEAR(sectors[0].width, 271.0 * kDegree, 1e-9);  // half a degree beyond each of the outermost beams
  EXPECT_EQ(sectors[0].range, 8.0);                      // of the laser; the tracker looks at 12 m
}

TEST(FieldOfView, OfAClockwiseLaserIsTheSame) {
  RangeScan clockwise = scan(1.0, 90.0, 121);
  clockwise.angle_increment = -kDegree;
  const SensorSectors sectors = seen_by({clockwise});
  ASSERT_EQ(sectors.size(), 1U);
  EXPECT_NEAR(sectors[0].pose.theta, 30.0 * kDegree, 1e-9);  // from 90 to -30 degrees
  EXPECT_NEAR(sectors[0].width, 121.0 * kDegree, 1e-9);
}

TEST(FieldOfView, AWholeTurnHasNoEnd) {
  const SensorSectors sectors = seen_by({scan(1.0, -180.0, 360)});
  ASSERT_EQ(sectors.size(), 1U);
  EXPECT_GE(sectors[0].width, 2.0 * M_PI);
}

TEST(FieldOfView, WhatIsMaskedIsNotSeenAndNarrowGapsDoNotCount) {
  RangeScan masked = scan(1.0, -180.0, 360);
  silence(masked, 100, 109);  // 9 beams: narrow
  silence(masked, 170, 200);  // from -10 to 19 degrees
  const SensorSectors sectors = seen_by({masked});
  ASSERT_EQ(sectors.size(), 1U);
  EXPECT_NEAR(sectors[0].width, 330.0 * kDegree, 1e-9);
  EXPECT_NEAR(std::abs(wrap_angle(sectors[0].pose.theta - 184.5 * kDegree)), 0.0, 1e-9);  // half way from 20 to 349
}

TEST(FieldOfView, ABeamThatAnsweredOnceIsKnownToSee) {
  RangeScan first = scan(1.0, -90.0, 181), second = scan(1.1, -90.0, 181);
  silence(first, 0, 60);
  EXPECT_NEAR(seen_by({first})[0].width, 121.0 * kDegree, 1e-9);
  silence(second, 100, 181);
  EXPECT_NEAR(seen_by({first, second})[0].width, 181.0 * kDegree, 1e-9);
}

TEST(FieldOfView, ALaserThatSaysNothingSeesNothing) {
  RangeScan one = scan(1.0, -90.0, 181);
  silence(one, 0, 180);
  const SensorSectors sectors = seen_by({one});
  ASSERT_EQ(sectors.size(), 1U);
  EXPECT_NEAR(sectors[0].width, kDegree, 1e-9);
}

}  // namespace
}  // namespace hidwa_local_planner
