// SPDX-License-Identifier: BSD-3-Clause
#include <costmap_2d/cost_values.h>
#include <costmap_2d/inflator.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace costmap_2d {
namespace {

Inflator::Settings settings(double radius, double inscribed, double scaling) {
  Inflator::Settings s;
  s.inflation_radius = radius;
  s.inscribed_radius = inscribed;
  s.cost_scaling_factor = scaling;
  s.resolution = 0.05;
  return s;
}

Costmap2D randomScene(std::mt19937& random, unsigned int width, unsigned int height) {
  Costmap2D map(width, height, 0.05, 0.0, 0.0);
  for (unsigned int i = 0; i < width * height; ++i) {
    const unsigned int kind = static_cast<unsigned int>(random() % 100);
    map.getCharMap()[i] = kind < 3 ? LETHAL_OBSTACLE : kind < 8 ? NO_INFORMATION : kind < 10 ? 30 : FREE_SPACE;
  }
  return map;
}

// The slow, obvious way: for each cell of the window the nearest lethal cell of the whole map.
Costmap2D naive(const Costmap2D& before, const Inflator::Settings& s, int x0, int y0, int xn, int yn) {
  Costmap2D after = before;
  const int width = static_cast<int>(before.getSizeInCellsX()), height = static_cast<int>(before.getSizeInCellsY());
  const double reach = std::ceil(s.inflation_radius / s.resolution);  // [cells]
  for (int y = y0; y < yn; ++y) {
    for (int x = x0; x < xn; ++x) {
      double nearest = 1e9;
      for (int oy = 0; oy < height; ++oy) {
        for (int ox = 0; ox < width; ++ox) {
          if (before.getCharMap()[oy * width + ox] == LETHAL_OBSTACLE) {
            nearest = std::min(nearest, std::hypot(ox - x, oy - y));
          }
        }
      }
      if (nearest > reach) continue;
      const double distance = nearest * s.resolution;
      int cost = LETHAL_OBSTACLE;
      if (nearest > 0.0) {
        cost = distance <= s.inscribed_radius
                   ? INSCRIBED_INFLATED_OBSTACLE
                   : static_cast<int>(252.0 * std::exp(-s.cost_scaling_factor * (distance - s.inscribed_radius)));
      }
      unsigned char& cell = after.getCharMap()[y * width + x];
      if (cell == NO_INFORMATION) {
        if (s.inflate_unknown ? cost > FREE_SPACE : cost >= INSCRIBED_INFLATED_OBSTACLE) {
          cell = static_cast<unsigned char>(cost);
        }
      } else {
        cell = static_cast<unsigned char>(std::max<int>(cell, cost));
      }
    }
  }
  return after;
}

TEST(Inflator, Formula) {
  Inflator inflator;
  inflator.configure(settings(1.0, 0.3, 10.0));
  EXPECT_EQ(inflator.costAt(0.0), LETHAL_OBSTACLE);
  EXPECT_EQ(inflator.costAt(0.05), INSCRIBED_INFLATED_OBSTACLE);
  EXPECT_EQ(inflator.costAt(0.3), INSCRIBED_INFLATED_OBSTACLE);
  EXPECT_EQ(inflator.costAt(0.4), 92);  // 252 e^-1 = 92.7
  EXPECT_EQ(inflator.costAt(0.5), 34);  // 252 e^-2 = 34.1
  EXPECT_EQ(inflator.costAt(0.85), 1);  // 252 e^-5.5 = 1.03
  EXPECT_EQ(inflator.costAt(0.86), 0);  // 252 e^-5.6 = 0.93
}

TEST(Inflator, EqualsTheNaiveTwin) {
  std::mt19937 random(11);
  for (int scene = 0; scene < 60; ++scene) {
    Inflator::Settings s =
        settings(0.05 + 0.01 * double(random() % 60), 0.01 * double(random() % 40), 1.0 + double(random() % 12));
    s.inflate_unknown = scene % 3 == 0;
    Costmap2D map = randomScene(random, 36, 29);
    const int x0 = scene % 2 ? static_cast<int>(random() % 18) : 0,
              y0 = scene % 2 ? static_cast<int>(random() % 14) : 0;
    const int xn = scene % 2 ? x0 + 1 + static_cast<int>(random() % 18) : 36, yn = scene % 2 ? y0 + 15 : 29;
    const Costmap2D expected = naive(map, s, x0, y0, xn, yn);
    Inflator inflator;
    inflator.configure(s);
    inflator.inflate(map, x0, y0, xn, yn);
    for (unsigned int i = 0; i < 36 * 29; ++i) {
      ASSERT_EQ(map.getCharMap()[i], expected.getCharMap()[i])
          << "scene " << scene << " cell " << i % 36 << ", " << i / 36;
    }
  }
}

TEST(Inflator, NoRadiusNoCost) {
  Costmap2D map(5, 5, 0.05, 0.0, 0.0);
  map.setCost(2, 2, LETHAL_OBSTACLE);
  Inflator inflator;
  inflator.configure(settings(0.0, 0.3, 10.0));
  inflator.inflate(map, 0, 0, 5, 5);
  EXPECT_EQ(map.getCost(2, 2), LETHAL_OBSTACLE);
  EXPECT_EQ(map.getCost(2, 3), FREE_SPACE);
}

}  // namespace
}  // namespace costmap_2d
