// SPDX-License-Identifier: BSD-3-Clause
#include <costmap_2d/cost_values.h>
#include <costmap_2d/inflator.h>
#include <gtest/gtest.h>
#include <move_base/grid_planner.h>
#include <move_base/grid_route.h>
#include <tf2/utils.h>
#include <tf2_geometry_msgs/tf2_geometry_msgs.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <limits>
#include <random>
#include <vector>

namespace move_base {
namespace {

using costmap_2d::Costmap2D;
using costmap_2d::INSCRIBED_INFLATED_OBSTACLE;
using costmap_2d::LETHAL_OBSTACLE;
using costmap_2d::NO_INFORMATION;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

void fill(Costmap2D& map, unsigned int x0, unsigned int y0, unsigned int xn, unsigned int yn, unsigned char cost) {
  for (unsigned int y = y0; y < yn; ++y) {
    for (unsigned int x = x0; x < xn; ++x) map.setCost(x, y, cost);
  }
}

void inflate(Costmap2D& map, double inflation_radius) {
  costmap_2d::Inflator inflator;
  costmap_2d::Inflator::Settings settings;
  settings.inflation_radius = inflation_radius;
  settings.inscribed_radius = 0.31;
  settings.cost_scaling_factor = 5.0;
  inflator.configure(settings);
  inflator.inflate(map, 0, 0, static_cast<int>(map.getSizeInCellsX()), static_cast<int>(map.getSizeInCellsY()));
}

GridRoute routeOn(const Costmap2D& map, bool allow_unknown = true) {
  GridRoute route;
  route.setCosts(map.getCharMap(), static_cast<int>(map.getSizeInCellsX()), static_cast<int>(map.getSizeInCellsY()),
                 allow_unknown);
  return route;
}

double lengthOf(const std::vector<GridPoint>& route) {
  double length = 0.0;
  for (std::size_t i = 1; i < route.size(); ++i) {
    length += std::hypot(route[i].x - route[i - 1].x, route[i].y - route[i - 1].y);
  }
  return length;
}

Costmap2D randomMap(std::mt19937& random) {
  Costmap2D map(40, 30, 0.05, 0.0, 0.0);
  for (unsigned int i = 0; i < 40 * 30; ++i) {
    const unsigned int kind = static_cast<unsigned int>(random() % 100);
    map.getCharMap()[i] = kind < 30 ? LETHAL_OBSTACLE : static_cast<unsigned char>(random() % 253);
  }
  return map;
}

// The slow, obvious twin: the same upwind rule, swept over the whole map until nothing changes.
std::vector<double> sweptCosts(const Costmap2D& map, int start_x, int start_y) {
  const int width = static_cast<int>(map.getSizeInCellsX()), height = static_cast<int>(map.getSizeInCellsY());
  std::vector<double> total(std::size_t(width * height), kInfinity);
  const auto at = [&](int x, int y) -> double& { return total[std::size_t(y * width + x)]; };
  at(start_x, start_y) = 0.0;
  for (bool changed = true; changed;) {
    changed = false;
    for (int y = 1; y < height - 1; ++y) {
      for (int x = 1; x < width - 1; ++x) {
        const unsigned char value = map.getCharMap()[y * width + x];
        if (value >= INSCRIBED_INFLATED_OBSTACLE) continue;
        const double cost = std::min(253.0, std::floor(50.0 + 0.8 * value));
        const double a = std::min(at(x - 1, y), at(x + 1, y)), b = std::min(at(x, y - 1), at(x, y + 1));
        if (std::min(a, b) == kInfinity) continue;
        const double d = std::abs(a - b);
        const double candidate =
            d < cost ? (a + b + std::sqrt(2.0 * cost * cost - d * d)) / 2.0 : std::min(a, b) + cost;
        if (candidate < at(x, y) - 1e-6) {
          at(x, y) = candidate;
          changed = true;
        }
      }
    }
  }
  return total;
}

TEST(GridRoute, CostsEqualTheSweptTwin) {
  std::mt19937 random(31);
  for (int scene = 0; scene < 60; ++scene) {
    Costmap2D map = randomMap(random);
    map.setCost(20, 15, 0);
    GridRoute route = routeOn(map);
    route.propagate({20, 15}, {-1, -1});
    const auto expected = sweptCosts(map, 20, 15);
    for (int y = 0; y < 30; ++y) {
      for (int x = 0; x < 40; ++x) {
        const double twin = expected[std::size_t(y * 40 + x)];
        const double got = route.costTo({double(x), double(y)});
        if (twin == kInfinity) {
          ASSERT_EQ(got, kInfinity) << "scene " << scene << " cell " << x << ", " << y;
        } else {
          ASSERT_NEAR(got, twin, 1e-4 * twin + 1e-3) << "scene " << scene << " cell " << x << ", " << y;
        }
      }
    }
  }
}

TEST(GridRoute, EveryPointOfARouteIsOpenAndStepsAreShort) {
  std::mt19937 random(32);
  int routes = 0;
  for (int scene = 0; scene < 300; ++scene) {
    Costmap2D map = randomMap(random);
    map.setCost(2, 2, 0);
    map.setCost(37, 27, 0);
    GridRoute route = routeOn(map);
    const GridPoint start{2.3, 1.8}, goal{36.7, 27.2};
    if (!route.propagate(start, goal)) continue;
    ++routes;
    const auto points = route.trace(goal);
    EXPECT_EQ(points.front().x, start.x);
    EXPECT_EQ(points.back().y, goal.y);
    for (std::size_t i = 0; i < points.size(); ++i) {
      EXPECT_TRUE(route.isOpen(static_cast<int>(std::lround(points[i].x)), static_cast<int>(std::lround(points[i].y))));
      if (i > 0) {
        EXPECT_LT(std::hypot(points[i].x - points[i - 1].x, points[i].y - points[i - 1].y), 2.2);
      }
    }
  }
  EXPECT_GT(routes, 30);
}

TEST(GridRoute, FreeSpaceIsCrossedInAStraightLineAtAnyHeading) {
  Costmap2D map(220, 220, 0.05, 0.0, 0.0);
  GridRoute route = routeOn(map);
  for (int degrees = 0; degrees < 360; degrees += 7) {
    const GridPoint start{110.0, 110.0};
    const double angle = degrees * M_PI / 180.0;
    const GridPoint goal{110.0 + 100.0 * std::cos(angle), 110.0 + 100.0 * std::sin(angle)};
    ASSERT_TRUE(route.propagate(start, goal));
    const auto points = route.trace(goal);
    EXPECT_LT(lengthOf(points), 100.0 * 1.01) << degrees;
    for (const GridPoint& p : points) {
      const double off = std::abs((p.x - 110.0) * std::sin(angle) - (p.y - 110.0) * std::cos(angle));
      EXPECT_LT(off, 3.0) << degrees;  // 15 cm beside a line of 5 m
    }
  }
}

// A corridor 2 m wide: walls at rows 0 and 40; the costs are even, so its middle is row 20.
TEST(GridRoute, KeepsToTheMiddleOfACorridor) {
  Costmap2D map(200, 41, 0.05, 0.0, 0.0);
  fill(map, 0, 0, 200, 1, LETHAL_OBSTACLE);
  fill(map, 0, 40, 200, 41, LETHAL_OBSTACLE);
  inflate(map, 1.2);
  GridRoute route = routeOn(map);
  ASSERT_TRUE(route.propagate({10.0, 10.0}, {190.0, 30.0}));
  for (const GridPoint& p : route.trace({190.0, 30.0})) {
    if (p.x > 50.0 && p.x < 150.0) {
      EXPECT_NEAR(p.y, 20.0, 2.0);
    }
  }
}

// A wall with a door: every point stays out of the inscribed zone and, but for the door, well away from the
// wall.
TEST(GridRoute, GoesRoundAnObstacleWithClearance) {
  Costmap2D map(120, 120, 0.05, 0.0, 0.0);
  fill(map, 58, 0, 62, 80, LETHAL_OBSTACLE);
  inflate(map, 1.0);
  GridRoute route = routeOn(map);
  ASSERT_TRUE(route.propagate({20.0, 20.0}, {100.0, 20.0}));
  const auto points = route.trace({100.0, 20.0});
  double nearest = kInfinity;
  for (const GridPoint& p : points) {
    const double dx = std::max({58.0 - p.x, p.x - 61.0, 0.0}), dy = std::max(p.y - 79.0, 0.0);
    nearest = std::min(nearest, 0.05 * std::hypot(dx, dy));
  }
  EXPECT_GT(nearest, 0.45);  // [m]; the inscribed radius is 0.31
  EXPECT_LT(lengthOf(points), 200.0);
  EXPECT_GT(lengthOf(points), 2.0 * std::hypot(38.0, 60.0));  // round the wall's end
}

TEST(GridRoute, ABlockedGoalIsNotReachedButSomethingNearItIs) {
  Costmap2D map(100, 100, 0.05, 0.0, 0.0);
  fill(map, 70, 40, 80, 60, LETHAL_OBSTACLE);
  inflate(map, 0.3);
  GridRoute route = routeOn(map);
  const GridPoint goal{72.0, 50.0};
  EXPECT_FALSE(route.propagate({20.0, 50.0}, goal));
  EXPECT_FALSE(route.nearestReached(goal, 5.0).has_value());
  const auto nearest = route.nearestReached(goal, 12.0);
  ASSERT_TRUE(nearest.has_value());
  EXPECT_DOUBLE_EQ(nearest->x, 63.0);  // the wall's face is at 70; 6 cells are within 0.31 m
  EXPECT_DOUBLE_EQ(nearest->y, 50.0);
}

TEST(GridRoute, UnknownCellsByPolicy) {
  Costmap2D map(50, 50, 0.05, 0.0, 0.0);
  fill(map, 20, 0, 30, 50, NO_INFORMATION);
  EXPECT_TRUE(routeOn(map, true).propagate({10.0, 25.0}, {40.0, 25.0}));
  EXPECT_FALSE(routeOn(map, false).propagate({10.0, 25.0}, {40.0, 25.0}));
}

TEST(GridRoute, TheRobotsOwnCellIsOpened) {
  Costmap2D map(50, 50, 0.05, 0.0, 0.0);
  map.setCost(10, 10, LETHAL_OBSTACLE);
  GridRoute route = routeOn(map);
  EXPECT_FALSE(route.propagate({10.0, 10.0}, {40.0, 40.0}));
  route.open(10, 10);
  EXPECT_TRUE(route.propagate({10.0, 10.0}, {40.0, 40.0}));
}

TEST(PosesAlong, LookAlongTheRouteAndEndAsTheGoal) {
  geometry_msgs::PoseStamped goal;
  goal.header.frame_id = "map";
  goal.pose.position.x = 2.0;
  goal.pose.position.y = 2.0;
  goal.pose.orientation.z = 1.0;  // facing -x
  std::vector<geometry_msgs::Point> points(9);
  for (std::size_t i = 0; i < 9; ++i) points[i].x = points[i].y = 0.25 * double(i);
  const auto poses = posesAlong(points, goal);
  ASSERT_EQ(poses.size(), 9u);
  for (std::size_t i = 0; i < 8; ++i) EXPECT_NEAR(tf2::getYaw(poses[i].pose.orientation), M_PI / 4, 1e-12);
  EXPECT_EQ(poses.back().pose, goal.pose);
  EXPECT_EQ(poses.front().header.frame_id, "map");
}

// 93 x 63 m of rooms: walls every 6 m across, every 9 m along, each with a door.
TEST(GridRoute, AnOfficeFloorTakesLittleTime) {
  Costmap2D map(1857, 1255, 0.05, 0.0, 0.0);
  std::mt19937 random(33);
  for (unsigned int x = 120; x < 1850; x += 120) fill(map, x, 0, x + 4, 1255, LETHAL_OBSTACLE);
  for (unsigned int y = 180; y < 1250; y += 180) fill(map, 0, y, 1857, y + 4, LETHAL_OBSTACLE);
  for (unsigned int x = 0; x < 1850; x += 120) {
    for (unsigned int y = 0; y < 1250; y += 180) {
      const unsigned int door = static_cast<unsigned int>(random() % 60);
      fill(map, x, y + 50 + door, std::min(1857u, x + 4), y + 74 + door, 0);
      fill(map, x + 30 + door / 2, y, x + 54 + door / 2, y + 4, 0);
    }
  }
  inflate(map, 0.55);
  GridRoute route;
  const GridPoint start{60.0, 90.0}, goal{1790.0, 1160.0};
  std::vector<double> times;  // [ms]
  std::vector<GridPoint> points;
  for (int i = 0; i < 9; ++i) {
    const std::clock_t begun = std::clock();  // of this process: other load does not count
    route.setCosts(map.getCharMap(), 1857, 1255, true);
    ASSERT_TRUE(route.propagate(start, goal));
    points = route.trace(goal);
    times.push_back(1e3 * double(std::clock() - begun) / CLOCKS_PER_SEC);
  }
  std::sort(times.begin(), times.end());
  std::printf("1857 x 1255 cells, route of %.1f m: median %.1f ms, greatest %.1f ms\n", 0.05 * lengthOf(points),
              times[4], times.back());
  EXPECT_LT(times[4], 1000.0);  // several times what it takes: only a change of order fails
}

}  // namespace
}  // namespace move_base
