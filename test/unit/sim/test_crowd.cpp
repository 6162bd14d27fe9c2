// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "sim/contact.hpp"
#include "sim/crowd.hpp"

namespace hidwa_local_planner {
namespace sim {
namespace {

// A hall of 12 x 8 m with a wall across that leaves a door in its middle, so many cells of 0.05 m wide.
OccupancyMap hall(int door = 24) {
  OccupancyMap map = make_map(240, 160, 0.05);
  for (int row = 0; row < map.height; ++row) {
    for (int column = 0; column < map.width; ++column) {
      const bool border = row < 2 || column < 2 || row >= map.height - 2 || column >= map.width - 2;
      const bool across = column >= 119 && column < 121 && (row < 80 - door / 2 || row >= 80 + door / 2);
      if (border || across) map.cells[map.index(column, row)] = Cell::kOccupied;
    }
  }
  return map;
}

const std::vector<Eigen::Vector2d> kPlaces{{2.0, 2.0}, {2.0, 6.0}, {10.0, 2.0}, {10.0, 6.0}};

CrowdSetup setup_of(int people, std::uint64_t seed = 1) {
  CrowdSetup setup;
  setup.ways = std::make_shared<FloorWays>(hall(), kPlaces, 0.35);
  setup.people = people;
  setup.seed = seed;
  return setup;
}

std::string trace(const CrowdSetup& setup, double time) {
  Crowd crowd(setup);
  std::string text;
  for (double t = 0.0; t < time; t += 0.5) {
    crowd.advance(t, {});
    for (const Mover& m : crowd.movers())
      text += std::to_string(m.position.x()) + ' ' + std::to_string(m.position.y()) + '\n';
  }
  return text;
}

// What is promised to those who drive among them, judged from positions alone.
TEST(Crowd, NobodyExceedsTheBoundsOrWalksIntoAWall) {
  const OccupancyMap map = hall();
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    CrowdSetup setup = setup_of(14, seed);
    Crowd crowd(setup);
    constexpr double kDt = 0.01;
    std::vector<Eigen::Vector2d> before, last;
    double fastest = 0.0, hardest = 0.0, walked = 0.0;
    for (int step = 1; step <= 6000; ++step) {
      // A robot in everybody's way.
      crowd.advance(step * kDt, {{6.0 + 2.0 * std::sin(0.002 * step), 4.0}, {0.4 * std::cos(0.002 * step), 0.0}, 0.3});
      std::vector<Eigen::Vector2d> now;
      for (const Mover& m : crowd.movers()) now.push_back(m.position);
      for (std::size_t k = 0; k < now.size(); ++k) {
        ASSERT_FALSE(overlaps_occupied(map, {now[k] + Eigen::Vector2d(0.1, 0.0), now[k] + Eigen::Vector2d(0.0, 0.1),
                                             now[k] - Eigen::Vector2d(0.1, 0.0), now[k] - Eigen::Vector2d(0.0, 0.1)}))
            << seed << ' ' << step;
        if (last.empty()) continue;
        const Eigen::Vector2d v = (now[k] - last[k]) / kDt;
        fastest = std::max(fastest, v.norm());
        walked += v.norm() * kDt;
        if (!before.empty()) hardest = std::max(hardest, (v - (last[k] - before[k]) / kDt).norm() / kDt);
        EXPECT_NEAR((v - crowd.movers()[k].velocity).norm(), 0.0, 1e-9);
      }
      before = last;
      last = now;
    }
    EXPECT_LE(fastest, setup.max_speed + 1e-9);
    EXPECT_LE(hardest, setup.max_acc + 1e-6);
    EXPECT_GT(walked, 14 * 60 * 0.3);  // they do walk: 0.3 m/s on average at least
  }
}

TEST(Crowd, TheSameSeedIsTheSameCrowd) {
  EXPECT_EQ(trace(setup_of(8, 5), 20.0), trace(setup_of(8, 5), 20.0));
  EXPECT_NE(trace(setup_of(8, 5), 20.0), trace(setup_of(8, 6), 20.0));
}

TEST(Crowd, ATourLeadsThroughTheDoorStopsAndComesBack) {
  CrowdSetup setup = setup_of(1);
  setup.tours = {{0, 3}};
  setup.mean_stroll = 1e9;
  Crowd crowd(setup);
  EXPECT_NEAR((crowd.movers()[0].position - kPlaces[0]).norm(), 0.0, 1e-9);
  bool there = false, back = false, stood = false;
  for (double t = 0.0; t < 120.0; t += 0.1) {
    crowd.advance(t, {});
    const Mover& m = crowd.movers()[0];
    there = there || (m.position - kPlaces[3]).norm() < 0.8;
    stood = stood || (there && m.velocity.norm() < 0.02);
    back = back || (there && stood && (m.position - kPlaces[0]).norm() < 0.8);
  }
  EXPECT_TRUE(there);
  EXPECT_TRUE(stood);
  EXPECT_TRUE(back);
}

// Door posts do not hold back who wants to walk between them, however slowly: nobody stands before an open door.
TEST(Crowd, ADoorIsPassedBySlowPeopleToo) {
  for (const int door : {18, 20, 24}) {
    for (const double speed : {0.6, 0.9}) {
      CrowdSetup setup = setup_of(1);
      setup.ways = std::make_shared<FloorWays>(hall(door), kPlaces, 0.35);
      setup.tours = {{0, 3}};
      setup.speed = speed;
      setup.speed_deviation = 0.0;
      setup.mean_stroll = 1e9;
      Crowd crowd(setup);
      double there = 0.0;
      for (double t = 0.0; t < 60.0 && there <= 0.0; t += 0.1) {
        crowd.advance(t, {});
        if ((crowd.movers()[0].position - kPlaces[3]).norm() < 0.8) there = t;
      }
      // 9 m at that speed, a stay of 6 s at most before, and some seconds to speed up and to bend.
      EXPECT_GT(there, 0.0) << door << ", " << speed;
      EXPECT_LT(there, 9.0 / speed + 6.0 + 5.0) << door << ", " << speed;
    }
  }
}

// Somebody stands in the way for good.
TEST(Crowd, WhoYieldsKeepsAwayFromTheRobotAndWhoDoesNotWalksOn) {
  const auto nearest = [](double yielding) {
    CrowdSetup setup = setup_of(1);
    setup.tours = {{0, 1}};
    setup.yielding = yielding;
    setup.mean_stroll = 1e9;
    Crowd crowd(setup);
    const RobotSeen robot{{2.0, 4.0}, {0.0, 0.0}, 0.25};  // in the middle of the way
    double least = std::numeric_limits<double>::infinity();
    for (double t = 0.0; t < 40.0; t += 0.05) {
      crowd.advance(t, robot);
      least = std::min(least, (crowd.movers()[0].position - robot.position).norm());
    }
    return least;
  };
  EXPECT_GT(nearest(1.0), 0.55);  // 0.25 + 0.30
  EXPECT_LT(nearest(0.0), 0.40);
}

TEST(Crowd, AGroupStaysTogether) {
  const auto mean_distance = [](double in_groups) {
    CrowdSetup setup = setup_of(2, 3);
    setup.in_groups = in_groups;
    Crowd crowd(setup);
    double sum = 0.0;
    for (int k = 0; k < 1200; ++k) {
      crowd.advance(0.1 * k, {});
      sum += (crowd.movers()[0].position - crowd.movers()[1].position).norm();
    }
    return sum / 1200;
  };
  EXPECT_LT(mean_distance(1.0), 1.8);
  EXPECT_GT(mean_distance(0.0), 2.0 * mean_distance(1.0));
}

TEST(Crowd, RefusesWhatMakesNoSense) {
  EXPECT_THROW(Crowd(CrowdSetup{}), std::invalid_argument);
  EXPECT_THROW(Crowd{setup_of(500)}, std::invalid_argument);  // no room
  CrowdSetup tour = setup_of(1);
  tour.tours = {{0, 9}};
  EXPECT_THROW(Crowd{tour}, std::invalid_argument);
  EXPECT_THROW(FloorWays(hall(), {{2.0, 2.0}}, 0.35), std::invalid_argument);
  EXPECT_THROW(FloorWays(hall(), {{2.0, 2.0}, {0.0, 0.0}}, 0.35), std::invalid_argument);
}

TEST(FloorWays, EveryOtherPlaceLiesBesideTheRobotsWay) {
  const Route way{{2.0, 4.0}, {3.0, 4.0}, {4.0, 4.0}};
  const std::vector<Eigen::Vector2d> places = choose_places(hall(), {2.0, 4.0}, way, 10, 0.35, 7);
  ASSERT_EQ(places.size(), 10U);
  const OccupancyMap map = hall();
  for (std::size_t k = 0; k < places.size(); ++k) {
    double least = std::numeric_limits<double>::infinity();
    for (const Eigen::Vector2d& p : way) least = std::min(least, (p - places[k]).norm());
    EXPECT_LE(least, k % 2 == 0 ? kBeside : 20.0);
    EXPECT_FALSE(map.occupied(map.column(places[k].x()), map.row(places[k].y())));
  }
}

}  // namespace
}  // namespace sim
}  // namespace hidwa_local_planner
