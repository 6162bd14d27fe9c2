// SPDX-License-Identifier: BSD-3-Clause
// The choice against the naive twin's on 10,000 scenes in the long form. Where they differ, rounding must be to blame:
// the two best totals lie within 1e-6, or a pose of either choice within 1e-5 m of a cell's border.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include <gtest/gtest.h>

#include "support/effort.hpp"
#include "support/naive_planner.hpp"
#include "support/random_scene.hpp"
#include "support/renewed_planner.hpp"

namespace hidwa_local_planner {
namespace {

using test::NaiveCandidate;
using test::NaivePlanner;
using test::Scene;

const int kScenes = test::effort(1000, 5000);  // of each profile
constexpr double kTied = 1e-6;
constexpr double kAtBorder = 1e-5;  // [m]

struct Tally {
  int compared = 0, chosen = 0, rejected_all = 0, gave_up = 0, steered = 0, near_obstacles = 0;
  int nearly_tied = 0;          // whether or not the choices differ
  int tied = 0, at_border = 0;  // where they differ: excused
};

// How near a coordinate comes to a border between cells [m].
double to_border(double value, double origin, double resolution) {
  const double cells = (value - origin) / resolution;
  return std::abs(cells - std::round(cells)) * resolution;
}

bool at_border(const GridView& grid, const std::vector<Pose2>& poses) {
  return std::any_of(poses.begin(), poses.end(), [&](const Pose2& q) {
    return std::min(to_border(q.x, grid.origin_x, grid.resolution), to_border(q.y, grid.origin_y, grid.resolution)) <
           kAtBorder;
  });
}

bool same(const Twist2& a, const Twist2& b) { return std::abs(a.v - b.v) < 1e-9 && std::abs(a.omega - b.omega) < 1e-9; }

// Overlaps of the size of a rounding are poses at a border too.
bool excused_by_border(const Scene& scene, const NaivePlanner& naive, const Decision& decision) {
  return naive.doubtful() || at_border(scene.grid(), decision.trajectory) ||
         (naive.best() != nullptr && at_border(scene.grid(), naive.best()->poses));
}

void compare(const Scene& scene, const NaivePlanner& naive, Tally& tally) {
  static test::RenewedPlanner renewed;
  Planner& planner = renewed(scene);
  const Decision& decision = planner.plan(scene.situation, scene.grid(), scene.intent);
  ++tally.compared;
  tally.steered += scene.intent.influence != Influence::none;
  tally.near_obstacles += decision.legal < decision.candidates;
  const bool chosen = decision.outcome == Outcome::drive || decision.outcome == Outcome::hold;
  if (naive.gives_up()) {
    ++tally.gave_up;
    EXPECT_FALSE(chosen);
    return;
  }
  const NaiveCandidate* twin = naive.best();
  if (!chosen && twin == nullptr) {
    ++tally.rejected_all;
    return;
  }
  tally.chosen += chosen;
  tally.nearly_tied += twin != nullptr && naive.runner_up() < twin->total + kTied;
  if (chosen && twin != nullptr && same(decision.sample, twin->u)) {
    EXPECT_TRUE(same(decision.command, naive.command()));
  } else if (chosen && twin != nullptr && std::abs(decision.total - twin->total) < kTied) {
    ++tally.tied;
  } else if (excused_by_border(scene, naive, decision)) {
    ++tally.at_border;
  } else {
    ADD_FAILURE() << "chose (" << decision.sample.v << ", " << decision.sample.omega << "), J " << decision.total
                  << (chosen ? "" : ": nothing") << "; the twin "
                  << (twin == nullptr ? "nothing"
                                      : "(" + std::to_string(twin->u.v) + ", " + std::to_string(twin->u.omega) +
                                            "), J " + std::to_string(twin->total));
  }
}

// Robots that stand in collision are not the twin's: the next scene takes their place.
template <typename Adjust>
Tally compare_all(std::uint64_t first_seed, const Adjust& adjust) {
  Tally tally;
  for (std::uint64_t seed = first_seed; tally.compared < kScenes && !testing::Test::HasFailure(); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Scene scene = test::random_scene(seed);
    adjust(scene.parameters);
    const NaivePlanner naive(scene);
    if (!naive.stands_in_collision()) compare(scene, naive, tally);
  }
  std::printf("%d compared, %d steered, %d with rejections: %d chosen, %d rejected all, %d gave up, %d nearly tied\n",
              tally.compared, tally.steered, tally.near_obstacles, tally.chosen, tally.rejected_all, tally.gave_up,
              tally.nearly_tied);
  std::printf("differing choices: %d of equal totals, %d at a border between cells\n", tally.tied, tally.at_border);
  return tally;
}

void expect_variety(const Tally& tally) {
  EXPECT_EQ(tally.compared, kScenes);
  EXPECT_GT(tally.chosen, kScenes / 2);
  EXPECT_GT(tally.near_obstacles, kScenes / 4);
  EXPECT_GT(tally.steered, kScenes / 2);
  EXPECT_GT(tally.rejected_all, kScenes / 100);
  EXPECT_GT(tally.gave_up, kScenes / 500);
  EXPECT_LE(tally.tied, kScenes / 100);
  EXPECT_LE(tally.at_border, kScenes / 1000);
}

// For time's sake.
void thin_samples(Parameters& p) {
  p.vx_samples = std::min(p.vx_samples, 5);
  p.vth_samples = std::min(p.vth_samples, 7);
}

TEST(ChoiceTwin, DefaultProfile) {
  expect_variety(compare_all(5000000, [](Parameters& p) {
    test::take_default_profile(p);
    thin_samples(p);
  }));
}

TEST(ChoiceTwin, RandomParameters) { expect_variety(compare_all(6000000, thin_samples)); }

}  // namespace
}  // namespace hidwa_local_planner
