// SPDX-License-Identifier: BSD-3-Clause
#include "tracking/free_memory.hpp"

#include <gtest/gtest.h>

#include "support/naive_gap.hpp"
#include "support/office_scans.hpp"

namespace hidwa_local_planner::tracking {
namespace {

using test::Random;

// The slow twin: the polygon of all ends, closed by the sensor; a place's distance from it, and whether it is inside
// (the crossings of a ray to the right).
struct SeenPolygon {
  std::vector<Point> corners;

  explicit SeenPolygon(const Beams& beams) {
    corners.push_back(beams.centre);
    for (const Beam& beam : beams.all) corners.push_back(beam.tip());
  }
  double distance(const Point& p) const {  // to what was seen; the sides at the sensor are no edge
    double nearest = 1e9;
    for (std::size_t i = 1; i + 1 < corners.size(); ++i)
      nearest = std::min(nearest, test::naive_to_segment(p, corners[i], corners[i + 1]));
    return nearest;
  }
  bool holds(const Point& p) const {
    bool in = false;
    for (std::size_t i = 0, j = corners.size() - 1; i < corners.size(); j = i++) {
      const Point& a = corners[i];
      const Point& b = corners[j];
      if ((a.y() > p.y()) != (b.y() > p.y()) && p.x() < a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x()))
        in = !in;
    }
    return in;
  }
};

// A memory of what a laser has seen in a world.
struct Watch {
  Watch(test::ScanWorld seen, std::uint64_t seed) : world(std::move(seen)), random(seed) {}

  void see(const Pose2& pose, int scans) {
    std::vector<int> seen;
    for (int i = 0; i < scans; ++i) {
      to_beams(world.scan(time, pose, pose, random, seen), TrackerSettings(), beams);
      memory.centre_on(beams.centre);
      memory.take(beams, Travel(), 0.05);
      time += 0.05;
    }
  }
  /// What is known of a place, by a scan that ends there.
  PlaceKind kind_of(const Point& place, const Travel& travel = Travel()) const {
    Beams one;
    one.end = beams.end;
    one.all.resize(1);
    one.all[0].origin = beams.centre;
    one.all[0].length = (place - beams.centre).norm();
    one.all[0].direction = (place - beams.centre) / one.all[0].length;
    one.all[0].hit = true;
    memory.judge(one, travel);
    return one.all[0].kind;
  }

  test::ScanWorld world;
  Random random;
  FreeMemory memory{TrackerSettings()};
  Beams beams;        // of the last scan
  double time = 1.0;  // [s]
};

TEST(FreeMemory, IsTheInsideOfWhatWasSeenLessAMargin) {
  const Pose2 poses[] = {{1.5, 6.0, 0.0}, {3.5, 3.0, 2.0}, {11.5, 5.9, -2.2}, {14.5, 3.5, 0.7}};
  int free = 0, deep = 0;
  for (const Pose2& pose : poses) {
    Watch watch(test::office(), 4);
    watch.see(pose, 3);
    const SeenPolygon polygon(watch.beams);
    for (int i = 0; i < 3000; ++i) {
      const Point place{pose.x + watch.random.uniform(-7.0, 7.0), pose.y + watch.random.uniform(-7.0, 7.0)};
      const Point to = place - watch.beams.centre;
      if (to.norm() < 0.3) continue;
      const bool was_free = watch.kind_of(place) == PlaceKind::was_free;
      const double edge = polygon.distance(place);
      // A cell of 0.1 m is kept from being free where it, or a neighbour, holds a part of the edge of the same scan; a
      // place in a free one, whose neighbours are free too, is more than one cell from the edge. Noise moves the edge.
      if (was_free) {
        ++free;
        EXPECT_TRUE(polygon.holds(place) && edge > 0.1) << place.transpose() << " from " << pose.x << " " << pose.y;
      }
      // And with 0.45 m all around, more than three cells' diagonals, it is free where beams are denser than cells.
      const double off = std::abs(wrap_angle(std::atan2(to.y(), to.x()) - pose.theta));
      if (polygon.holds(place) && edge > 0.45 && to.norm() < 7.0 && off < 0.75 * M_PI - 0.4) {
        ++deep;
        EXPECT_TRUE(was_free) << place.transpose() << " from " << pose.x << " " << pose.y;
      }
    }
  }
  EXPECT_GT(free, 1000);
  EXPECT_GT(deep, 500);
}

// Whatever stands for settle_time is the costmap's; it is free again when it was seen free for as long.
TEST(FreeMemory, WhatStandsSettlesAndIsForgotten) {
  Watch watch(test::hall(), 5);
  watch.world.laser.noise = 0.0;
  const Point box(7.0, 5.0);
  const Pose2 pose{5.0, 5.0, 0.0};
  watch.see(pose, 5);
  EXPECT_EQ(watch.kind_of(box), PlaceKind::was_free);
  watch.world.posts.push_back({box + Point(0.2, 0.0), 0.2});  // its nearest point is `box`
  watch.see(pose, 15);                                        // 0.75 s of 1 s
  EXPECT_NE(watch.kind_of(box), PlaceKind::standing);
  watch.see(pose, 10);
  EXPECT_EQ(watch.kind_of(box), PlaceKind::standing);
  watch.world.posts.clear();
  watch.see(pose, 50);
  EXPECT_EQ(watch.kind_of(box), PlaceKind::was_free);
}

// With odometry that may have shifted the world, a place beside a wall is not known to be free any more.
TEST(FreeMemory, TurningWidensTheMargin) {
  Watch watch(test::hall(), 6);  // a wall at y = 0
  watch.see({5.0, 4.0, -0.5 * M_PI}, 3);
  const Point before_the_wall(5.0, 0.4);
  EXPECT_EQ(watch.kind_of(before_the_wall), PlaceKind::was_free);
  EXPECT_EQ(watch.kind_of(before_the_wall, {0.0, 2.0}), PlaceKind::unknown);  // 0.05 of 2 rad at 3.6 m: 0.36 m
}

}  // namespace
}  // namespace hidwa_local_planner::tracking
