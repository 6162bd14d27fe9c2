// SPDX-License-Identifier: BSD-3-Clause
#include "sim/disc_field.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "random_scene.hpp"

namespace hidwa_local_planner {
namespace sim {
namespace {

constexpr double kRadius = 0.075;  // [m]
const Polygon kRectangle{{0.21, 0.165}, {-0.21, 0.165}, {-0.21, -0.165}, {0.21, -0.165}};

std::vector<Eigen::Vector2d> random_centres(Random& random) {
  std::vector<Eigen::Vector2d> centres;
  for (int k = 0; k < 40; ++k) centres.push_back({uniform(random, -2.0, 2.0), uniform(random, -1.0, 3.0)});
  return centres;
}

// The slow and obvious way: points 1 mm apart on the outline against every centre.
double naive_gap(const std::vector<Eigen::Vector2d>& centres, const Polygon& polygon, double at_most) {
  double least = at_most;
  for (const Eigen::Vector2d& centre : centres) {
    if (contains(polygon, centre)) return 0.0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Eigen::Vector2d side = polygon[(i + 1) % polygon.size()] - polygon[i];
      const int parts = static_cast<int>(std::ceil(side.norm() / 0.001));
      for (int k = 0; k < parts; ++k) {
        least = std::min(least, (polygon[i] + side * (static_cast<double>(k) / parts) - centre).norm() - kRadius);
      }
    }
  }
  return std::max(0.0, least);
}

// The slow and obvious way: the circle's equation for every disc.
double naive_range(const std::vector<Eigen::Vector2d>& centres, const Eigen::Vector2d& from, double angle,
                   double range_max) {
  double nearest = std::numeric_limits<double>::infinity();
  const Eigen::Vector2d along(std::cos(angle), std::sin(angle));
  for (const Eigen::Vector2d& centre : centres) {
    const Eigen::Vector2d to = from - centre;  // |to + t along| = radius
    const double b = to.dot(along), c = to.squaredNorm() - kRadius * kRadius;
    if (c <= 0.0) return 0.0;
    if (b * b - c < 0.0) continue;
    const double t = -b - std::sqrt(b * b - c);
    if (t >= 0.0) nearest = std::min(nearest, t);
  }
  return nearest <= range_max ? nearest : std::numeric_limits<double>::infinity();
}

TEST(DiscField, GapAgreesWithTheNaiveTwin) {
  Random random(3);
  int apart = 0, overlaps = 0;
  for (int scene = 0; scene < 20; ++scene) {
    const std::vector<Eigen::Vector2d> centres = random_centres(random);
    const DiscField field(centres, kRadius);
    for (int k = 0; k < 40; ++k) {
      const Pose pose{uniform(random, -3.0, 3.0), uniform(random, -2.0, 4.0), uniform(random, -4.0, 4.0)};
      const Polygon placed = transformed(kRectangle, pose);
      const double at_most = uniform(random, 0.05, 1.0);
      const double expected = naive_gap(centres, placed, at_most);
      ASSERT_NEAR(field.gap(placed, at_most), expected, 1e-3);
      if (expected > 1e-3) {
        ASSERT_FALSE(field.overlaps(placed));
      }
      apart += expected > 0.0 && expected < at_most;
      overlaps += field.overlaps(placed);
    }
  }
  EXPECT_GT(apart, 100);
  EXPECT_GT(overlaps, 100);
}

TEST(DiscField, RangeAgreesWithTheNaiveTwin) {
  Random random(4);
  int hits = 0;
  for (int scene = 0; scene < 20; ++scene) {
    const std::vector<Eigen::Vector2d> centres = random_centres(random);
    const DiscField field(centres, kRadius);
    for (int k = 0; k < 400; ++k) {
      const Eigen::Vector2d from{uniform(random, -4.0, 4.0), uniform(random, -3.0, 5.0)};
      const double angle = k % 8 == 0 ? 0.5 * M_PI * (k / 8) : uniform(random, -7.0, 7.0);
      const double longest = uniform(random, 0.5, 8.0);
      const double expected = naive_range(centres, from, angle, longest);
      const double range = field.range(from.x(), from.y(), angle, longest);
      if (std::isinf(expected)) {
        ASSERT_TRUE(std::isinf(range)) << "scene " << scene << " ray " << k;
      } else {
        ASSERT_NEAR(range, expected, 1e-9) << "scene " << scene << " ray " << k;
        ++hits;
      }
    }
  }
  EXPECT_GT(hits, 1000);
}

TEST(DiscField, TellsHowFarAPointIs) {
  const DiscField field({{1.0, 0.0}}, 0.1);
  EXPECT_NEAR(field.distance({0.5, 0.0}, 2.0), 0.4, 1e-12);  // 1.0 - 0.5 - 0.1
  EXPECT_NEAR(field.distance({0.95, 0.0}, 2.0), -0.05, 1e-12);
  EXPECT_EQ(field.distance({-5.0, 0.0}, 2.0), 2.0);
}

TEST(DiscField, MayBeEmptyButNotSenseless) {
  const DiscField none({}, 0.1);
  EXPECT_TRUE(std::isinf(none.range(0.0, 0.0, 1.0, 10.0)));
  EXPECT_EQ(none.gap(kRectangle, 0.7), 0.7);
  EXPECT_THROW(DiscField({{0.0, 0.0}}, 0.0), std::invalid_argument);
  EXPECT_THROW(DiscField({{std::nan(""), 0.0}}, 0.1), std::invalid_argument);
}

}  // namespace
}  // namespace sim
}  // namespace hidwa_local_planner
