// SPDX-License-Identifier: BSD-3-Clause
#include "tracking/segments.hpp"

#include <algorithm>
#include <tuple>

#include <gtest/gtest.h>

#include "support/office_scans.hpp"

namespace hidwa_local_planner::tracking {
namespace {

using test::Random;

// A turn of 360 beams from (3, 3) in the hall with posts, that begins at the bearing of beam `first`.
Beams turn_from(int first, std::uint64_t seed) {
  test::ScanWorld world = test::hall();
  world.posts = {{{1.5, 3.0}, 0.3}, {{3.4, 4.5}, 0.1}, {{5.0, 2.0}, 0.4}, {{3.0, 1.0}, 0.07}};
  world.laser.beams = 360;
  world.laser.view = 2.0 * M_PI * 359 / 360;
  world.laser.noise = 0.0;
  Random random(seed);
  std::vector<int> seen;
  const Pose2 pose{3.0, 3.0, 2.0 * M_PI * first / 360};
  TrackerSettings settings;
  settings.reach = 8.0;  // the hall's far walls are out of it
  Beams beams;
  to_beams(world.scan(1.0, pose, pose, random, seen), settings, beams);
  return beams;
}

std::vector<std::tuple<int, int, std::size_t>> sorted(const std::vector<Segment>& segments) {
  std::vector<std::tuple<int, int, std::size_t>> out;  // where it begins [mm], how many points
  for (const Segment& s : segments) {
    out.emplace_back(static_cast<int>(std::lround(1e3 * s.chord_begin.x())),
                     static_cast<int>(std::lround(1e3 * s.chord_begin.y())), s.points);
  }
  std::sort(out.begin(), out.end());
  return out;
}

void find(const Beams& beams, double noise, std::vector<Segment>& out) {
  std::vector<std::size_t> hull;
  find_segments(beams, noise, 1.3, out, hull);
}

// Where a whole turn begins makes no difference, also in the middle of a body.
TEST(Segments, DoNotDependOnWhereATurnBegins) {
  std::vector<Segment> segments;
  find(turn_from(0, 1), 0.0, segments);
  const auto expected = sorted(segments);
  ASSERT_EQ(expected.size(), 4u);
  for (int first = 1; first < 360; ++first) {
    find(turn_from(first, 1), 0.0, segments);
    EXPECT_EQ(sorted(segments), expected) << first;
  }
}

// The obvious way, for scans without gaps: two neighbouring points are of one surface, or not.
TEST(Segments, AreRunsOfNeighboursThatAreNear) {
  const Beams beams = turn_from(90, 1);
  std::vector<Segment> segments;
  find(beams, 0.0, segments);
  for (const Segment& s : segments) {
    EXPECT_LE(s.chord(), 1.3);
    std::size_t points = 0;
    for_points(beams, s, [&](std::size_t) { ++points; });
    EXPECT_EQ(points, s.points);
    for (std::size_t i = s.first; i != s.last; i = (i + 1) % 360) {
      EXPECT_LT((beams.all[i].tip() - beams.all[(i + 1) % 360].tip()).norm(), 0.35);
    }
    const std::size_t after = (s.last + 1) % 360;
    EXPECT_GT((beams.all[s.last].tip() - beams.all[after].tip()).norm(), 0.12);
  }
}

// What the laser sees of these bodies from (3, 3), all of it where space was seen free, or nothing known.
Beams see(const std::vector<test::Post>& posts, double noise, PlaceKind kind, std::uint64_t seed) {
  test::ScanWorld world;
  world.posts = posts;
  world.laser.noise = noise;
  Random random(seed);
  std::vector<int> seen;
  const Pose2 pose{3.0, 3.0, 0.0};
  Beams beams;
  to_beams(world.scan(1.0, pose, pose, random, seen), TrackerSettings(), beams);
  for (Beam& beam : beams.all) beam.kind = kind;
  return beams;
}

// The most that a point between two others is behind the line through them, seen from the sensor, among lines that no
// point of the surface is in front of: all of them are tried.
double naive_depth(const Beams& beams, std::size_t first, std::size_t last, std::size_t& deepest) {
  double most = 0.0;
  const auto behind = [&](std::size_t a, std::size_t b, std::size_t i) {
    const Point u = (beams.all[b].tip() - beams.all[a].tip()).normalized(), v = beams.all[i].tip() - beams.all[a].tip();
    return u.y() * v.x() - u.x() * v.y();  // bearings grow
  };
  for (std::size_t a = first; a <= last; ++a) {
    for (std::size_t b = a + 1; b <= last; ++b) {
      bool outermost = true;
      for (std::size_t i = first; i <= last; ++i) outermost = outermost && behind(a, b, i) > -1e-12;
      for (std::size_t i = a + 1; outermost && i < b; ++i) {
        if (behind(a, b, i) <= most) continue;
        most = behind(a, b, i);
        deepest = i;
      }
    }
  }
  return most;
}

TEST(Segments, TakeApartBodiesThatTouch) {
  const std::vector<test::Post> two{{{5.0, 3.26}, 0.26}, {{5.0, 2.74}, 0.26}};
  std::vector<Segment> segments;
  find(see(two, 0.0, PlaceKind::was_free, 1), 0.01, segments);
  ASSERT_EQ(segments.size(), 2u);
  EXPECT_NEAR(static_cast<double>(segments[0].points), static_cast<double>(segments[1].points), 1.0);
  EXPECT_TRUE(segments[0].hidden_last && segments[1].hidden_first);
  EXPECT_FALSE(segments[0].hidden_first || segments[1].hidden_last);
  find(see(two, 0.0, PlaceKind::unknown, 1), 0.01, segments);  // it may be a room's corner
  EXPECT_EQ(segments.size(), 1u);
}

// A surface is cut where the obvious way finds its deepest dent, and only if that is deep enough.
TEST(Segments, AreCutAtTheDeepestDent) {
  Random random(3);
  int cuts = 0, whole = 0;
  for (std::uint64_t trial = 0; trial < 60; ++trial) {
    const double apart = random.uniform(0.1, 0.5), noise = 0.002;
    const Beams beams =
        see({{{5.0, 3.0 + 0.5 * apart}, 0.25}, {{5.0 + random.uniform(-0.1, 0.1), 3.0 - 0.5 * apart}, 0.25}}, noise,
            PlaceKind::was_free, trial);
    std::vector<Segment> segments;
    find(beams, noise, segments);
    ASSERT_FALSE(segments.empty());
    std::size_t deepest = 0;
    const double depth = naive_depth(beams, segments.front().first, segments.back().last, deepest);
    if (std::abs(depth - 0.04) < 1e-9) continue;
    if (segments.size() == 1) {
      EXPECT_LE(depth, 0.04) << trial;
      ++whole;
    } else {
      EXPECT_GT(depth, 0.04) << trial;
      EXPECT_TRUE(std::any_of(segments.begin(), segments.end(), [&](const Segment& s) { return s.last == deepest; }));
      ++cuts;
    }
  }
  EXPECT_GT(cuts, 10);
  EXPECT_GT(whole, 10);
}

}  // namespace
}  // namespace hidwa_local_planner::tracking
