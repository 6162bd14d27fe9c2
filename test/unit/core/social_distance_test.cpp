// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "support/critic_bench.hpp"
#include "support/naive_social_distance.hpp"
#include "support/planner_bench.hpp"
#include "support/random.hpp"
#include "support/round_outline.hpp"

namespace hidwa_local_planner {
namespace {

using test::CriticBench;
using test::mover_at;
using test::naive_social_distance;
using test::PlannerBench;
using test::Random;
using test::Scene;

TEST(SocialDistances, AreWeighedBySecondsAndFade) {
  Scene scene = Scene::empty();
  scene.parameters.social_distance = 0.5;
  scene.parameters.SocialDistance_fading_time = 1.5;
  scene.situation.moving_obstacles = {mover_at(0.8, 0.0)};
  CriticBench bench("SocialDistance", scene);
  EXPECT_DOUBLE_EQ(bench.weight(), scene.parameters.SocialDistance_scale);
  bench.prepare();
  // A robot that stands for 1 s, looks 0.25 s apart: the front is at 0.2 and 0.8 - 0.3 - 0.2 = 0.3 m off, of 0.5 m.
  const std::vector<Pose2> stands(9, Pose2{0.0, 0.0, 0.0});
  const double share = 1.0 - 0.3 / 0.5;
  const double expected =
      0.25 * share *
      (std::exp(-0.125 / 1.5) + std::exp(-0.375 / 1.5) + std::exp(-0.625 / 1.5) + std::exp(-0.875 / 1.5));
  EXPECT_NEAR(bench.score({0.0, 0.0}, stands, 0.125).raw, expected, 1e-12);
  // 0.75 m from the front, and going away: nothing. Standing in the person: no more than one.
  bench.scene().situation.moving_obstacles = {mover_at(1.25, 0.0, 0.5, 0.0)};
  bench.prepare();
  EXPECT_EQ(bench.score({0.0, 0.0}, stands, 0.125).raw, 0.0);
  bench.scene().situation.moving_obstacles = {mover_at(0.2, 0.0)};
  bench.prepare();
  EXPECT_NEAR(bench.score({0.0, 0.0}, stands, 0.125).raw, expected / share, 1e-12);
}

TEST(SocialDistances, TakeTheNearestOfAllAndWhereHeIsNow) {
  Scene scene = Scene::empty();
  MovingObstacleEstimate old = mover_at(0.6, 0.0, 1.0, 0.0);
  old.age = 0.2;  // now at 0.8
  scene.situation.moving_obstacles = {old, mover_at(0.0, -0.75)};
  CriticBench bench("SocialDistance", scene);
  bench.prepare();
  const std::vector<Pose2> stands(3, Pose2{0.0, 0.0, 0.0});
  // At 0.25 s the first one is at 1.05, 0.55 m off, and the second one 0.75 - 0.3 - 0.2 = 0.25 m.
  EXPECT_NEAR(bench.score({0.0, 0.0}, stands, 0.125).raw, 0.25 * (1.0 - 0.25 / 0.5) * std::exp(-0.125 / 1.5), 1e-12);
}

TEST(SocialDistances, CountNothingWithoutADistanceToKeep) {
  Scene scene = Scene::empty();
  scene.parameters.social_distance = 0.0;
  EXPECT_EQ(CriticBench("SocialDistance", scene).weight(), 0.0);
}

// Every candidate of whole cycles. Speeds 0.1 m/s apart are measured and those between interpolated: where the nearest
// person changes with the speed, a few are off by more than a tenth of a second.
TEST(SocialDistances, AreWhatASlowTwinSaysOfEveryCandidate) {
  Random random(17);
  for (const bool circle : {true, false}) {
    std::size_t some = 0, far = 0;
    double off = 0.0, sum = 0.0;
    for (int k = 0; k < 25; ++k) {
      Scene scene = Scene::empty(121);
      if (circle) scene.outline = test::round_outline(0.25);
      scene.situation.velocity = scene.situation.last_command = {random.uniform(0.0, 0.4), random.uniform(-0.5, 0.5)};
      for (int j = 0; j < 3; ++j) {
        const double angle = random.uniform(-M_PI, M_PI), away = random.uniform(0.9, 2.0);
        const double vx = random.uniform(-1.0, 1.0), vy = random.uniform(-1.0, 1.0);
        scene.situation.moving_obstacles.push_back(mover_at(away * std::cos(angle), away * std::sin(angle), vx, vy));
        scene.situation.moving_obstacles.back().id = static_cast<std::uint32_t>(j);
      }
      PlannerBench bench(scene);
      Sampling full;
      full.report = Report::full;
      bench.planner().plan(scene.situation, scene.grid(), scene.intent, full);
      for (const CandidateReport& candidate : bench.planner().candidates()) {
        const auto term = std::find_if(candidate.terms.begin(), candidate.terms.end(),
                                       [](const CriticTerm& t) { return t.name == "SocialDistance"; });
        ASSERT_NE(term, candidate.terms.end());
        const double twin = naive_social_distance(candidate.poses, candidate.step, bench.planner().footprint(),
                                                  scene.situation.moving_obstacles, bench.planner().parameters());
        EXPECT_NEAR(term->raw, twin, 0.2) << k;
        far += std::abs(term->raw - twin) > 0.1;
        off += std::abs(term->raw - twin);
        sum += twin;
        some += twin > 0.0;
      }
    }
    EXPECT_GT(some, 1000U);
    EXPECT_LT(off, 0.05 * sum);
    EXPECT_LT(far, some / 100);
  }
}

}  // namespace
}  // namespace hidwa_local_planner
