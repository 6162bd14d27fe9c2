// SPDX-License-Identifier: BSD-3-Clause
#include "sim/grid_route.hpp"

#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "random_scene.hpp"
#include "sim/regions.hpp"

namespace hidwa_local_planner {
namespace sim {
namespace {

/// Price of a route, cell by cell as the search counts it: each step by the clearance of its end nearer to
/// the start.
double price(const Route& route, const DistanceField& field, const RouteClearance& clearance) {
  double sum = 0.0;
  for (std::size_t i = 0; i + 1 < route.size(); ++i) {
    const double cost = inflation_cost(field.at(route[i].x(), route[i].y()), clearance);
    sum += (route[i + 1] - route[i]).norm() * (1.0 + clearance.weight * cost);
  }
  return sum;
}

/// The slow and obvious way: prices are lowered over the whole grid until none changes.
std::vector<double> naive_prices(const OccupancyMap& map, const DistanceField& field, const RouteClearance& clearance,
                                 std::size_t goal) {
  std::vector<double> prices(map.cells.size(), std::numeric_limits<double>::infinity());
  prices[goal] = 0.0;
  for (bool changed = true; changed;) {
    changed = false;
    for (int row = 0; row < map.height; ++row) {
      for (int column = 0; column < map.width; ++column) {
        const double distance = field.at_cell(column, row);
        if (distance < clearance.robot_radius || map.index(column, row) == goal) continue;
        for (int dr = -1; dr <= 1; ++dr) {
          for (int dc = -1; dc <= 1; ++dc) {
            if (!map.inside(column + dc, row + dr)) continue;
            const double step = map.resolution * std::hypot(dc, dr);
            const double through = prices[map.index(column + dc, row + dr)] +
                                   step * (1.0 + clearance.weight * inflation_cost(distance, clearance));
            if (through >= prices[map.index(column, row)]) continue;
            prices[map.index(column, row)] = through;
            changed = true;
          }
        }
      }
    }
  }
  return prices;
}

TEST(GridRoute, IsAsCheapAsTheNaiveTwin) {
  Random random(5);
  int found = 0;
  RouteClearance clearance;
  clearance.robot_radius = 0.07;
  for (int scene = 0; scene < 20; ++scene) {
    const OccupancyMap map = random_map(random, 40, 30, 0.06);
    const DistanceField field = DistanceField::to_obstacles(map);
    const int column = 20;
    const int row = 15;
    const GridRoute routes(map, clearance, {map.center_x(column), map.center_y(row)});
    const std::vector<double> prices = naive_prices(map, field, clearance, map.index(column, row));
    for (int r = 0; r < map.height; r += 3) {
      for (int c = 0; c < map.width; c += 3) {
        if (!std::isfinite(prices[map.index(c, r)])) continue;
        const Route route = routes.from({map.center_x(c), map.center_y(r)});
        ASSERT_FALSE(route.empty());
        ASSERT_NEAR(price(route, field, clearance), prices[map.index(c, r)], 1e-4) << scene << " " << c << " " << r;
        ++found;
      }
    }
  }
  EXPECT_GT(found, 500);
}

TEST(GridRoute, MadeForOneStartGivesTheSameWay) {
  Random random(6);
  int found = 0;
  RouteClearance clearance;
  clearance.robot_radius = 0.07;
  for (int scene = 0; scene < 200; ++scene) {
    const OccupancyMap map = random_map(random, 40, 30, 0.06);
    const Eigen::Vector2d goal(map.center_x(20), map.center_y(15));
    const Eigen::Vector2d start{uniform(random, -1.5, 0.9), uniform(random, 0.5, 2.4)};  // now and then outside
    const Route all = GridRoute(map, clearance, goal).from(start);
    const Route one = GridRoute(map, clearance, goal, start).from(start);
    ASSERT_EQ(all.size(), one.size()) << scene;
    for (std::size_t k = 0; k < all.size(); ++k) ASSERT_EQ(all[k], one[k]) << scene;
    found += all.size() > 5;
  }
  EXPECT_GT(found, 50);
}

TEST(GridRoute, SaysWhenThereIsNoWay) {
  OccupancyMap map = make_map(60, 60, 0.05);
  for (int row = 0; row < 60; ++row) map.cells[map.index(30, row)] = Cell::kOccupied;
  const GridRoute routes(map, RouteClearance(), {0.75, 1.5});
  EXPECT_TRUE(routes.from({2.5, 1.5}).empty());
  EXPECT_FALSE(routes.from({0.5, 0.5}).empty());
  EXPECT_TRUE(GridRoute(map, RouteClearance(), {99.0, 99.0}).from({0.5, 0.5}).empty());
}

TEST(GridRoute, ServesAStartTooNearToAWall) {
  OccupancyMap map = make_map(60, 60, 0.05);
  for (int row = 0; row < 60; ++row) map.cells[map.index(0, row)] = Cell::kOccupied;
  const GridRoute routes(map, RouteClearance(), {2.0, 1.5});
  EXPECT_FALSE(routes.from({0.2, 1.5}).empty());
}

TEST(GridRoute, ResamplingKeepsTheLine) {
  const Route route{{0, 0}, {1, 0}, {1, 0.55}};
  const Route even = resampled(route, 0.1);
  // 1.55 m: points at 0.0, 0.1, ..., 1.5 and the end.
  ASSERT_EQ(even.size(), 17u);
  EXPECT_NEAR(even[12].x(), 1.0, 1e-9);
  EXPECT_NEAR(even[12].y(), 0.2, 1e-9);
  EXPECT_NEAR(length(even), 1.55, 1e-9);
  EXPECT_TRUE(resampled({}, 0.1).empty());
}

TEST(Office, DirectRouteIsLongEnoughAndRunsThroughRegions) {
  const OccupancyMap map = load_map(HIDWA_MAPS_DIR "/office.yaml");
  const RegionsFile file = load_regions(HIDWA_MAPS_DIR "/office_regions.yaml");
  ASSERT_TRUE(file.start && file.goal);
  ASSERT_GE(file.regions.size(), 3u);
  // However much or little a planner minds walls.
  for (const double weight : {0.0, 1.0, 4.0, 10.0}) {
    RouteClearance clearance;
    clearance.weight = weight;
    const GridRoute routes(map, clearance, {file.goal->x, file.goal->y});
    const Route route = routes.from({file.start->x, file.start->y});
    EXPECT_GE(length(route), 60.0) << weight;
    EXPECT_LE(length(route), 100.0) << weight;
    RegionCounter counter(file.regions);
    for (const Eigen::Vector2d& p : route) counter.update(transformed(circle_polygon(0.3), {p.x(), p.y(), 0.0}));
    EXPECT_GE(counter.crossed(), 3) << weight;
  }
}

TEST(Office, EachRegionCanBePassed) {
  // With the regions walled up there is still a way, 0.15 m wider on both sides than the robot.
  OccupancyMap map = load_map(HIDWA_MAPS_DIR "/office.yaml");
  const RegionsFile file = load_regions(HIDWA_MAPS_DIR "/office_regions.yaml");
  const DistanceField regions = DistanceField::to_regions(map, file.regions);
  for (int row = 0; row < map.height; ++row) {
    for (int column = 0; column < map.width; ++column) {
      if (regions.at_cell(column, row) == 0.0) map.cells[map.index(column, row)] = Cell::kOccupied;
    }
  }
  RouteClearance clearance;
  clearance.robot_radius = 0.45;
  const GridRoute routes(map, clearance, {file.goal->x, file.goal->y});
  EXPECT_FALSE(routes.from({file.start->x, file.start->y}).empty());
}

}  // namespace
}  // namespace sim
}  // namespace hidwa_local_planner
