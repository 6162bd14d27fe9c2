// SPDX-License-Identifier: BSD-3-Clause
// The tracker on a robot that drives and turns, against what is so.
#include <cstdio>

#include <gtest/gtest.h>

#include "support/effort.hpp"
#include "support/office_scans.hpp"
#include "support/tracker_score.hpp"

namespace hidwa_local_planner::test {
namespace {

void show(const char* name, const TrackerScore& s) {
  std::printf(
      "%s: %d sights, %.1f %% followed; found after %.2f s (median), %.2f s (90 %%), %zu times; velocity %.3f m/s rms, "
      "95 %% of the first second and changes below %.2f; place %.3f m rms; squared errors over variances %.2f, %.2f; "
      "false tracks %zu, false points %d\n",
      name, s.visible, 100.0 * s.followed / std::max(1, s.visible), share_below(s.delays, 0.5),
      share_below(s.delays, 0.9), s.delays.size(), rms(s.steady), share_below(s.early, 0.95), rms(s.places),
      mean(s.place_ratios), mean(s.speed_ratios), s.false_ids.size(), s.false_points);
}

struct Case {
  const char* name;
  double noise;
  bool legs;
  double radius;
  double speed;
};

// Four who walk to and fro around a robot that drives in a square, at 1.5 to 5 m.
TrackerScore among_walkers(const Case& c) {
  ScanWorld world = hall();
  world.laser.noise = c.noise;
  const auto add = [&](const Point& a, const Point& b, double speed, double start) {
    Walker walker;
    walker.at = to_and_fro(a, b, speed, start);
    walker.legs = c.legs;
    walker.radius = c.radius;
    world.walkers.push_back(walker);
  };
  add({4.2, 4.4}, {9.3, 4.0}, c.speed, 0.0);
  add({10.4, 4.2}, {10.0, 10.0}, 0.9 * c.speed, 3.0);
  add({9.3, 10.2}, {4.5, 10.8}, 1.05 * c.speed, 5.0);
  add({3.0, 10.0}, {3.6, 4.5}, c.speed, 8.0);
  ScanRobot robot({{6.0, 6.0}, {8.0, 6.0}, {8.0, 8.0}, {6.0, 8.0}}, 0.5, 1.0);
  robot.slip_x = robot.slip_theta = 0.02;
  TrackerDrive drive(world, robot, TrackerSettings(), 7);
  const TrackerScore score = drive.run(80.0);
  show(c.name, score);
  return score;
}

class AmongWalkers : public testing::TestWithParam<Case> {};

TEST_P(AmongWalkers, KnowsWhereTheyAreAndWhereTheyGo) {
  const TrackerScore score = among_walkers(GetParam());
  EXPECT_GT(score.visible, 3000);
  EXPECT_GT(score.followed, 0.94 * score.visible);
  EXPECT_LE(rms(score.steady), 0.15);
  EXPECT_LE(rms(score.places), 0.1);
  EXPECT_LE(share_below(score.uncovered, 0.95), 0.12);  // the disc of k deviations around it holds the body
  EXPECT_TRUE(score.false_ids.empty());
  EXPECT_EQ(score.false_points, 0);
  EXPECT_LE(share_below(score.delays, 0.5), 0.4);
}

INSTANTIATE_TEST_SUITE_P(Walkers, AmongWalkers,
                         testing::Values(Case{"bodies, 0.01 m of noise", 0.01, false, 0.25, 1.0},
                                         Case{"bodies, 0.03 m of noise", 0.03, false, 0.25, 1.0},
                                         Case{"legs, 0.01 m of noise", 0.01, true, 0.25, 1.0},
                                         Case{"legs, 0.03 m of noise", 0.03, true, 0.25, 1.0},
                                         Case{"cylinders at 0.9 m/s", 0.01, false, 0.5, 0.9}));

// A person steps out from behind a wall into space that the robot has seen: 0.4 s after four beams meet him he is
// found.
TEST(TrackerDrive, FindsWhoStepsOutWithin04s) {
  std::vector<double> delays;
  for (int trial = 0; trial < 24; ++trial) {
    ScanWorld world = hall();
    world.laser.noise = trial % 2 == 0 ? 0.01 : 0.03;
    const double y = 5.0 + 0.35 * (trial % 8);
    world.walls.push_back({{2.0, y - 0.5}, {5.0, y - 0.5}});  // he comes from behind it
    Walker walker;
    const double speed = 0.8 + 0.1 * (trial % 7);
    walker.legs = trial % 3 == 0;
    walker.at = [=](double time) { return Point(2.5 + speed * std::max(0.0, time - 3.0), y); };
    world.walkers.push_back(walker);
    ScanRobot robot({{6.0, 2.0}, {6.5, 3.0}, {6.0, 3.5}, {5.5, 3.0}}, 0.3, 0.5);
    TrackerDrive drive(world, robot, TrackerSettings(), 30 + static_cast<std::uint64_t>(trial));
    drive.near = 0.5;
    const TrackerScore score = drive.run(3.0 + 5.5 / speed);
    ASSERT_FALSE(score.delays.empty()) << trial;
    delays.push_back(score.delays.front());
  }
  std::printf("found after %.2f s (median), %.2f s (all)\n", share_below(delays, 0.5), share_below(delays, 1.0));
  EXPECT_LE(share_below(delays, 0.9), 0.4 + 1e-9);
  EXPECT_LE(share_below(delays, 1.0), 0.5 + 1e-9);
}

// Ten minutes each (in the long form) through an office where nothing moves.
TEST(TrackerDrive, MakesNobodyOutOfAnOffice) {
  struct Office {
    double noise, slip;
  };
  for (const Office& o : {Office{0.01, 0.0}, Office{0.03, 0.02}, Office{0.01, -0.02}}) {
    ScanWorld world = office();
    world.laser.noise = o.noise;
    ScanRobot robot(office_round(), 0.5, 1.0);
    robot.slip_x = robot.slip_theta = o.slip;
    TrackerDrive drive(world, robot, TrackerSettings(), 2);
    const TrackerScore score = drive.run(effort(30.0, 600.0));
    std::printf("noise %.2f m, slip %.2f: %zu false tracks, %d false points\n", o.noise, o.slip, score.false_ids.size(),
                score.false_points);
    EXPECT_LE(score.false_ids.size(), 1u);
    EXPECT_LE(score.false_points, 20);
  }
}

// The deviations are for a planner that allows for three of them: errors beyond must be rare. Those who walk to and fro
// turn round at once, which breaks any bound of acceleration; these walk on.
TEST(TrackerDrive, DeviationsHold) {
  for (bool legs : {false, true}) {
    ScanWorld world = hall();
    world.laser.noise = 0.02;
    for (int i = 0; i < 3; ++i) {  // on circles about the hall's middle
      Walker walker;
      const double radius = 3.0 + 1.0 * i, speed = 0.7 + 0.3 * i, start = 2.0 * i;
      walker.at = [=](double time) {
        const double a = start + speed * time / radius;
        return Point(7.0 + radius * std::cos(a), 7.0 + radius * std::sin(a));
      };
      walker.legs = legs;
      world.walkers.push_back(walker);
    }
    ScanRobot robot({{6.3, 6.3}, {7.7, 6.3}, {7.7, 7.7}, {6.3, 7.7}}, 0.5, 1.0);
    TrackerDrive drive(world, robot, TrackerSettings(), 5);
    const TrackerScore score = drive.run(80.0);
    show(legs ? "legs on circles" : "bodies on circles", score);
    ASSERT_GT(score.place_ratios.size(), 1500u);
    const auto beyond = [](const std::vector<double>& ratios) {
      return static_cast<double>(std::count_if(ratios.begin(), ratios.end(), [](double r) { return r > 9.0; })) /
             static_cast<double>(ratios.size());
    };
    EXPECT_LT(mean(score.place_ratios), 2.5);  // 2: exact; less: careful
    EXPECT_LT(mean(score.speed_ratios), 2.5);
    EXPECT_GT(mean(score.speed_ratios), 0.1);     // and of some use
    EXPECT_LT(beyond(score.place_ratios), 0.02);  // of a normal error exp(-4.5) = 1.1 % are
    EXPECT_LT(beyond(score.speed_ratios), 0.02);
  }
}

}  // namespace
}  // namespace hidwa_local_planner::test
