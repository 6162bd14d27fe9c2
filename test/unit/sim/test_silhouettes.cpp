// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "sim/random.hpp"
#include "sim/silhouettes.hpp"

namespace hidwa_local_planner {
namespace sim {
namespace {

Mover somebody(double x, double y, double radius = 0.3, Body body = Body::whole) {
  Mover m;
  m.position = {x, y};
  m.radius = radius;
  m.body = body;
  return m;
}

TEST(Silhouettes, SomebodyHidesWhoIsBehind) {
  const Silhouettes both({somebody(3.0, 0.0), somebody(2.0, 0.1)});
  const auto hit = both.cast(0.0, 0.1, 0.0, 10.0);
  EXPECT_NEAR(hit.range, 1.7, 1e-12);
  EXPECT_EQ(hit.mover, 1U);
  EXPECT_TRUE(std::isinf(both.cast(0.0, 0.1, M_PI, 10.0).range));
  EXPECT_TRUE(std::isinf(both.cast(0.0, 0.1, 0.0, 1.6).range));  // out of range
  EXPECT_EQ(both.cast(2.1, 0.1, 1.0, 10.0).range, 0.0);          // inside
}

// Goes along the ray in steps of 1 mm.
double marched(const std::vector<Silhouettes::Disc>& discs, double x, double y, double angle, double range_max) {
  for (double r = 0.0; r <= range_max; r += 1e-3) {
    const Eigen::Vector2d point(x + r * std::cos(angle), y + r * std::sin(angle));
    for (const auto& disc : discs) {
      if ((disc.centre - point).norm() <= disc.radius) return r;
    }
  }
  return std::numeric_limits<double>::infinity();
}

// Whether the ray passes less than 0.1 mm within some disc's rim: a march may step over it.
bool grazed(const std::vector<Silhouettes::Disc>& discs, double x, double y, double angle) {
  return std::any_of(discs.begin(), discs.end(), [&](const Silhouettes::Disc& disc) {
    const Eigen::Vector2d to = disc.centre - Eigen::Vector2d(x, y);
    const double across = std::abs(to.y() * std::cos(angle) - to.x() * std::sin(angle));
    return across <= disc.radius && across > disc.radius - 1e-4;
  });
}

TEST(Silhouettes, RangesAreThoseOfAMarchAlongTheRay) {
  Random random(11);
  int met = 0;
  for (int scene = 0; scene < 40; ++scene) {
    std::vector<Mover> movers;
    for (int k = 0; k < 6; ++k) {
      const double x = 6.0 * random.uniform() - 3.0, y = 6.0 * random.uniform() - 3.0;
      movers.push_back(somebody(x, y, 0.2 + 0.3 * random.uniform(), k % 2 == 0 ? Body::legs : Body::whole));
      movers.back().heading = 6.0 * random.uniform();
      movers.back().gait = 6.0 * random.uniform();
      movers.back().velocity = {random.uniform(), random.uniform()};
    }
    const Silhouettes seen(movers);
    for (int ray = 0; ray < 20; ++ray) {
      const double angle = 2.0 * M_PI * random.uniform();
      const double slow = marched(seen.discs(), 0.1, -0.2, angle, 4.0), quick = seen.cast(0.1, -0.2, angle, 4.0).range;
      if (std::isinf(slow)) {
        EXPECT_TRUE(std::isinf(quick) || quick > 3.99 || grazed(seen.discs(), 0.1, -0.2, angle)) << quick;
      } else {
        EXPECT_NEAR(quick, slow, 2e-3);
        ++met;
      }
    }
  }
  EXPECT_GT(met, 150);
}

// Whoever tracks legs must find them within the disc that stands for the person.
TEST(Silhouettes, LegsStayWithinThePersonsDisc) {
  double farthest = 0.0;
  bool apart = false;
  for (const double speed : {0.0, 0.6, 1.2, 1.8}) {
    for (double gait = 0.0; gait < 2.0 * M_PI; gait += 0.1) {
      Mover walker = somebody(1.0, 2.0, 0.3, Body::legs);
      walker.velocity = {0.0, speed};
      walker.heading = M_PI / 2.0;
      walker.gait = gait;
      const Silhouettes seen({walker});
      ASSERT_EQ(seen.discs().size(), 2U);
      for (const auto& leg : seen.discs()) {
        farthest = std::max(farthest, (leg.centre - walker.position).norm() + leg.radius);
      }
      apart = apart || std::abs(seen.discs()[0].centre.y() - seen.discs()[1].centre.y()) > 0.3;
    }
  }
  EXPECT_LE(farthest, 0.3);  // sqrt(0.10^2 + 0.18^2) + 0.07 = 0.276
  EXPECT_TRUE(apart);        // 2 * 0.18 at full swing
}

}  // namespace
}  // namespace sim
}  // namespace hidwa_local_planner
