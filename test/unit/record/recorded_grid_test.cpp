// SPDX-License-Identifier: BSD-3-Clause
#include "record/recorded_grid.hpp"

#include <gtest/gtest.h>

#include "support/random.hpp"
#include "support/random_scene.hpp"

namespace hidwa_local_planner::record {
namespace {

using test::Random;

StoredGrid some_grid(Random& random) {
  StoredGrid grid;
  grid.size_x = random.integer(1, 50);
  grid.size_y = random.integer(1, 50);
  grid.resolution = random.pick({0.05, 0.1});
  grid.origin_x = random.integer(-60, 60) * 0.3;
  grid.origin_y = random.integer(-60, 60) * 0.3;
  grid.costs.assign(static_cast<std::size_t>(grid.size_x * grid.size_y), 0);
  for (std::uint8_t& cost : grid.costs) {
    if (random.chance(0.1)) cost = static_cast<std::uint8_t>(random.integer(0, 255));
  }
  return grid;
}

TEST(RecordedGrid, ComesBackToTheBit) {
  Random random(5);
  StoredGrid read;
  for (int k = 0; k < 500; ++k) {
    const StoredGrid grid = some_grid(random);
    ASSERT_TRUE(unpack(packed(grid.view()), read));
    ASSERT_EQ(read.costs, grid.costs) << k;
    ASSERT_EQ(read.size_x, grid.size_x);
    ASSERT_EQ(read.size_y, grid.size_y);
    ASSERT_EQ(read.resolution, grid.resolution);
    ASSERT_EQ(read.origin_x, grid.origin_x);
    ASSERT_EQ(read.origin_y, grid.origin_y);
  }
}

TEST(RecordedGrid, ADamagedOneIsRefused) {
  Random random(8);
  const RecordedGrid whole = packed(some_grid(random).view());
  RecordedGrid cut = whole, vast = whole, negative = whole, larger = whole;
  cut.deflated.resize(cut.deflated.size() / 2);
  vast.size_x = vast.size_y = 1 << 30;
  negative.size_x = -1;
  ++larger.size_y;
  StoredGrid read;
  for (const RecordedGrid* bad : {&cut, &vast, &negative, &larger}) {
    EXPECT_FALSE(unpack(*bad, read));
    EXPECT_TRUE(read.costs.empty());
  }
  EXPECT_TRUE(unpack(whole, read));
}

TEST(RecordedGrid, AnEmptyMapIsOne) {
  StoredGrid read;
  ASSERT_TRUE(unpack(packed(GridView()), read));
  EXPECT_FALSE(read.view().valid());
}

}  // namespace
}  // namespace hidwa_local_planner::record
