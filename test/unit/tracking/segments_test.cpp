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
  Beams beams;
  to_beams(world.scan(1.0, pose, pose, random, seen), TrackerSettings(), beams);
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

// Where a whole turn begins makes no difference, also in the middle of a body.
TEST(Segments, DoNotDependOnWhereATurnBegins) {
  std::vector<Segment> segments;
  find_segments(turn_from(0, 1), 0.0, 1.3, segments);
  const auto expected = sorted(segments);
  ASSERT_EQ(expected.size(), 4u);
  for (int first = 1; first < 360; ++first) {
    find_segments(turn_from(first, 1), 0.0, 1.3, segments);
    EXPECT_EQ(sorted(segments), expected) << first;
  }
}

// The obvious way, for scans without gaps: two neighbouring points are of one surface, or not.
TEST(Segments, AreRunsOfNeighboursThatAreNear) {
  const Beams beams = turn_from(90, 1);
  std::vector<Segment> segments;
  find_segments(beams, 0.0, 1.3, segments);
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

}  // namespace
}  // namespace hidwa_local_planner::tracking
