// SPDX-License-Identifier: BSD-3-Clause
#include <costmap_2d/costmap_2d.h>
#include <costmap_2d/line.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <limits>
#include <random>
#include <set>
#include <utility>

namespace costmap_2d {
namespace {

geometry_msgs::Point point(double x, double y) {
  geometry_msgs::Point p;
  p.x = x;
  p.y = y;
  return p;
}

Costmap2D randomMap(std::mt19937& random, unsigned int width, unsigned int height, unsigned char default_value) {
  Costmap2D map(width, height, 0.05, -1.0, 2.0, default_value);
  for (unsigned int i = 0; i < width * height; ++i) map.getCharMap()[i] = static_cast<unsigned char>(random() % 256);
  return map;
}

TEST(Costmap2D, CellsAndPoints) {
  const Costmap2D map(4, 3, 0.5, 1.0, -1.0, 7);
  double wx, wy;
  map.mapToWorld(2, 0, wx, wy);
  EXPECT_DOUBLE_EQ(wx, 2.25);   // 1.0 + 2.5 x 0.5
  EXPECT_DOUBLE_EQ(wy, -0.75);  // -1.0 + 0.5 x 0.5
  unsigned int mx, my;
  ASSERT_TRUE(map.worldToMap(2.49, -0.01, mx, my));
  EXPECT_EQ(mx, 2u);  // 1.49 / 0.5 = 2.98
  EXPECT_EQ(my, 1u);  // 0.99 / 0.5 = 1.98
  EXPECT_FALSE(map.worldToMap(0.99, 0.0, mx, my));
  EXPECT_FALSE(map.worldToMap(3.0, 0.0, mx, my));  // the far edge is outside
  EXPECT_FALSE(map.worldToMap(std::numeric_limits<double>::quiet_NaN(), 0.0, mx, my));
  int ix, iy;
  map.worldToMapEnforceBounds(-5.0, 99.0, ix, iy);
  EXPECT_EQ(ix, 0);
  EXPECT_EQ(iy, 2);
  map.worldToMapNoBounds(3.6, -2.6, ix, iy);
  EXPECT_EQ(ix, 5);   // 2.6 / 0.5 = 5.2
  EXPECT_EQ(iy, -3);  // -1.6 / 0.5 = -3.2
  EXPECT_EQ(map.getCost(3, 2), 7);
  EXPECT_DOUBLE_EQ(map.getSizeInMetersX(), 1.75);  // 3.5 x 0.5
  EXPECT_EQ(map.cellDistance(0.51), 2u);
}

// Twin: every cell of the moved map looks up where it was before.
TEST(Costmap2D, MovingTheOriginKeepsWhatStaysInView) {
  std::mt19937 random(1);
  for (int scene = 0; scene < 200; ++scene) {
    Costmap2D map = randomMap(random, 20, 15, 9);
    const Costmap2D before = map;
    const int dx = static_cast<int>(random() % 51) - 25;
    const int dy = static_cast<int>(random() % 51) - 25;
    const double part = dx == 0 || dy == 0 ? 0.0 : 0.4;  // part of a cell: dropped
    map.updateOrigin(-1.0 + 0.05 * (dx + (dx < 0 ? -part : part)), 2.0 + 0.05 * (dy + (dy < 0 ? -part : part)));
    EXPECT_NEAR(map.getOriginX(), -1.0 + 0.05 * dx, 1e-12);
    EXPECT_NEAR(map.getOriginY(), 2.0 + 0.05 * dy, 1e-12);
    for (int y = 0; y < 15; ++y) {
      for (int x = 0; x < 20; ++x) {
        const bool seen = x + dx >= 0 && x + dx < 20 && y + dy >= 0 && y + dy < 15;
        const int expected =
            seen ? before.getCost(static_cast<unsigned int>(x + dx), static_cast<unsigned int>(y + dy)) : 9;
        ASSERT_EQ(map.getCost(static_cast<unsigned int>(x), static_cast<unsigned int>(y)), expected)
            << "scene " << scene << " shift " << dx << ", " << dy << " cell " << x << ", " << y;
      }
    }
  }
}

TEST(Costmap2D, ResetOnlyTheWindow) {
  std::mt19937 random(2);
  Costmap2D map = randomMap(random, 10, 10, 3);
  const Costmap2D before = map;
  map.resetMap(2, 4, 7, 9);
  for (unsigned int y = 0; y < 10; ++y) {
    for (unsigned int x = 0; x < 10; ++x) {
      const bool within = x >= 2 && x < 7 && y >= 4 && y < 9;
      EXPECT_EQ(map.getCost(x, y), within ? 3 : before.getCost(x, y));
    }
  }
}

TEST(Costmap2D, FillsAConvexPolygon) {
  Costmap2D map(20, 20, 0.1, 0.0, 0.0);
  // Cells 5 to 10 by 3 to 7: (10 - 5 + 1) x (7 - 3 + 1) = 30.
  ASSERT_TRUE(
      map.setConvexPolygonCost({point(0.55, 0.35), point(1.05, 0.35), point(1.05, 0.75), point(0.55, 0.75)}, 8));
  int count = 0;
  for (unsigned int y = 0; y < 20; ++y) {
    for (unsigned int x = 0; x < 20; ++x) {
      const bool inside = x >= 5 && x <= 10 && y >= 3 && y <= 7;
      EXPECT_EQ(map.getCost(x, y), inside ? 8 : 0);
      count += map.getCost(x, y) == 8;
    }
  }
  EXPECT_EQ(count, 30);
  EXPECT_FALSE(map.setConvexPolygonCost({point(-0.1, 0.3), point(1.0, 0.3), point(1.0, 0.7)}, 9));
  EXPECT_EQ(map.getCost(8, 5), 8);
}

TEST(Line, ConnectedAndClose) {
  std::mt19937 random(3);
  constexpr int kWidth = 40;
  for (int scene = 0; scene < 500; ++scene) {
    const int x0 = static_cast<int>(random() % 40), y0 = static_cast<int>(random() % 40);
    const int x1 = static_cast<int>(random() % 40), y1 = static_cast<int>(random() % 40);
    std::vector<std::pair<int, int>> cells;
    visitLine(x0, y0, x1, y1, kWidth, 1e9, [&](int index) { cells.push_back({index % kWidth, index / kWidth}); });
    EXPECT_EQ(cells.front(), std::make_pair(x0, y0));
    EXPECT_EQ(cells.back(), std::make_pair(x1, y1));
    EXPECT_EQ(static_cast<int>(cells.size()), 1 + std::max(std::abs(x1 - x0), std::abs(y1 - y0)));
    const double length = std::hypot(x1 - x0, y1 - y0);
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const double off = (cells[i].first - x0) * (y1 - y0) - (cells[i].second - y0) * (x1 - x0);
      if (length > 0.0) {
        EXPECT_LE(std::abs(off) / length, 0.5 + 1e-9);
      }
      if (i > 0) {
        EXPECT_LE(std::abs(cells[i].first - cells[i - 1].first), 1);
        EXPECT_LE(std::abs(cells[i].second - cells[i - 1].second), 1);
      }
    }
  }
}

TEST(Line, EndsAtItsGreatestLength) {
  int count = 0;
  visitLine(0, 0, 30, 0, 40, 12.0, [&count](int) { ++count; });
  EXPECT_EQ(count, 13);  // its start and 12 more
}

}  // namespace
}  // namespace costmap_2d
