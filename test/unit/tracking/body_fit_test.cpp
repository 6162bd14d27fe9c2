// SPDX-License-Identifier: BSD-3-Clause
#include "tracking/body_fit.hpp"

#include <gtest/gtest.h>
#include <Eigen/LU>

#include "support/scan_world.hpp"

namespace hidwa_local_planner::tracking {
namespace {

using test::Random;
using test::ScanWorld;

struct Seen {
  Beams beams;
  std::vector<Segment> segments;
};

Seen look_at(const ScanWorld& world, const Pose2& pose, std::uint64_t seed) {
  Random random(seed);
  std::vector<int> seen;
  Seen out;
  TrackerSettings settings;
  settings.reach = 20.0;
  to_beams(world.scan(1.0, pose, pose, random, seen), settings, out.beams);
  std::vector<std::size_t> hull;
  find_segments(out.beams, world.laser.noise, 1.3, out.segments, hull);
  return out;
}

// The one behind others: 2 m ahead or more.
const Segment* far_segment(const Seen& seen) {
  for (const Segment& segment : seen.segments) {
    if (segment.chord_begin.x() > 2.0) return &segment;
  }
  return nullptr;
}

// The square of the centre's error over its variance: chi-squared with two degrees of freedom.
double mismatch(const BodyFit& fit, const Point& centre) {
  const Point error = fit.centre - centre;
  return error.dot(fit.covariance.inverse() * error);
}

// Widths are known to half a beam on each side: at 720 beams over 270 degrees 0.0033 rad, at 3 m 0.01 m.
TEST(BodyFit, FindsCirclesOfAnySize) {
  for (double radius : {0.07, 0.25, 0.5}) {
    for (double distance : {1.0, 2.0, 3.0}) {
      for (double bearing : {-1.5, 0.0, 0.4, 1.7}) {
        ScanWorld world;
        world.laser.noise = 0.0;
        const Point centre(distance * std::cos(bearing), distance * std::sin(bearing));
        world.posts.push_back({centre, radius});
        const Seen seen = look_at(world, Pose2(), 1);
        ASSERT_EQ(seen.segments.size(), 1u) << radius << " " << distance;
        const BodyFit fit = fit_body(seen.beams, seen.segments[0], 0.01);
        EXPECT_TRUE(fit.radius_seen);
        EXPECT_NEAR(fit.radius, radius, 0.1 * radius + 0.0035 * distance);
        EXPECT_LT((fit.centre - centre).norm(), 0.1 * radius + 0.0035 * distance);
      }
    }
  }
}

// The deviation that the fit claims is that of its errors, or larger: bodies are not as round as these.
TEST(BodyFit, ClaimsNoMoreThanItKnows) {
  for (double noise : {0.01, 0.03}) {
    double ratio = 0.0;
    int count = 0;
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
      Random random(seed + 500);
      ScanWorld world;
      world.laser.noise = noise;
      const double distance = random.uniform(1.0, 5.0), bearing = random.uniform(-2.0, 2.0);
      const Point centre(distance * std::cos(bearing), distance * std::sin(bearing));
      world.posts.push_back({centre, 0.25});
      const Seen seen = look_at(world, Pose2(), seed);
      if (seen.segments.size() != 1) continue;  // noise may split off an edge
      const BodyFit fit = fit_body(seen.beams, seen.segments[0], {0.25, 0.02}, noise);
      ratio += mismatch(fit, centre);
      ++count;
    }
    ASSERT_GT(count, 120);
    EXPECT_LT(ratio / count, 3.0) << noise;   // 2: exact
    EXPECT_GT(ratio / count, 0.05) << noise;  // not out of all proportion
  }
}

// What is known to be round, and how large, is placed more closely, and says so: the edges alone are known to 0.3 beams
// of 0.0065 rad, which is 0.006 m at 3 m, and 70 ranges to 0.01 m / sqrt(70) = 0.0012 m.
TEST(BodyFit, PlacesWhatIsKnownToBeRoundMoreClosely) {
  const KnownShape usual{0.5, 0.03}, round{0.5, 0.003, 0.001};
  double squares[2] = {}, ratios[2] = {}, widths = 0.0;
  int count = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    Random random(seed + 900);
    ScanWorld world;
    world.laser.noise = 0.01;
    const double bearing = random.uniform(-1.5, 1.5);
    const Point centre(3.0 * std::cos(bearing), 3.0 * std::sin(bearing));
    world.posts.push_back({centre, 0.5});
    const Seen seen = look_at(world, Pose2(), seed);
    if (seen.segments.size() != 1) continue;
    for (int i = 0; i < 2; ++i) {
      const BodyFit fit = fit_body(seen.beams, seen.segments[0], i == 0 ? usual : round, 0.01);
      squares[i] += (fit.centre - centre).squaredNorm();
      ratios[i] += mismatch(fit, centre);
      widths += 0.5 * std::pow(fit.wider / fit.wider_noise, 2);
    }
    ++count;
  }
  ASSERT_GT(count, 150);
  EXPECT_LT(squares[1], 0.7 * squares[0]);
  EXPECT_LT(ratios[1] / count, 2.5);  // 2: exact
  EXPECT_GT(ratios[1] / count, 0.5);
  EXPECT_GT(ratios[1], 2.0 * ratios[0]);  // the usual claim is wider than it need be
  EXPECT_NEAR(widths / count, 1.0, 0.3);  // the edges err by what is said
}

// A column hides one half: with the radius known from before, the centre is found from the other edge.
TEST(BodyFit, KnowsAHiddenBodyByItsRadius) {
  ScanWorld world;
  world.laser.noise = 0.0;
  world.posts.push_back({{3.0, 0.0}, 0.4});
  world.posts.push_back({{1.5, 0.15}, 0.15});  // from bearing 0 on to the left
  const Seen seen = look_at(world, Pose2(), 1);
  const Segment* body = far_segment(seen);
  ASSERT_NE(body, nullptr);
  EXPECT_TRUE(body->hidden_last);
  EXPECT_FALSE(body->hidden_first);
  const BodyFit alone = fit_body(seen.beams, *body, 0.01);
  const BodyFit known = fit_body(seen.beams, *body, {0.4, 0.02}, 0.01);
  EXPECT_GT((alone.centre - Point(3.0, 0.0)).norm(), 0.15);
  EXPECT_LT((known.centre - Point(3.0, 0.0)).norm(), 0.05);
}

// Both edges are hidden, and what is in view is not its middle: the curve of the arc tells where the centre is.
TEST(BodyFit, KnowsABodyByItsArc) {
  double squares = 0.0, ratio = 0.0;
  int count = 0;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    ScanWorld world;
    world.laser.noise = 0.01;
    const Point centre(3.0, 0.0);
    world.posts.push_back({centre, 0.5});
    world.posts.push_back({{1.5, -0.3}, 0.2});    // bearings below -0.06
    world.posts.push_back({{1.5, 0.335}, 0.15});  // and above 0.12
    const Seen seen = look_at(world, Pose2(), seed);
    const Segment* body = far_segment(seen);
    if (body == nullptr || !body->hidden_first || !body->hidden_last) continue;
    const BodyFit fit = fit_body(seen.beams, *body, {0.5, 0.02}, 0.01);
    EXPECT_FALSE(fit.radius_seen);
    squares += (fit.centre - centre).squaredNorm();
    ratio += mismatch(fit, centre);
    ++count;
  }
  ASSERT_GT(count, 80);
  EXPECT_LT(std::sqrt(squares / count), 0.06);  // the arc's middle is 0.1 m off
  EXPECT_LT(ratio / count, 3.0);
}

// An edge is in view, and the radius is not known: the arc tells it.
TEST(BodyFit, LearnsARadiusFromAnArc) {
  ScanWorld world;
  world.laser.noise = 0.005;
  world.posts.push_back({{3.0, 0.0}, 0.5});
  world.posts.push_back({{1.5, 0.25}, 0.2});
  const Seen seen = look_at(world, Pose2(), 1);
  const Segment* body = far_segment(seen);
  ASSERT_NE(body, nullptr);
  const BodyFit fit = fit_body(seen.beams, *body, {0.25, 0.15}, 0.005);
  EXPECT_NEAR(fit.radius, 0.5, 0.1);
  EXPECT_LT(std::abs(fit.radius - 0.5), 3.0 * fit.radius_deviation);
}

}  // namespace
}  // namespace hidwa_local_planner::tracking
