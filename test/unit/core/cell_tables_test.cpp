// SPDX-License-Identifier: BSD-3-Clause
// Tables of cells that are made and read many at a time, against one cell or one pose at a time.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <vector>

#include <gtest/gtest.h>

#include "core/collision/bit_grid.hpp"
#include "core/collision/cell_classes.hpp"
#include "core/collision/collision.hpp"
#include "core/distance/cell_index.hpp"
#include "support/naive_planner.hpp"
#include "support/random.hpp"
#include "support/random_scene.hpp"
#include "support/scene_rollout.hpp"

namespace hidwa_local_planner {
namespace {

using test::Random;
using test::Scene;
using test::SceneRollout;

TEST(BitGrid, MarksTheCellsThatHoldOneOfTwoValues) {
  Random random(1);
  for (int round = 0; round < 200; ++round) {
    const int width = random.integer(1, 200), begin = random.integer(0, width - 1), end = random.integer(begin, width);
    std::vector<std::uint8_t> cells(static_cast<std::size_t>(width));
    for (std::uint8_t& cell : cells) cell = static_cast<std::uint8_t>(random.integer(250, 255));
    BitGrid grid;
    grid.reset(width, 2);
    grid.set_where(1, begin, end, cells.data() + begin, 254, 252);
    for (int i = 0; i < width; ++i) {
      const std::uint8_t cell = cells[static_cast<std::size_t>(i)];
      EXPECT_EQ(grid.test(i, 1), i >= begin && i < end && (cell == 254 || cell == 252)) << i << " of " << width;
      EXPECT_FALSE(grid.test(i, 0));
    }
  }
}

TEST(BitGrid, BitsBecomeBytes) {
  Random random(2);
  for (int round = 0; round < 200; ++round) {
    std::uint64_t bits = 0;
    for (int b = 0; b < 64; ++b) bits |= std::uint64_t{random.chance(0.5) ? 1U : 0U} << b;
    std::uint8_t flags[64];
    BitGrid::unpack(bits, flags);
    for (int b = 0; b < 64; ++b) ASSERT_EQ(flags[b], (bits >> b) & 1U) << "bit " << b;
  }
}

BitGrid random_bits(Random& random, int width, int height) {
  BitGrid grid;
  grid.reset(width, height);
  const double share = random.pick({0.02, 0.5, 0.97});
  for (int j = 0; j < height; ++j) {
    for (int i = 0; i < width; ++i) {
      if (random.chance(share)) grid.set(i, j);
    }
  }
  return grid;
}

bool holds(const BitGrid& grid, int i, int j) {
  return i >= 0 && i < grid.width() && j >= 0 && j < grid.height() && grid.test(i, j);
}

// Rows that reach 3, 1, 0 cells to the sides; below 0 a row and those after it reach nothing.
TEST(BitGrid, DilatedAsCellByCell) {
  Random random(3);
  for (int round = 0; round < 100; ++round) {
    const int width = random.integer(1, 200), height = random.integer(1, 12);
    const BitGrid grid = random_bits(random, width, height);
    std::vector<int> reach;
    for (int widest = random.integer(-1, 70); reach.size() < 5; widest = random.integer(-1, std::max(widest, -1))) {
      reach.push_back(widest);
    }
    BitGrid out;
    grid.dilate(reach, out);
    for (int j = 0; j < grid.height(); ++j) {
      for (int i = 0; i < grid.width(); ++i) {
        bool expected = false;
        for (int dy = -4; dy <= 4; ++dy) {
          const int wide = reach[static_cast<std::size_t>(std::abs(dy))];
          for (int dx = -wide; dx <= wide; ++dx) expected = expected || holds(grid, i + dx, j + dy);
        }
        ASSERT_EQ(out.test(i, j), expected) << i << ", " << j << " in round " << round;
      }
    }
  }
}

TEST(BitGrid, EdgesAndRangesAsCellByCell) {
  Random random(4);
  for (int round = 0; round < 100; ++round) {
    const int width = random.integer(1, 200), height = random.integer(1, 12);
    const BitGrid grid = random_bits(random, width, height);
    BitGrid edges;
    grid.find_edges(edges);
    for (int j = 0; j < grid.height(); ++j) {
      for (int i = 0; i < grid.width(); ++i) {
        const bool surrounded =
            holds(grid, i - 1, j) && holds(grid, i + 1, j) && holds(grid, i, j - 1) && holds(grid, i, j + 1);
        ASSERT_EQ(edges.test(i, j), grid.test(i, j) && !surrounded) << i << ", " << j << " in round " << round;
      }
      const int from = random.integer(0, grid.width() - 1), to = random.integer(from, grid.width() - 1);
      bool any = false;
      for (int i = from; i <= to; ++i) any = any || grid.test(i, j);
      EXPECT_EQ(grid.any(j, from, to), any) << from << " to " << to;
      const std::uint64_t bits = grid.bits(j, from);
      for (int b = 0; b < 64 && from + b < grid.width(); ++b) {
        ASSERT_EQ((bits >> b) & 1U, grid.test(from + b, j) ? 1U : 0U);
      }
    }
  }
}

std::uint8_t cost_class(const Scene& scene, const GridView& grid, double x, double y) {
  const Cell cell = grid.cell_at(x, y);
  const std::uint8_t value = grid.contains(cell) ? grid.at(cell) : cost::kLethal;
  const bool blocked = value == cost::kLethal || value == cost::kInscribed ||
                       (value == cost::kUnknown && scene.parameters.unknown_is_obstacle);
  return blocked ? cell_class::kBlocked : 0;
}

TEST(CellClasses, ATileIsClassifiedAsItsPosesAre) {
  int open = 0, near = 0, hit = 0, blocked = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Scene scene = test::random_scene(seed);
    if (seed % 4 == 0) {  // a table of more than 64 cells a row: 1 m/s x 3 s = 3 m to either side
      scene.parameters.sim_time = 3.0;
      scene.situation.last_command.v = 1.0;
    }
    SceneRollout cycle(scene);
    const Pose2& start = scene.situation.pose;
    const bool unknown = scene.parameters.unknown_is_obstacle;
    CollisionChecker checker;
    checker.prepare(cycle.grid, cycle.footprint, unknown, start, cycle.reach, 0.5 * cycle.rollout.longest_step());
    CellClasses classes;
    classes.prepare(checker, cycle.grid, unknown, start, cycle.reach);
    for (std::size_t t = 0; t < cycle.rollout.tile_count(); ++t) {
      const Tile tile = cycle.rollout.tile(t);
      const TileCells cells = classes.under(tile);
      std::uint8_t any = 0;
      for (std::size_t c = 0; c < tile.count; ++c) {
        std::uint8_t touched = 0;
        for (std::size_t k = 0; k <= tile.steps; ++k) {
          const std::uint8_t found = cells.classes[k * tile.stride + c];
          const Pose2 pose = tile.pose(k, c);
          const std::uint8_t by_cost = cost_class(scene, cycle.grid, pose.x, pose.y);
          ASSERT_EQ(found & cell_class::kBlocked, by_cost);
          ASSERT_EQ((found & cell_class::kNear) == 0, checker.clear(pose.x, pose.y));
          if ((found & cell_class::kHit) != 0) {
            ASSERT_TRUE(checker.collides(pose));
          }
          touched = static_cast<std::uint8_t>(touched | (k == 0 ? found & ~cell_class::kHit : found));
          near += (found & cell_class::kNear) != 0;
          hit += (found & cell_class::kHit) != 0;
          blocked += by_cost != 0;
        }
        ASSERT_EQ(cells.touched[c], touched) << "tile " << t << ", candidate " << c;
        any = static_cast<std::uint8_t>(any | touched);
      }
      ASSERT_EQ(cells.touched_any, any);
      open += any == 0;
    }
  }
  for (const int often : {open, near, hit, blocked}) EXPECT_GT(often, 100);
}

TEST(FindCells, AreThoseOfThePointsAhead) {
  Random random(3);
  int outside = 0, inside = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const Scene scene = test::random_scene(seed);
    SceneRollout cycle(scene);
    const kernel::CellBox box{random.integer(-3, 10), random.integer(-3, 10), random.integer(5, 60),
                              random.integer(5, 60)};
    for (std::size_t t = 0; t < cycle.rollout.tile_count(); ++t) {
      const Tile tile = cycle.rollout.tile(t);
      const std::size_t row = tile.steps * tile.stride;
      for (const double forward : {0.0, 0.1, 0.325}) {
        std::vector<std::int32_t> at_i(tile.count), at_j(tile.count);
        kernel::find_cells(cycle.grid, box, tile.x + row, tile.y + row, forward * tile.cos_heading[tile.steps],
                           forward * tile.sin_heading[tile.steps], tile.count, at_i.data(), at_j.data());
        for (std::size_t c = 0; c < tile.count; ++c) {
          const Pose2 last = tile.last_pose(c);
          const Cell cell = cycle.grid.cell_at(last.x + forward * tile.cos_heading[tile.steps],
                                               last.y + forward * tile.sin_heading[tile.steps]);
          const int i = cell.i - box.i, j = cell.j - box.j;
          const bool in_box = i >= 0 && i < box.width && j >= 0 && j < box.height;
          ASSERT_EQ(at_i[c] >= 0, in_box);
          ++(in_box ? inside : outside);
          if (!in_box) continue;
          ASSERT_EQ(at_i[c], i);
          ASSERT_EQ(at_j[c], j);
        }
      }
    }
  }
  EXPECT_GT(inside, 1000);
  EXPECT_GT(outside, 1000);
}

}  // namespace
}  // namespace hidwa_local_planner
