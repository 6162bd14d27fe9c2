// SPDX-License-Identifier: BSD-3-Clause
// Are the searches right? The fast check against separating axes, and doors whose answer is known.
#include <cmath>

#include <gtest/gtest.h>

#include "ways/drawing.hpp"
#include "ways/finding.hpp"
#include "ways/grid_plan.hpp"
#include "ways/novelty.hpp"
#include "ways/proof.hpp"

namespace hidwa_ways {
namespace {

using hidwa_attack::Placed;
using hidwa_attack::Random;

TEST(Ground, AgreesWithSeparatingAxes) {
  Random random(1);
  World world(3.0, 3.0, 0.05);
  for (int k = 0; k < 120; ++k) {
    const int i = random.whole(0, 59), j = random.whole(0, 59);
    world.set(i, j, true);
  }
  wall_in(world);
  const Ground ground(world);
  int overlaps = 0, misses = 0;
  for (int k = 0; k < 6000; ++k) {
    const Shape shape = hidwa_attack::padded(all_bodies()[static_cast<std::size_t>(k) % kBodies].shape, -0.08);
    const Pose2 pose{random.in(0.6, 2.4), random.in(0.6, 2.4), random.in(-M_PI, M_PI)};
    const bool fast = ground.overlaps(Turned(shape, pose.theta), pose.x, pose.y);
    const double depth = hidwa_attack::deepest(world, Placed(shape, pose), 0.05);
    if (std::abs(depth) > 1e-9) {
      EXPECT_EQ(fast, depth > 0.0) << k << ": " << depth;
    }
    ++(fast ? overlaps : misses);
  }
  EXPECT_GT(overlaps, 400);
  EXPECT_GT(misses, 400);
}

TEST(Ground, BeyondTheWorldNothingIsFree) {
  const World world(2.0, 2.0, 0.05);
  const Ground ground(world);
  const Turned square(all_bodies()[1].shape, 0.0);
  EXPECT_FALSE(ground.overlaps(square, 1.0, 1.0));
  EXPECT_TRUE(ground.overlaps(square, 0.2, 1.0));
  EXPECT_TRUE(ground.overlaps(square, 1.0, 1.8));
}

TEST(Way, FollowsLinesTurnsAndArcs) {
  const Way way{{1.0, 2.0, 0.0}, {{0.5, 0.0}, {0.0, M_PI / 2.0}, {M_PI / 2.0, M_PI / 2.0}, {-1.0, 0.0}}};
  const std::vector<Pose2> poses = way.poses(0.01, 0.01);
  EXPECT_NEAR(poses.back().x, 1.5, 1e-9);  // a quarter of a circle of 1 m to the left, then back along -x
  EXPECT_NEAR(poses.back().y, 3.0, 1e-9);
  EXPECT_NEAR(poses.back().theta, M_PI, 1e-12);
  EXPECT_NEAR(way.length(), 1.5 + M_PI / 2.0, 1e-12);
  EXPECT_NEAR(way.time({0.5, 0.25, 1.0}), 1.0 + M_PI / 2.0 + M_PI + 4.0, 1e-12);
}

// A wall across the middle of 4 m, with a gap of so many cells about (2, 2).
World with_gap(int cells) {
  World world(4.0, 4.0, 0.05);
  wall_in(world);
  fill_box(world, {2.0, 2.0, 0.0}, 0.2, 4.0, true);
  fill_box(world, {2.0, 2.0 + 0.025 * (cells % 2), 0.0}, 0.3, 0.05 * cells, false);
  return world;
}

Scene across(World world, const Body& body, const Pose2& start, bool reverse = false) {
  static const Kind kind{"test", {}, true, ""};
  Scene scene{&kind, 1, body, reverse, true, false, std::move(world), start, {}};
  for (int k = 0; k <= 40; ++k) scene.plan.push_back({1.0 + 0.05 * k, 2.0, 0.0});
  return scene;
}

TEST(Search, ADoorNeedsTheMarginOnBothSides) {
  const Pose2 start{1.0, 2.0, 0.0};
  // 0.4 m wide robots. A gap of 0.45 m leaves just half a cell a side, and nothing between two poses of the search.
  EXPECT_EQ(examine(across(with_gap(10), all_bodies()[2], start)).answer, Class::sure);
  EXPECT_EQ(examine(across(with_gap(9), all_bodies()[2], start)).answer, Class::open);
  EXPECT_EQ(examine(across(with_gap(8), all_bodies()[2], start)).answer, Class::open);
  EXPECT_EQ(examine(across(with_gap(6), all_bodies()[2], start)).answer, Class::none);
}

TEST(Search, TheSlowCheckAgreesWithTheWay) {
  const Scene scene = across(with_gap(10), all_bodies()[3], {1.0, 2.2, 2.0});
  const Finding finding = examine(scene);
  ASSERT_EQ(finding.answer, Class::sure);
  EXPECT_LE(deepest_along(finding.way, scene.world, hidwa_attack::padded(scene.body.shape, scene.margin())), 0.0);
  EXPECT_GT(deepest_along(finding.way, scene.world, hidwa_attack::padded(scene.body.shape, 0.08)), 0.0);
  EXPECT_LE(finding.way.length(), kLongestWay);
  const Pose2 end = finding.way.poses(0.01, 0.1).back();
  EXPECT_LE(Target(scene.plan, kFurther, kFurther + 1.0).distance(end.x, end.y), kArrives);
}

TEST(Search, TheRemainingWayIsThatOfTheWayFound) {
  const Scene scene = across(with_gap(16), all_bodies()[0], {1.0, 2.0, 0.0});
  const Finding finding = examine(scene);
  ASSERT_EQ(finding.answer, Class::sure);
  EXPECT_NEAR(finding.way.length(), kFurther - kArrives, 0.05);
  EXPECT_NEAR(finding.remaining, finding.way.length(), 0.1);
  EXPECT_NEAR(finding.field->cost_near({1.5, 2.0, 0.0}), finding.remaining - 0.5, 0.1);
}

// A pocket too narrow to turn in, the robot's back to the opening.
TEST(Search, OnlyReverseLeadsOutOfANarrowPocket) {
  World world(4.0, 4.0, 0.05);
  wall_in(world);
  fill_box(world, {1.0, 2.3, 0.0}, 1.2, 0.1, true);
  fill_box(world, {1.0, 1.7, 0.0}, 1.2, 0.1, true);
  fill_box(world, {0.4, 2.0, 0.0}, 0.1, 0.7, true);
  const Pose2 start{1.0, 2.0, M_PI};
  EXPECT_EQ(examine(across(world, all_bodies()[3], start, false)).answer, Class::none);
  EXPECT_EQ(examine(across(world, all_bodies()[3], start, true)).answer, Class::sure);
}

// Whatever the search finds with no margin at all the proof must not exclude.
TEST(Proof, ExcludesNoWay) {
  int ways = 0, none = 0;
  for (std::uint64_t seed = 1; seed <= 24; ++seed) {
    const Scene scene = scene_of(drawn_kinds()[seed % drawn_kinds().size()], seed);
    const Ground ground(scene.world);
    const Lattice lattice(scene.local_map(), step_of(scene), scene.start.theta);
    Search::Make make;
    make.reverse = scene.reverse;
    Search search(ground, lattice, hidwa_attack::padded(scene.body.shape, 1e-3), make);
    search.begin_at(scene.start.x, scene.start.y, 0);
    const Target target = through_target(scene);
    const bool way = search.run([&](const Search::Node& n) { return target.near(n.x, n.y, through_distance(scene)); },
                                [&](const Search::Node& n) { return target.distance(n.x, n.y); }) >= 0;
    const bool no_way =
        surely_no_way(ground, lattice, scene.body.shape, scene.reverse, scene.start, target, through_distance(scene));
    EXPECT_FALSE(way && no_way) << scene.kind->name << ' ' << seed;
    ways += way ? 1 : 0;
    none += no_way ? 1 : 0;
  }
  EXPECT_GE(ways, 8);
  EXPECT_GE(none, 1);
}

TEST(GridPlan, LeadsRoundWhatTheInscribedCircleCannotPass) {
  const World world = with_gap(16);
  hidwa_attack::LocalMap map(world, 4.0, 0.25);
  const GridPlan plan(map.around({2.0, 2.0, 0.0}), {3.0, 3.0});
  ASSERT_TRUE(plan.reaches({1.0, 3.0}));
  EXPECT_NEAR(plan.length({1.0, 3.0}), 2.0 * std::sqrt(2.0), 0.6);
  for (const Pose2& pose : plan.from({1.0, 3.0})) {
    if (std::abs(pose.x - 2.0) < 0.1) {
      EXPECT_NEAR(pose.y, 2.0, 0.2);
    }
  }
  EXPECT_FALSE(
      GridPlan(hidwa_attack::LocalMap(with_gap(8), 4.0, 0.25).around({2.0, 2.0, 0.0}), {3.0, 3.0}).reaches({1.0, 3.0}));
}

TEST(Novelty, TurningToAndFroIsNothingNew) {
  Novelty novelty;
  for (int k = 0; k <= 400; ++k) novelty.observe(0.05 * k, {1.05, 1.05, 0.3 * std::sin(0.05 * k)});
  EXPECT_LT(novelty.since(), 5.0);
  novelty.observe(21.0, {1.25, 1.05, 0.0});
  EXPECT_EQ(novelty.since(), 21.0);
}

}  // namespace
}  // namespace hidwa_ways
