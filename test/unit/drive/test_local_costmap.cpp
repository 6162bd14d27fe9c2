// SPDX-License-Identifier: BSD-3-Clause
#include "drive/local_costmap.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "drive/outline.hpp"
#include "sim/laser.hpp"
#include "unit/drive/naive_costmap.hpp"
#include "unit/sim/random_scene.hpp"

namespace hidwa_local_planner {
namespace drive {
namespace {

using sim::uniform;

// Walks through random maps with a noisy laser; after every update all cells against the slow and obvious
// costmap.
TEST(LocalCostmap, AgreesWithTheNaiveTwinOnRandomScans) {
  sim::Random random(17);
  for (int scene = 0; scene < 6; ++scene) {
    const sim::OccupancyMap map = sim::random_map(random, 120, 90, scene % 2 == 0 ? 0.004 : 0.02);
    sim::LaserSpec laser;
    laser.beams = 200;
    laser.field_of_view = scene % 3 == 0 ? 4.0 : 2.0 * M_PI;
    laser.noise = 0.02;
    CostmapSettings settings;
    settings.width = 2.0;
    settings.obstacle_range = 0.9;
    settings.raytrace_range = scene < 3 ? 1.1 : 3.5;
    settings.inflation = {0.4, 3.0};
    const Polygon outline = scene == 5 ? Polygon{{0.4, 0.1}, {-0.1, 0.2}, {-0.2, -0.15}} : circle_outline(0.15, 0.01);
    LocalCostmap costmap(settings, outline);
    test::NaiveCostmap naive(settings, outline);
    sim::Pose pose{1.0, 2.0, 0.0};
    std::vector<float> ranges;
    Beams beams;
    for (int step = 0; step < 12; ++step) {
      pose = {pose.x + uniform(random, -0.1, 0.3), pose.y + uniform(random, -0.2, 0.2), uniform(random, -4.0, 4.0)};
      const sim::Pose sensor = sim::compose(pose, {0.1, 0.0, 0.0});
      sim::scan(map, laser, sensor, random, ranges);
      project(ranges, laser, sensor, beams);
      costmap.update(pose, beams);
      naive.update(pose, beams);
      const GridView view = costmap.view();
      ASSERT_EQ(view.size_x, naive.cells());
      ASSERT_EQ(std::lround(view.origin_x / view.resolution), naive.column());
      ASSERT_EQ(std::lround(view.origin_y / view.resolution), naive.row());
      for (int j = 0; j < view.size_y; ++j) {
        for (int i = 0; i < view.size_x; ++i) {
          ASSERT_EQ(view.at({i, j}), naive.cost(naive.column() + i, naive.row() + j))
              << "scene " << scene << " step " << step << " cell " << i << " " << j;
        }
      }
    }
  }
}

}  // namespace
}  // namespace drive
}  // namespace hidwa_local_planner
