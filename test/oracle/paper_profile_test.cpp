// SPDX-License-Identifier: BSD-3-Clause
// The paper's profile against figures that were computed independently of this code: an empty map, the robot on a
// straight plan, only the four map-grid critics (0.8 and 0.6 a cell), L1 distances, last pose.
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "hidwa_local_planner/critics/built_in.hpp"
#include "support/paper_scene.hpp"

namespace hidwa_local_planner {
namespace {

struct Summary {
  std::size_t candidates = 0;
  double lowest = 0.0, next = 0.0, highest = 0.0;
  Twist2 pick;
};

Summary run(double v_max, const Twist2* wanted, double s_v, double s_omega) {
  Parameters p = test::paper_parameters();
  p.max_vel_x = v_max;
  p.critics = "GoalAlign, PathAlign, PathDist, GoalDist";
  p.s_v = s_v;
  p.s_omega = s_omega;
  Planner planner(critics::built_in());
  EXPECT_TRUE(planner.configure(p).empty());
  const test::PaperScene scene(v_max);
  planner.set_footprint(scene.outline);
  OperatorIntent intent;
  if (wanted != nullptr) {
    intent.state = OperatorStateId::shared;
    intent.influence = Influence::shared;
    intent.u_h = *wanted;
  }
  const Decision& decision = planner.plan(scene.situation, scene.grid, intent);
  std::vector<double> totals;
  for (const CandidateReport& record : planner.candidates()) totals.push_back(record.total);
  std::sort(totals.begin(), totals.end());
  EXPECT_EQ(decision.legal, decision.candidates);
  return {totals.size(), totals.at(0), totals.at(1), totals.back(), decision.command};
}

struct AutonomyCase {
  double v_max, lowest, highest, v, next;
};

class PaperAutonomy : public ::testing::TestWithParam<AutonomyCase> {};

TEST_P(PaperAutonomy, CostsAndChoice) {
  const AutonomyCase expected = GetParam();
  const Summary summary = run(expected.v_max, nullptr, 0.0, 0.0);
  // 20 speeds x (20 turns and an exact 0) without (0, 0): 20 * 21 - 1.
  EXPECT_EQ(summary.candidates, 419u);
  EXPECT_NEAR(summary.lowest, expected.lowest, 1e-9);
  EXPECT_NEAR(summary.highest, expected.highest, 1e-9);
  EXPECT_NEAR(summary.pick.v, expected.v, 5e-4);
  EXPECT_EQ(summary.pick.omega, 0.0);
  if (expected.next > 0.0) {
    EXPECT_NEAR(summary.next, expected.next, 1e-9);
  }
}

INSTANTIATE_TEST_SUITE_P(Speeds, PaperAutonomy,
                         ::testing::Values(AutonomyCase{0.26, 13.2, 36.0, 0.26, 14.4},
                                           AutonomyCase{0.5, 3.6, 41.6, 0.5, -1.0},
                                           AutonomyCase{1.0, 1.6, 70.2, 0.579, -1.0}));

// The sample of the grid [-1, 1] in 19 equal steps, with 0, that is nearest to omega.
double nearest_sample(double omega) {
  double best = 0.0;
  for (int i = 0; i < 20; ++i) {
    const double sample = -1.0 + 2.0 * i / 19.0;
    if (std::abs(sample - omega) < std::abs(best - omega)) best = sample;
  }
  return best;
}

TEST(PaperShared, WeightsOfThePaperFollowTheOperator) {
  for (const double v_max : {0.26, 0.5, 1.0}) {
    for (const double scale : {1.0, 0.5}) {
      for (const double omega_h : {0.05, 0.1, 0.25, 0.5, 1.0}) {
        for (const double side : {1.0, -1.0}) {
          const Twist2 wanted{v_max, side * omega_h};
          const Summary summary = run(v_max, &wanted, scale * 400.0, scale * 800.0);
          EXPECT_EQ(summary.pick.v, v_max) << wanted.omega;
          EXPECT_NEAR(summary.pick.omega, side * nearest_sample(omega_h), 1e-12) << v_max << " " << wanted.omega;
        }
      }
    }
  }
}

TEST(PaperShared, WeakWeightsCollapseIntoTurningOnTheSpot) {
  for (const double side : {1.0, -1.0}) {
    const Twist2 slow{0.26, side};
    const Summary summary = run(0.26, &slow, 20.0, 40.0);
    EXPECT_NEAR(summary.pick.v, 0.068, 5e-4);  // 0.26 * 5 / 19
    EXPECT_EQ(summary.pick.omega, side);
    EXPECT_NEAR(summary.lowest, 32.23, 5e-3);
    EXPECT_NEAR(summary.next, 32.33, 5e-3);
    for (const double v_max : {0.5, 1.0}) {
      const Twist2 fast{v_max, side};
      const Summary collapsed = run(v_max, &fast, 20.0, 40.0);
      EXPECT_EQ(collapsed.pick.v, 0.0);
      EXPECT_EQ(collapsed.pick.omega, side);
    }
  }
}

}  // namespace
}  // namespace hidwa_local_planner
