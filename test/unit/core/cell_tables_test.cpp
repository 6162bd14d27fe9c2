// SPDX-License-Identifier: BSD-3-Clause
// Tables of cells that are made and read many at a time, against one cell or one pose at a time.
#include <cstdint>
#include <cstdlib>
#include <vector>

#include <gtest/gtest.h>

#include "core/collision/cell_classes.hpp"
#include "core/collision/cell_flags.hpp"
#include "core/collision/collision.hpp"
#include "support/naive_planner.hpp"
#include "support/random.hpp"
#include "support/random_scene.hpp"
#include "support/scene_rollout.hpp"

namespace hidwa_local_planner {
namespace {

using test::Random;
using test::Scene;
using test::SceneRollout;

constexpr std::uint8_t kMarked = 8, kSpread = 2, kOnEdge = 32, kOther = 4;

// Some cells have the flag kMarked, some have another one.
CellFlags random_flags(Random& random) {
  const int width = random.integer(1, 200), height = random.integer(1, 12);
  CellFlags cells;
  cells.reset(width, height);
  const double share = random.pick({0.02, 0.5, 0.97});
  for (int j = 0; j < height; ++j) {
    for (int i = 0; i < width; ++i) {
      if (random.chance(share)) cells.row(j)[i] = kMarked;
      if (random.chance(0.1)) cells.row(j)[i] |= kOther;
    }
  }
  return cells;
}

bool marked(const CellFlags& cells, int i, int j) {
  return i >= 0 && i < cells.width() && j >= 0 && j < cells.height() && (cells.at(i, j) & kMarked) != 0;
}

// Rows that reach 3, 1, 0 cells to the sides; those after them reach nothing.
TEST(CellFlags, SpreadAsCellByCell) {
  Random random(3);
  for (int round = 0; round < 100; ++round) {
    const CellFlags before = random_flags(random);
    std::vector<int> reach;
    int widest = random.integer(0, 70);
    for (int rows = random.integer(0, 5); rows > 0; --rows) {
      reach.push_back(widest);
      widest = random.integer(0, widest);
    }
    CellFlags after = before;
    after.spread(kMarked, reach, kSpread);
    const int rows = static_cast<int>(reach.size()) - 1;
    for (int j = 0; j < before.height(); ++j) {
      for (int i = 0; i < before.width(); ++i) {
        bool expected = false;
        for (int dy = -rows; dy <= rows; ++dy) {
          const int wide = reach[static_cast<std::size_t>(std::abs(dy))];
          for (int dx = -wide; dx <= wide; ++dx) expected = expected || marked(before, i + dx, j + dy);
        }
        ASSERT_EQ(after.at(i, j), before.at(i, j) | (expected ? kSpread : 0)) << i << ", " << j << ", round " << round;
      }
    }
    EXPECT_TRUE(after.same(before, 0xFF & ~kSpread));
  }
}

TEST(CellFlags, EdgesAndTheFirstOfARangeAsCellByCell) {
  Random random(4);
  for (int round = 0; round < 100; ++round) {
    const CellFlags before = random_flags(random);
    CellFlags after = before;
    after.mark_edges(kMarked, kOnEdge);
    for (int j = 0; j < before.height(); ++j) {
      for (int i = 0; i < before.width(); ++i) {
        const bool beside = marked(before, i - 1, j) && marked(before, i + 1, j);
        const bool surrounded = beside && marked(before, i, j - 1) && marked(before, i, j + 1);
        const int edge = marked(before, i, j) && !surrounded ? kOnEdge : 0;
        ASSERT_EQ(after.at(i, j), before.at(i, j) | edge) << i << ", " << j << " in round " << round;
      }
      const int from = random.integer(0, before.width() - 1), to = random.integer(from, before.width() - 1);
      int first = from;
      while (first <= to && !marked(before, first, j)) ++first;
      EXPECT_EQ(before.find(kMarked, j, from, to), first) << from << " to " << to;
    }
  }
}

TEST(CellFlags, AreTheSameAsFarAsTheseFlagsAre) {
  Random random(5);
  const CellFlags cells = random_flags(random);
  CellFlags other = cells;
  other.row(cells.height() - 1)[cells.width() - 1] ^= kMarked;
  EXPECT_FALSE(other.same(cells, kMarked | kSpread));
  EXPECT_TRUE(other.same(cells, kSpread));
  other.reset(cells.width(), cells.height() + 1);
  EXPECT_FALSE(other.same(cells, kSpread));
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
    if (seed % 4 == 0) {  // a wide window: 1 m/s x 3 s = 3 m to either side
      scene.parameters.sim_time = 3.0;
      scene.situation.last_command.v = 1.0;
    }
    SceneRollout cycle(scene);
    const Pose2& start = scene.situation.pose;
    const bool unknown = scene.parameters.unknown_is_obstacle;
    CollisionChecker checker;
    checker.prepare(cycle.grid, cycle.footprint, unknown, start, cycle.reach, 0.5 * cycle.rollout.longest_step());
    CellClasses classes;
    for (std::size_t t = 0; t < cycle.rollout.tile_count(); ++t) {
      const Tile tile = cycle.rollout.tile(t);
      const TileCells cells = classes.under(checker, tile);
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

}  // namespace
}  // namespace hidwa_local_planner
