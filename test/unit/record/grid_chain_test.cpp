// SPDX-License-Identifier: BSD-3-Clause
#include "record/grid_chain.hpp"

#include <gtest/gtest.h>

#include "support/random.hpp"
#include "support/random_scene.hpp"

namespace hidwa_local_planner::record {
namespace {

using test::Random;

// A map that rolls, changes in places, and now and then is another one altogether.
StoredGrid next(const StoredGrid& before, Random& random) {
  StoredGrid grid = before;
  if (random.chance(0.05) || before.costs.empty()) {
    grid.size_x = random.integer(1, 50);
    grid.size_y = random.integer(1, 50);
    grid.resolution = random.pick({0.05, 0.1});
    grid.costs.assign(static_cast<std::size_t>(grid.size_x * grid.size_y), 0);
  }
  if (random.chance(0.5)) grid.origin_x += random.integer(-60, 60) * grid.resolution;
  if (random.chance(0.3)) grid.origin_y += random.integer(-3, 3) * grid.resolution;
  if (random.chance(0.05)) grid.origin_y += 0.3 * grid.resolution;  // not by whole cells
  for (std::uint8_t& cost : grid.costs) {
    if (random.chance(0.02)) cost = static_cast<std::uint8_t>(random.integer(0, 255));
  }
  return grid;
}

TEST(GridChain, APatchLeadsToTheSameMap) {
  Random random(5);
  GridChain writer, reader;
  StoredGrid grid;
  for (int k = 0; k < 2000; ++k) {
    if (!random.chance(0.2)) grid = next(grid, random);
    ASSERT_TRUE(reader.advance_by(writer.advance_to(grid.view(), k == 0 || random.chance(0.02))));
    ASSERT_EQ(reader.present().costs, grid.costs) << k;
    ASSERT_EQ(reader.present().size_x, grid.size_x);
    ASSERT_EQ(reader.present().size_y, grid.size_y);
    ASSERT_EQ(reader.present().resolution, grid.resolution);
    ASSERT_EQ(reader.present().origin_x, grid.origin_x);
    ASSERT_EQ(reader.present().origin_y, grid.origin_y);
  }
}

TEST(GridChain, WhatDidNotChangeTakesNoBytes) {
  Random random(6);
  StoredGrid grid;
  grid = next(grid, random);
  GridChain chain;
  EXPECT_FALSE(chain.advance_to(grid.view(), true).changes.empty());
  EXPECT_TRUE(chain.advance_to(grid.view(), false).changes.empty());
}

// Rolled by 7 cells over a field that stays, only the 7 new columns differ: fewer bytes than the map whole.
TEST(GridChain, ARolledMapIsComparedWhereTheTwoOverlap) {
  Random random(7);
  std::vector<std::uint8_t> field(107 * 100);
  for (std::uint8_t& cost : field) cost = static_cast<std::uint8_t>(random.integer(0, 255));
  const auto window = [&field](int from) {
    StoredGrid grid{100, 100, 0.05, 0.05 * from, 0.0, Bytes(100 * 100)};
    for (int j = 0; j < 100; ++j) {
      for (int i = 0; i < 100; ++i) {
        grid.costs[static_cast<std::size_t>(j * 100 + i)] = field[static_cast<std::size_t>(j * 107 + i + from)];
      }
    }
    return grid;
  };
  GridChain chain;
  const std::size_t whole = chain.advance_to(window(0).view(), true).changes.size();
  const std::size_t rolled = chain.advance_to(window(7).view(), false).changes.size();
  EXPECT_GT(whole, 10000u);  // random bytes do not deflate
  EXPECT_LT(rolled, 1500u);  // 7 x 100 new ones, and where they are
}

TEST(GridChain, ADamagedPatchIsRefused) {
  Random random(8);
  StoredGrid grid;
  grid = next(grid, random);
  GridChain writer, reader;
  const GridPatch whole = writer.advance_to(grid.view(), true);
  GridPatch cut = whole, vast = whole, negative = whole, first = whole;
  cut.changes.resize(cut.changes.size() / 2);
  vast.size_x = vast.size_y = 1 << 30;
  negative.size_x = -1;
  first.whole = false;  // and there is none before it
  for (const GridPatch* bad : {&cut, &vast, &negative, &first}) EXPECT_FALSE(reader.advance_by(*bad));
  EXPECT_TRUE(reader.present().costs.empty());
  EXPECT_TRUE(reader.advance_by(whole));
}

TEST(GridChain, AnEmptyMapIsOne) {
  GridChain writer, reader;
  ASSERT_TRUE(reader.advance_by(writer.advance_to(GridView(), true)));
  EXPECT_FALSE(reader.present().view().valid());
}

}  // namespace
}  // namespace hidwa_local_planner::record
