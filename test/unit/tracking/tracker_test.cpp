// SPDX-License-Identifier: BSD-3-Clause
#include "tracking/tracker.hpp"

#include <functional>
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

#include "support/allocation_counter.hpp"
#include "support/office_scans.hpp"

namespace hidwa_local_planner {
namespace {

using test::Random;
using test::ScanWorld;
using test::Walker;

constexpr double kStep = 0.05;  // [s]
const Pose2 kPlace{7.0, 4.0, 0.5 * M_PI};

ScanWorld hall_with(std::function<Point(double)> at) {
  ScanWorld world = test::hall();
  Walker walker;
  walker.at = std::move(at);
  world.walkers.push_back(walker);
  return world;
}

// Somebody crosses the hall 3 m ahead of the robot, and may stop at a time [s].
ScanWorld crossing(double stops_at = 1e9) {
  return hall_with([stops_at](double time) { return Point(4.0 + 1.0 * std::min(time, stops_at), 7.0); });
}

struct Watch {
  explicit Watch(ScanWorld w, const Pose2& from = kPlace) : world(std::move(w)), place(from) {}
  RangeScan next() {
    time += kStep;
    std::vector<int> seen;
    return world.scan(time, place, place, random, seen);
  }
  void run(double duration) {
    for (double end = time + duration - 0.5 * kStep; time < end;) EXPECT_EQ(tracker.update(next()), ScanUse::used);
  }
  ScanWorld world;
  Pose2 place;  // of the laser
  Random random{3};
  Tracker tracker;
  double time = 0.0;
};

TEST(Tracker, FollowsWhoCrosses) {
  Watch watch(crossing());
  watch.run(2.0);
  ASSERT_EQ(watch.tracker.obstacles().size(), 1u);
  const MovingObstacleEstimate& o = watch.tracker.obstacles()[0];
  EXPECT_DOUBLE_EQ(watch.tracker.stamp(), watch.time);
  EXPECT_LT((o.position - Point(6.0, 7.0)).norm(), 0.1);  // 4 m + 2 s at 1 m/s
  EXPECT_LT((o.velocity - Point(1.0, 0.0)).norm(), 0.15);
  EXPECT_GE(o.radius, 0.25);
  EXPECT_GT(o.points.size(), 5u);
  const std::uint32_t id = o.id;
  watch.run(1.5);
  ASSERT_EQ(watch.tracker.obstacles().size(), 1u);
  EXPECT_EQ(watch.tracker.obstacles()[0].id, id);
}

// From 12 m on, at 1.5 m/s: a robot at 2 m/s would meet him in 3 s. At 10 m a body of 0.5 m has 8 of the 720 beams, of
// 0.0065 rad each: 0.5 m / (10 m x 0.0065).
TEST(Tracker, KnowsWhoComesFromFarAway) {
  ScanWorld world;
  world.walls = {{{-1.0, -4.0}, {16.0, -4.0}}, {{16.0, -4.0}, {16.0, 4.0}}, {{16.0, 4.0}, {-1.0, 4.0}}};
  world.laser.range_max = 30.0;
  Walker walker;
  walker.at = [](double time) { return Point(13.0 - 1.5 * time, 0.5); };
  world.walkers.push_back(walker);
  Watch watch(world, {});
  while (watch.tracker.obstacles().empty() && watch.time < 4.0) watch.run(kStep);
  ASSERT_EQ(watch.tracker.obstacles().size(), 1u);
  const Point found = watch.tracker.obstacles()[0].position;
  EXPECT_GT(found.norm(), 9.0);
  EXPECT_LT((found - walker.at(watch.time)).norm(), 0.2);
}

TEST(Tracker, WhoStopsIsTheCostmapsAgain) {
  Watch watch(crossing(2.0));
  watch.run(2.5);
  EXPECT_EQ(watch.tracker.obstacles().size(), 1u);
  watch.run(9.0);  // stand_time is 10 s, from when the last 0.25 m began: who has walked may walk on
  EXPECT_EQ(watch.tracker.obstacles().size(), 1u);
  watch.run(2.5);
  EXPECT_TRUE(watch.tracker.obstacles().empty());
  watch.run(2.0);
  EXPECT_TRUE(watch.tracker.obstacles().empty());
}

// He stops after 2 s. stand_time, 10 s, counts from when he began the last 0.25 m, 1.75 s or a little later. He walks
// on about then, and has not come 0.25 m when it ends.
TEST(Tracker, WhoWalksOnWhenHeIsAboutToBeDroppedIsTold) {
  int told = 0;
  for (double start = 11.4; start < 12.0; start += 0.1) {
    Watch watch(hall_with(
        [start](double time) { return Point(4.0 + std::min(time, 2.0) + std::max(0.0, time - start), 7.0); }));
    watch.run(start);
    if (watch.tracker.obstacles().empty()) break;  // dropped before
    ++told;
    const std::uint32_t id = watch.tracker.obstacles()[0].id;
    for (int scan = 0; scan < 20; ++scan) {
      watch.run(kStep);
      ASSERT_EQ(watch.tracker.obstacles().size(), 1u) << "walks on at " << start << " s, at " << watch.time << " s";
      EXPECT_EQ(watch.tracker.obstacles()[0].id, id);
    }
  }
  EXPECT_GE(told, 3);
}

// 1 m to the robot's left and on to behind it, where its laser sees nothing: beyond 135 degrees, that is 1 m further.
TEST(Tracker, WhoWalksOutOfViewIsStillThereFor2S) {
  const auto at = [](double time) { return Point(6.0, 6.0 - time); };
  Watch watch(hall_with(at));
  watch.run(3.3);  // at -1.3 m behind it: the last edge of 0.25 m is out of view
  const double left = watch.time;
  watch.run(1.5);
  ASSERT_EQ(watch.tracker.obstacles().size(), 1u);
  const MovingObstacleEstimate& o = watch.tracker.obstacles()[0];
  EXPECT_LT((o.position - at(watch.time)).norm(), 0.2);
  EXPECT_GT(o.velocity_deviation, 0.05);  // nobody has seen whether he walks on
  watch.run(1.0);
  EXPECT_GT(watch.time - left, 2.0);
  EXPECT_TRUE(watch.tracker.obstacles().empty());
}

// Another walks at half the distance, half as fast, and hides his front all the time and the space that he comes into.
TEST(Tracker, FollowsWhoIsNeverSeenWhole) {
  ScanWorld world = test::hall();
  Walker behind, before;
  behind.radius = 0.4;
  behind.at = [](double time) { return Point(5.0 + time, 8.0); };
  // Its shadow at 4 m is 1 m wide and begins at the other's middle.
  before.at = [behind](double time) { return Point(7.0 + 0.5 * (behind.at(time).x() + 0.5 - 7.0), 6.0); };
  world.walkers = {behind, before};
  Watch watch(world);
  watch.run(0.7);
  const Point now = behind.at(watch.time);
  std::size_t found = 0;
  for (const MovingObstacleEstimate& o : watch.tracker.obstacles()) {
    if ((o.position - now).norm() > 0.3) continue;
    ++found;
    EXPECT_LT((o.velocity - Point(1.0, 0.0)).norm(), 0.3);
    EXPECT_TRUE(o.points.empty());  // no beam has seen that space free
  }
  EXPECT_EQ(found, 1u);
}

// 0.8 m, as a door or a chair.
TEST(Tracker, WhatHasOnlyStirredIsTheCostmapsSoon) {
  Watch watch(crossing(0.8));
  watch.run(1.3);
  EXPECT_EQ(watch.tracker.obstacles().size(), 1u);
  watch.run(3.5);  // 2 s, from when the last 0.25 m began
  EXPECT_TRUE(watch.tracker.obstacles().empty());
}

TEST(Tracker, WhatStandsFromTheBeginningIsNoMover) {
  ScanWorld world = test::office();
  world.laser.noise = 0.03;
  Watch watch(world, {3.5, 3.0, 1.0});
  for (int i = 1; i < 400; ++i) {
    watch.run(kStep);
    ASSERT_TRUE(watch.tracker.obstacles().empty()) << i;
  }
}

// Points leave the costmap's copy: only those on the walker, not those of a wall that he walks along.
TEST(Tracker, NeverListsPointsOfAWall) {
  ScanWorld world = crossing();
  world.walls.push_back({{4.0, 7.4}, {10.0, 7.4}});  // 0.15 m beside the body
  Watch watch(world);
  int listed = 0;
  for (int i = 0; i < 100; ++i) {
    watch.tracker.update(watch.next());
    for (const MovingObstacleEstimate& o : watch.tracker.obstacles()) {
      for (const Point& p : o.points) {
        ++listed;
        EXPECT_LT((p - watch.world.walkers[0].at(watch.time)).norm(), 0.25 + 0.05);
      }
    }
  }
  EXPECT_GT(listed, 300);
}

// Nobody may be made out of a person who stood there from the start: his place was never seen free.
TEST(Tracker, WhoStandsFromTheStartHasNoPoints) {
  Watch watch(hall_with([](double time) { return Point(7.0 + std::max(0.0, time - 3.0), 7.0); }));  // goes after 3 s
  watch.run(3.0);
  EXPECT_TRUE(watch.tracker.obstacles().empty());
  watch.run(1.0);
  ASSERT_EQ(watch.tracker.obstacles().size(), 1u);
  for (const Point& p : watch.tracker.obstacles()[0].points) EXPECT_GT((p - Point(7.0, 7.0)).norm(), 0.25);
}

TEST(Tracker, TheSameScansGiveTheSameBits) {
  Watch one(crossing()), other(crossing());
  for (int i = 0; i < 80; ++i) {
    one.tracker.update(one.next());
    other.tracker.update(other.next());
    ASSERT_EQ(one.tracker.obstacles().size(), other.tracker.obstacles().size());
    for (std::size_t k = 0; k < one.tracker.obstacles().size(); ++k) {
      EXPECT_EQ(one.tracker.obstacles()[k].position, other.tracker.obstacles()[k].position);
      EXPECT_EQ(one.tracker.obstacles()[k].velocity, other.tracker.obstacles()[k].velocity);
    }
  }
}

TEST(Tracker, RepeatedScansChangeNothing) {
  Watch watch(crossing());
  watch.run(2.0);
  const RangeScan scan = watch.next();
  EXPECT_EQ(watch.tracker.update(scan), ScanUse::used);
  const MovingObstacleEstimate before = watch.tracker.obstacles().at(0);
  EXPECT_EQ(watch.tracker.update(scan), ScanUse::repeated);
  RangeScan earlier = scan;
  earlier.stamp -= 0.1;
  EXPECT_EQ(watch.tracker.update(earlier), ScanUse::repeated);
  EXPECT_EQ(watch.tracker.obstacles().at(0).position, before.position);
  EXPECT_DOUBLE_EQ(watch.tracker.stamp(), watch.time);
}

TEST(Tracker, AJumpOfTimeForgetsAll) {
  for (double jump : {-5.0, 60.0}) {
    Watch watch(crossing(3.0));
    watch.run(6.0 - 3.5);
    ASSERT_EQ(watch.tracker.obstacles().size(), 1u);
    RangeScan scan = watch.next();
    scan.stamp += jump + (jump < 0.0 ? 4.0 : 0.0);  // at least 0.5 s back, and no time below 0
    EXPECT_EQ(watch.tracker.update(scan), ScanUse::after_jump) << jump;
    EXPECT_TRUE(watch.tracker.obstacles().empty());
    EXPECT_DOUBLE_EQ(watch.tracker.stamp(), scan.stamp);
  }
}

TEST(Tracker, RefusesWhatIsNoScanAndSaysWhy) {
  Watch watch(crossing());
  watch.run(2.0);
  const RangeScan good = watch.next();
  const auto refused = [&](const std::function<void(RangeScan&)>& spoil, const std::string& word) {
    RangeScan bad = good;
    spoil(bad);
    EXPECT_NE(fault_of(bad).find(word), std::string::npos) << fault_of(bad);
    EXPECT_EQ(watch.tracker.update(bad), ScanUse::refused) << word;
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  refused([](RangeScan& s) { s.ranges.clear(); }, "no ranges");
  refused([&](RangeScan& s) { s.stamp = nan; }, "stamp");
  refused([&](RangeScan& s) { s.sensor.theta = nan; }, "pose");
  refused([&](RangeScan& s) { s.sensor_end.x = nan; }, "pose");
  refused([&](RangeScan& s) { s.angle_min = nan; }, "angle_min");
  refused([](RangeScan& s) { s.angle_increment = 0.0; }, "angle_increment");
  refused([](RangeScan& s) { s.angle_increment *= 2.0; }, "turn");
  refused([](RangeScan& s) { s.range_max = s.range_min; }, "range_max");
  refused([](RangeScan& s) { s.time_increment = 1.0; }, "time_increment");
  refused([](RangeScan& s) { s.time_increment = -0.01; }, "time_increment");
  EXPECT_EQ(watch.tracker.obstacles().size(), 1u);
  EXPECT_EQ(watch.tracker.update(good), ScanUse::used);  // nothing was spoilt
}

// Half of all ranges are not numbers, infinite, negative or zero; the number of beams changes from scan to scan.
TEST(Tracker, BearsBrokenRangesAndChangingScans) {
  Watch watch(crossing());
  Random random(11);
  const float broken[] = {std::numeric_limits<float>::quiet_NaN(),
                          std::numeric_limits<float>::infinity(),
                          -std::numeric_limits<float>::infinity(),
                          0.0F,
                          -1.0F,
                          1e30F};
  for (int i = 0; i < 60; ++i) {
    watch.world.laser.beams = random.integer(1, 900);
    RangeScan scan = watch.next();
    if (scan.ranges.size() == 1) scan.angle_increment = 0.01;
    for (float& r : scan.ranges) {
      if (random.chance(0.5)) r = broken[random.integer(0, 5)];
    }
    EXPECT_NE(watch.tracker.update(scan), ScanUse::refused) << fault_of(scan);
    for (const MovingObstacleEstimate& o : watch.tracker.obstacles()) {
      EXPECT_TRUE(o.position.allFinite() && o.velocity.allFinite() && o.radius > 0.0);
      EXPECT_TRUE(o.position_deviation > 0.0 && o.velocity_deviation > 0.0);
    }
  }
  watch.world.laser.beams = 720;
  watch.run(TrackerSettings().coast_time + 1.0);  // what broken scans made is out of sight, and then forgotten
  EXPECT_EQ(watch.tracker.obstacles().size(), 1u);
}

TEST(Tracker, RefusesSettingsAndNamesThem) {
  TrackerSettings settings;
  EXPECT_EQ(fault_of(settings), "");
  settings.reach = 0.5;
  EXPECT_EQ(fault_of(settings), "reach is 0.5: it must be from 1 to 30 m");
  EXPECT_THROW(Tracker{settings}, std::invalid_argument);
  settings = TrackerSettings();
  settings.min_speed = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(fault_of(settings), "min_speed is not finite: it must be from 0.05 to 2 m/s");
  settings = TrackerSettings();
  settings.leg_acceleration = 0.0;
  EXPECT_EQ(fault_of(settings), "leg_acceleration is 0: it must be from 0.1 to 20 m/s^2");
}

// Once it has seen as many things at a time, a scan allocates nothing.
TEST(Tracker, AllocatesNothingOnceItIsWarm) {
  Watch watch(crossing());
  std::vector<RangeScan> scans;
  for (int i = 0; i < 100; ++i) scans.push_back(watch.next());
  for (int i = 0; i < 60; ++i) watch.tracker.update(scans[static_cast<std::size_t>(i)]);
  ASSERT_EQ(watch.tracker.obstacles().size(), 1u);
  const test::AllocationCounter counter;
  for (std::size_t i = 60; i < 75; ++i) watch.tracker.update(scans[i]);
  EXPECT_EQ(counter.count(), 0u);
}

// A laser that turns while the robot turns: with both poses of its sensor a standing wall stands.
TEST(Tracker, ScansThatTakeTimeAreStraightened) {
  ScanWorld world = test::hall();
  world.laser.beams = 360;
  world.laser.view = 2.0 * M_PI * 359 / 360;
  world.laser.noise = 0.0;
  const auto pose = [](double time) { return Pose2{7.0, 7.0, wrap_angle(1.0 * time)}; };
  Random random(1);
  std::vector<int> seen;
  Tracker tracker;
  for (int i = 1; i < 100; ++i) {
    RangeScan scan;
    scan.stamp = 0.2 * i;
    scan.time_increment = 0.2 / 359;
    scan.sensor = pose(scan.stamp);
    scan.sensor_end = pose(scan.stamp + 0.2);
    for (int b = 0; b < 360; ++b) {  // each beam from where the sensor was then
      const Pose2 then = pose(scan.stamp + scan.time_increment * b);
      const RangeScan all = world.scan(0.0, then, then, random, seen);
      scan.ranges.push_back(all.ranges[static_cast<std::size_t>(b)]);
      scan.angle_min = all.angle_min;
      scan.angle_increment = all.angle_increment;
      scan.range_max = all.range_max;
    }
    ASSERT_EQ(tracker.update(scan), ScanUse::used) << fault_of(scan);
    EXPECT_TRUE(tracker.obstacles().empty()) << i;
  }
}

}  // namespace
}  // namespace hidwa_local_planner
