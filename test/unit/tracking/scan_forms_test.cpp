// SPDX-License-Identifier: BSD-3-Clause
// Somebody crosses a hall, seen by lasers whose scans have other forms.
#include <algorithm>
#include <functional>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "support/office_scans.hpp"
#include "tracking/tracker.hpp"

namespace hidwa_local_planner {
namespace {

using test::Random;
using test::ScanWorld;
using test::Walker;

constexpr double kStep = 0.05;  // [s]
const Pose2 kPlace{7.0, 4.0, 0.5 * M_PI};

using Spoil = std::function<void(RangeScan&, Random&)>;

struct Form {
  std::string name;
  int beams;
  Spoil spoil;
};

void leave(RangeScan& /*unused*/, Random& /*unused*/) {}

// One beam in five.
Spoil some(float value) {
  return [value](RangeScan& scan, Random& random) {
    for (float& range : scan.ranges) {
      if (random.uniform(0.0, 1.0) < 0.2) range = value;
    }
  };
}

void reverse(RangeScan& scan, Random& /*unused*/) {
  scan.angle_min += scan.angle_increment * static_cast<double>(scan.ranges.size() - 1);
  scan.angle_increment = -scan.angle_increment;
  std::reverse(scan.ranges.begin(), scan.ranges.end());
}

MovingObstacleEstimates after_two_seconds(const Form& form) {
  ScanWorld world = test::hall();
  world.laser.beams = form.beams;
  Walker walker;
  walker.at = [](double time) { return Point(4.0 + time, 7.0); };
  world.walkers.push_back(walker);
  Random noise(3), own(7);
  Tracker tracker;
  std::vector<int> seen;
  for (int i = 1; i <= 40; ++i) {
    RangeScan scan = world.scan(kStep * i, kPlace, kPlace, noise, seen);
    form.spoil(scan, own);
    EXPECT_EQ(tracker.update(scan), ScanUse::used) << form.name << ": " << fault_of(scan);
  }
  return tracker.obstacles();
}

// 4 m + 2 s at 1 m/s; the person is 3 m away.
TEST(ScanForms, EachShowsWhoCrosses) {
  const Form forms[] = {
      {"3600 beams", 3600, leave},
      {"181 beams, 1.5 degrees", 181, leave},
      {"some infinite", 720, some(std::numeric_limits<float>::infinity())},
      {"some not a number", 720, some(std::numeric_limits<float>::quiet_NaN())},
      {"some zero", 720, some(0.0F)},
      {"some below range_min", 720, some(0.01F)},
      {"clockwise", 720, reverse},
  };
  for (const Form& form : forms) {
    SCOPED_TRACE(form.name);
    const MovingObstacleEstimates obstacles = after_two_seconds(form);
    ASSERT_EQ(obstacles.size(), 1u);
    EXPECT_LT((obstacles[0].position - Point(6.0, 7.0)).norm(), 0.15);
    EXPECT_LT((obstacles[0].velocity - Point(1.0, 0.0)).norm(), 0.2);
  }
}

TEST(ScanForms, ClockwiseIsTheSameAsCounterClockwise) {
  const MovingObstacleEstimates there = after_two_seconds({"as it is", 720, leave});
  const MovingObstacleEstimates back = after_two_seconds({"clockwise", 720, reverse});
  ASSERT_EQ(there.size(), 1u);
  ASSERT_EQ(back.size(), 1u);
  EXPECT_LT((there[0].position - back[0].position).norm(), 1e-3);
  EXPECT_LT((there[0].velocity - back[0].velocity).norm(), 1e-2);
}

TEST(ScanForms, AScanThatSaysNothingIsRefusedByName) {
  ScanWorld world = test::hall();
  Random random(3);
  std::vector<int> seen;
  RangeScan scan = world.scan(1.0, kPlace, kPlace, random, seen);
  for (const float value : {0.0F, 0.01F, std::numeric_limits<float>::quiet_NaN()}) {
    std::fill(scan.ranges.begin(), scan.ranges.end(), value);
    EXPECT_NE(fault_of(scan).find("no range says anything"), std::string::npos);
    EXPECT_EQ(Tracker().update(scan), ScanUse::refused);
  }
  scan.ranges[100] = 2.0F;
  EXPECT_EQ(fault_of(scan), "");
  std::fill(scan.ranges.begin(), scan.ranges.end(), std::numeric_limits<float>::infinity());
  EXPECT_EQ(fault_of(scan), "");  // nothing within reach
}

}  // namespace
}  // namespace hidwa_local_planner
