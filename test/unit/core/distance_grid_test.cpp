// SPDX-License-Identifier: BSD-3-Clause
// What distances are measured from; test/oracle/distance_twin_test.cpp compares the distances themselves.
#include "core/distance/distance_grid.hpp"

#include <gtest/gtest.h>

#include "core/distance/plan_grids.hpp"
#include "support/scene.hpp"

namespace hidwa_local_planner {
namespace {

using test::Scene;

// Cells of 0.05 m with a corner at the origin.
Scene corner_scene() {
  Scene scene = Scene::empty(40);
  scene.origin_x = scene.origin_y = 0.0;
  return scene;
}

// Through the middles of its cells from (2, 10) to (20, 10).
std::vector<Pose2> plan_in_a_row() {
  std::vector<Pose2> plan;
  for (int i = 2; i <= 20; ++i) plan.push_back({0.05 * i + 0.025, 0.525, 0.0});
  return plan;
}

TEST(PlanGridsSources, GapsAreFilledAndNeighboursAreNot) {
  const Scene scene = corner_scene();
  PlanGrids grids;
  const std::vector<Pose2> plan{{0.125, 0.525, 0.0}, {0.925, 0.525, 0.0}};  // cells (2, 10) and (18, 10)
  grids.prepare(scene.grid(), plan, Method::paper, true);
  for (int i = 2; i <= 18; ++i) EXPECT_EQ(grids.to_path().units({i, 10}), 0) << i;
  EXPECT_EQ(grids.to_path().units({19, 10}), 1);
  EXPECT_EQ(grids.to_goal().units({2, 10}), 16);
}

TEST(PlanGridsSources, OnlyTheFirstStretchOnTheMap) {
  const Scene scene = corner_scene();
  PlanGrids grids;
  // Starts off the map, crosses x = 0 .. 0.5 at y = 1, leaves at the top and comes back far right.
  std::vector<Pose2> plan;
  for (int k = 0; k <= 15; ++k) plan.push_back({-0.225 + 0.05 * k, 1.025, 0.0});  // cells ... to (10, 20)
  plan.push_back({0.525, 2.525, 0.0});                                            // above the map
  plan.push_back({1.525, 1.025, 0.0});
  grids.prepare(scene.grid(), plan, Method::paper, true);
  ASSERT_TRUE(grids.on_map());
  EXPECT_EQ(grids.to_path().units({10, 30}), 0);  // on the way up
  EXPECT_EQ(grids.to_goal().units({10, 39}), 0);  // where it leaves
  EXPECT_GT(grids.to_path().units({30, 20}), 0);  // the second visit does not count
}

TEST(PlanGridsSources, NowhereOnTheMap) {
  const Scene scene = corner_scene();
  PlanGrids grids;
  const std::vector<Pose2> plan{{-1.0, 0.0, 0.0}, {-1.0, 0.05, 0.0}};
  grids.prepare(scene.grid(), plan, Method::hidwa, true);
  EXPECT_FALSE(grids.on_map());
}

TEST(PlanGridsSources, Nav2sGridStopsAtUnknownCells) {
  Scene scene = corner_scene();
  scene.at({10, 10}) = cost::kUnknown;
  const std::vector<Pose2> plan = plan_in_a_row();
  PlanGrids grids;
  grids.prepare(scene.grid(), plan, Method::paper, true);
  EXPECT_EQ(grids.to_goal().units({9, 10}), 0);
  grids.prepare(scene.grid(), plan, Method::paper, false);
  EXPECT_EQ(grids.to_goal().units({20, 10}), 0);
  grids.prepare(scene.grid(), plan, Method::hidwa, true);
  EXPECT_EQ(grids.to_goal().units({20, 10}), 0);
}

TEST(PlanGridsSources, TheGoalAheadIsMovedTowardsTheFinalGoal) {
  const Scene scene = corner_scene();
  PlanGrids grids;
  const std::vector<Pose2> plan = plan_in_a_row();
  grids.prepare(scene.grid(), plan, Method::paper, true);
  // From (0.125, 0.525) straight up to the goal: the last pose (1.025, 0.525) moves 0.2 m up, 4 cells.
  EXPECT_EQ(grids.to_goal_ahead(0.2, {0.125, 0.525, 0.0}, {0.125, 9.0, 0.0}).units({20, 14}), 0);
}

TEST(PlanGridsLookUp, MetresOrNegative) {
  Scene scene = corner_scene();
  for (int j = 0; j < 40; ++j) scene.at({30, j}) = cost::kLethal;
  DistanceGrids grids;
  grids.prepare(scene.grid(), MapGridDistance::geodesic);
  grids.set_sources(0, {Cell{2, 10}});
  const DistanceGrid distances(grids, 0);
  // Cell (12, 10): 10 straight steps of 0.05 m.
  EXPECT_NEAR(PlanGrids::at(distances, scene.grid(), 0.61, 0.54), 0.5, 1e-12);
  EXPECT_LT(PlanGrids::at(distances, scene.grid(), -0.01, 0.54), 0.0);
  EXPECT_LT(PlanGrids::at(distances, scene.grid(), 1.9, 0.54), 0.0);  // behind the wall
}

}  // namespace
}  // namespace hidwa_local_planner
