// SPDX-License-Identifier: BSD-3-Clause
#include "tracking/free_memory.hpp"

#include <gtest/gtest.h>

#include "support/office_scans.hpp"

namespace hidwa_local_planner::tracking {
namespace {

using test::Random;

double distance_to_segment(const Point& p, const Point& a, const Point& b) {
  const Point d = b - a;
  const double share = d.squaredNorm() > 0.0 ? std::clamp((p - a).dot(d) / d.squaredNorm(), 0.0, 1.0) : 0.0;
  return (p - a - share * d).norm();
}

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
      nearest = std::min(nearest, distance_to_segment(p, corners[i], corners[i + 1]));
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

Beams scan_of(const test::ScanWorld& world, const Pose2& pose, double time, Random& random) {
  std::vector<int> seen;
  Beams beams;
  to_beams(world.scan(time, pose, pose, random, seen), TrackerSettings(), beams);
  return beams;
}

// What `memory` knows of places, by a scan that ends there.
PlaceKind asked(const FreeMemory& memory, const Beams& like, const Point& place) {
  Beams one;
  one.end = like.end;
  one.all.resize(1);
  one.all[0].origin = like.centre;
  one.all[0].length = (place - like.centre).norm();
  one.all[0].direction = (place - like.centre) / one.all[0].length;
  one.all[0].hit = true;
  memory.judge(one, Travel());
  return one.all[0].kind;
}

TEST(FreeMemory, IsTheInsideOfWhatWasSeenLessAMargin) {
  const test::ScanWorld world = test::office();
  const Pose2 poses[] = {{1.5, 6.0, 0.0}, {3.5, 3.0, 2.0}, {11.5, 5.9, -2.2}, {14.5, 3.5, 0.7}};
  int free = 0, deep = 0;
  for (const Pose2& pose : poses) {
    Random random(4);
    FreeMemory memory{TrackerSettings()};
    Beams beams;
    for (int i = 0; i < 3; ++i) {
      beams = scan_of(world, pose, 1.0 + 0.05 * i, random);
      memory.centre_on(beams.centre);
      memory.take(beams, Travel(), 0.05);
    }
    const SeenPolygon polygon(beams);
    for (int i = 0; i < 3000; ++i) {
      const Point place{pose.x + random.uniform(-7.0, 7.0), pose.y + random.uniform(-7.0, 7.0)};
      if ((place - beams.centre).norm() < 0.3) continue;
      const bool was_free = asked(memory, beams, place) == PlaceKind::was_free;
      const double edge = polygon.distance(place);
      // A cell of 0.1 m is kept from being free where it, or a neighbour, holds a part of the edge of the same scan; a
      // place in a free one, whose neighbours are free too, is more than one cell from the edge. Noise moves the edge.
      if (was_free) {
        ++free;
        EXPECT_TRUE(polygon.holds(place) && edge > 0.1) << place.transpose() << " from " << pose.x << " " << pose.y;
      }
      // And with 0.45 m all around, more than three cells' diagonals, it is free where beams are denser than cells.
      const bool dense = (place - beams.centre).norm() < 7.0;
      const Point to = place - beams.centre;
      const double off = std::abs(wrap_angle(std::atan2(to.y(), to.x()) - pose.theta));
      if (polygon.holds(place) && edge > 0.45 && dense && off < 0.75 * M_PI - 0.4) {
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
  test::ScanWorld world = test::hall();
  world.laser.noise = 0.0;
  Random random(5);
  FreeMemory memory{TrackerSettings()};
  double time = 1.0;
  const Point box(7.0, 5.0);
  const auto see = [&](int scans) {
    Beams beams;
    for (int i = 0; i < scans; ++i) {
      time += 0.05;
      beams = scan_of(world, {5.0, 5.0, 0.0}, time, random);
      memory.centre_on(beams.centre);
      memory.take(beams, Travel(), 0.05);
    }
    return beams;
  };
  Beams beams = see(5);
  EXPECT_EQ(asked(memory, beams, box), PlaceKind::was_free);
  world.posts.push_back({box + Point(0.2, 0.0), 0.2});  // its nearest point is `box`
  beams = see(15);                                      // 0.75 s of 1 s
  EXPECT_NE(asked(memory, beams, box), PlaceKind::standing);
  beams = see(10);
  EXPECT_EQ(asked(memory, beams, box), PlaceKind::standing);
  world.posts.clear();
  beams = see(50);
  EXPECT_EQ(asked(memory, beams, box), PlaceKind::was_free);
}

// With odometry that may have shifted the world, a place beside a wall is not known to be free any more.
TEST(FreeMemory, TurningWidensTheMargin) {
  test::ScanWorld world = test::hall();  // a wall at y = 0
  Random random(6);
  FreeMemory memory{TrackerSettings()};
  Beams beams;
  for (int i = 0; i < 3; ++i) {
    beams = scan_of(world, {5.0, 4.0, -0.5 * M_PI}, 1.0 + 0.05 * i, random);
    memory.centre_on(beams.centre);
    memory.take(beams, Travel(), 0.05);
  }
  Beams one = beams;
  one.all.assign(1, Beam());
  one.all[0].origin = beams.centre;
  one.all[0].direction = Point(0.0, -1.0);
  one.all[0].length = 3.6;  // 0.4 m before the wall
  one.all[0].hit = true;
  memory.judge(one, Travel());
  EXPECT_EQ(one.all[0].kind, PlaceKind::was_free);
  memory.judge(one, Travel{0.0, 2.0});  // 0.05 of 2 rad at 3.6 m: 0.36 m
  EXPECT_EQ(one.all[0].kind, PlaceKind::unknown);
}

}  // namespace
}  // namespace hidwa_local_planner::tracking
