// SPDX-License-Identifier: BSD-3-Clause
// Two who walk together, 0.5 to 0.8 m apart, about a robot that drives: in the scan they merge and part, and one hides
// the other.
#include <cmath>
#include <cstdio>
#include <functional>
#include <limits>
#include <ostream>
#include <vector>

#include <gtest/gtest.h>

#include "support/effort.hpp"
#include "support/office_scans.hpp"
#include "support/scan_world.hpp"
#include "tracking/tracker.hpp"

namespace hidwa_local_planner::test {
namespace {

// Where one of them is from the middle between the two, outwards and onwards [half gaps]; the other is opposite.
struct Side {
  double outwards = 0.0, onwards = 0.0;
};

struct Case {
  const char* name;
  bool legs;
  Side (*side)(double time);
};
void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }

Side one_behind_the_other(double /*time*/) { return {1.0, 0.0}; }
Side side_by_side(double /*time*/) { return {0.0, 1.0}; }
Side round_each_other(double time) { return {std::cos(0.5 * time), std::sin(0.5 * time)}; }
Side near_and_apart(double time) { return {0.15, 1.3 + 0.3 * std::sin(0.4 * time)}; }

constexpr double kBodyRadius = 0.22;  // [m]
constexpr double kMiddle = 7.0;       // of the hall, x and y [m]

// Two pairs on circles about the middle of the hall, 2.8 and 4.2 m away from it.
ScanWorld pairs(const Case& c, double gap) {
  ScanWorld world = hall();
  world.laser.noise = 0.02;
  for (int pair = 0; pair < 2; ++pair) {
    for (const double sign : {-0.5, 0.5}) {
      Walker walker;
      walker.legs = c.legs;
      walker.radius = kBodyRadius;
      const double radius = 2.8 + 1.4 * pair, speed = 0.8 + 0.3 * pair, start = 2.5 * pair, off = sign * gap;
      walker.at = [=](double time) {
        const Side side = c.side(time);
        const double angle = start + speed * time / radius + side.onwards * off / radius;
        const double away = radius + side.outwards * off;
        return Point(kMiddle + away * std::cos(angle), kMiddle + away * std::sin(angle));
      };
      world.walkers.push_back(walker);
    }
  }
  return world;
}

// Of what is told of somebody, against who is nearest to it.
struct Tally {
  int told = 0, misplaced = 0, misjudged = 0;  // by more than three deviations of the place, of the velocity
  int seen = 0, followed = 0;                  // people of whom half or more is in view

  void add(const ScanWorld& world, const ScanRobot& robot, const Tracker& tracker, const std::vector<int>& beams,
           double time) {
    std::vector<bool> known(world.walkers.size());
    for (const MovingObstacleEstimate& o : tracker.obstacles()) {
      std::size_t nearest = 0;
      double off = std::numeric_limits<double>::infinity();
      for (std::size_t w = 0; w < world.walkers.size(); ++w) {
        const double away = (o.position - robot.in_odometry(world.walkers[w].at(time))).norm();
        if (away >= off) continue;
        off = away;
        nearest = w;
      }
      known[nearest] = true;
      const double wrong = (o.velocity - robot.turned(world.walkers[nearest].velocity(time))).norm();
      ++told;
      misplaced += off > 3.0 * o.position_deviation;
      misjudged += wrong > 3.0 * o.velocity_deviation;
    }
    for (std::size_t w = 0; w < known.size(); ++w) {
      const double away = (world.walkers[w].at(time) - Point(robot.truth().x, robot.truth().y)).norm();
      if (beams[w] < std::max(4.0, world.half_of(world.walkers[w], away)) || away > 5.0) continue;
      ++seen;
      followed += known[w];
    }
  }
};

class Pairs : public testing::TestWithParam<Case> {};

TEST_P(Pairs, DeviationsHold) {
  Tally tally;
  for (const double gap : {0.5, 0.7}) {
    const ScanWorld world = pairs(GetParam(), gap);
    ScanRobot robot({{6.3, 6.3}, {7.7, 6.3}, {7.7, 7.7}, {6.3, 7.7}}, 0.5, 1.0);
    Tracker tracker{TrackerSettings()};
    Random random(5);
    const double step = 1.0 / world.laser.rate, duration = effort(40.0, 160.0);
    for (double time = 1.0; time < 1.0 + duration; time += step) {
      for (int i = 0; i < 5; ++i) robot.advance(step / 5.0);
      std::vector<int> beams;
      tracker.update(world.scan(time, robot.truth(), robot.odometry(), random, beams));
      tally.add(world, robot, tracker, beams, time);
    }
  }
  const double misplaced = static_cast<double>(tally.misplaced) / tally.told,
               misjudged = static_cast<double>(tally.misjudged) / tally.told,
               followed = static_cast<double>(tally.followed) / tally.seen;
  std::printf("%d told: beyond three deviations %.2f %% of the places, %.2f %% of the velocities; followed %.1f %%\n",
              tally.told, 100.0 * misplaced, 100.0 * misjudged, 100.0 * followed);
  EXPECT_LT(misplaced, 0.01);  // of a normal error exp(-4.5) = 1.1 % are
  EXPECT_LT(misjudged, 0.01);
  EXPECT_GT(followed, 0.95);
}

INSTANTIATE_TEST_SUITE_P(Together, Pairs,
                         testing::Values(Case{"bodies, one behind the other", false, one_behind_the_other},
                                         Case{"bodies side by side", false, side_by_side},
                                         Case{"bodies round each other", false, round_each_other},
                                         Case{"bodies near and apart", false, near_and_apart},
                                         Case{"legs, one behind the other", true, one_behind_the_other},
                                         Case{"legs side by side", true, side_by_side},
                                         Case{"legs round each other", true, round_each_other},
                                         Case{"legs near and apart", true, near_and_apart}));

}  // namespace
}  // namespace hidwa_local_planner::test
