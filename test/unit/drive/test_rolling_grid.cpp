// SPDX-License-Identifier: BSD-3-Clause
#include "drive/rolling_grid.hpp"

#include <map>
#include <utility>

#include <gtest/gtest.h>

#include "unit/sim/random_scene.hpp"

namespace hidwa_local_planner {
namespace drive {
namespace {

using sim::uniform;

TEST(RollingGrid, HoldsAsManyCellsAsFitItsWidth) {
  EXPECT_EQ(RollingGrid(4.0, 0.05).cells(), 80);
  EXPECT_EQ(RollingGrid(0.3, 0.1).cells(), 3);
  EXPECT_EQ(RollingGrid(0.04, 0.05).cells(), 1);
}

TEST(RollingGrid, TheFollowedPointLiesInItsMiddle) {
  sim::Random random(3);
  RollingGrid grid(2.0, 0.05);
  for (int i = 0; i < 200; ++i) {
    const double x = uniform(random, -30.0, 30.0), y = uniform(random, -30.0, 30.0);
    grid.follow(x, y);
    EXPECT_NEAR(grid.origin_x() + 1.0, x, 0.05 + 1e-6);
    EXPECT_NEAR(grid.origin_y() + 1.0, y, 0.05 + 1e-6);
  }
}

TEST(RollingGrid, LessThanACellDoesNotMoveIt) {
  RollingGrid grid(1.0, 0.1);
  grid.follow(0.5, 0.5);
  EXPECT_EQ(grid.origin_x(), 0.0);
  grid.follow(0.59, 0.41);
  EXPECT_EQ(grid.origin_x(), 0.0);
  EXPECT_EQ(grid.origin_y(), 0.0);
  grid.follow(0.601, 0.399);
  EXPECT_NEAR(grid.origin_x(), 0.1, 1e-12);
  EXPECT_NEAR(grid.origin_y(), -0.1, 1e-12);
}

// Against a map from places to costs: what stays in the window is kept, what comes in is free.
TEST(RollingGrid, KeepsWhatStaysAndForgetsWhatLeaves) {
  sim::Random random(5);
  RollingGrid grid(1.0, 0.05);
  std::map<std::pair<long, long>, std::uint8_t> known;
  double x = 0.0, y = 0.0;
  const auto corner = [](double origin) { return std::lround(origin / 0.05); };
  for (int step = 0; step < 300; ++step) {
    const double stride = step % 40 == 39 ? 3.0 : 0.2;
    x += uniform(random, -stride, stride);
    y += uniform(random, -stride, stride);
    grid.follow(x, y);
    const long i0 = corner(grid.origin_x()), j0 = corner(grid.origin_y());
    const auto leaves = [&](const std::pair<long, long>& c) {
      return c.first < i0 || c.second < j0 || c.first >= i0 + grid.cells() || c.second >= j0 + grid.cells();
    };
    for (auto place = known.begin(); place != known.end();) {
      place = leaves(place->first) ? known.erase(place) : std::next(place);
    }
    const GridView view = grid.view();
    for (int j = 0; j < view.size_y; ++j) {
      for (int i = 0; i < view.size_x; ++i) {
        const auto place = known.find({i0 + i, j0 + j});
        ASSERT_EQ(view.at({i, j}), place == known.end() ? 0 : place->second) << "step " << step;
      }
    }
    for (int k = 0; k < 20; ++k) {
      const int i = static_cast<int>(uniform(random, 0.0, 20.0)), j = static_cast<int>(uniform(random, 0.0, 20.0));
      const auto value = static_cast<std::uint8_t>(uniform(random, 1.0, 255.0));
      grid.row(j)[i] = value;
      known[{i0 + i, j0 + j}] = value;
    }
  }
}

}  // namespace
}  // namespace drive
}  // namespace hidwa_local_planner
