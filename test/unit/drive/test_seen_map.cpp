// SPDX-License-Identifier: BSD-3-Clause
#include "drive/seen_map.hpp"

#include <gtest/gtest.h>

namespace hidwa_local_planner {
namespace drive {
namespace {

TEST(SeenMap, RemembersWhatWasSeenAndClearsWhatIsGone) {
  // 4 m x 2 m with its corner off the origin.
  SeenMap seen(sim::make_map(40, 20, 0.1, -1.0, -1.0), 2.5);
  const auto occupied = [&seen](double x, double y) {
    const sim::OccupancyMap map = seen.map();
    return map.occupied(map.column(x), map.row(y));
  };
  seen.add({{0.05, 0.05}, {{1.55, 0.05}, {2.95, 0.05}, {0.05, 0.75}}});
  EXPECT_TRUE(occupied(1.55, 0.05));
  EXPECT_TRUE(occupied(0.05, 0.75));
  EXPECT_FALSE(occupied(2.95, 0.05));  // 2.9 m away
  EXPECT_FALSE(occupied(1.45, 0.05));
  const sim::OccupancyMap map = seen.map();
  EXPECT_EQ(map.width, 40);
  EXPECT_EQ(map.height, 20);
  EXPECT_EQ(map.origin_x, -1.0);
  // From elsewhere, through what was an obstacle; what no beam passes stays.
  seen.add({{0.85, 0.05}, {{1.95, 0.05}}});
  EXPECT_FALSE(occupied(1.55, 0.05));
  EXPECT_TRUE(occupied(1.95, 0.05));
  EXPECT_TRUE(occupied(0.05, 0.75));
}

}  // namespace
}  // namespace drive
}  // namespace hidwa_local_planner
