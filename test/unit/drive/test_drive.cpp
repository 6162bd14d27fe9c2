// SPDX-License-Identifier: BSD-3-Clause
#include "drive/drive.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "drive/outline.hpp"
#include "hidwa_local_planner/critics/built_in.hpp"
#include "sim/scripted_operator.hpp"

namespace hidwa_local_planner {
namespace drive {
namespace {

void wall(sim::OccupancyMap& map, double x0, double y0, double x1, double y1) {
  for (int row = map.row(y0); row <= map.row(y1); ++row) {
    for (int column = map.column(x0); column <= map.column(x1); ++column) {
      if (map.inside(column, row)) map.cells[map.index(column, row)] = sim::Cell::kOccupied;
    }
  }
}

// A corridor 2 m wide along x, 10 m long, closed all round; `door`: the width of a gap in a wall across it
// [m].
DriveSetup corridor(double door = 2.0) {
  auto map = std::make_shared<sim::OccupancyMap>(sim::make_map(208, 48, 0.05, -0.2, -1.2));
  wall(*map, -0.2, -1.2, 10.2, -1.01);
  wall(*map, -0.2, 1.01, 10.2, 1.2);
  wall(*map, -0.2, -1.2, -0.01, 1.2);
  wall(*map, 10.01, -1.2, 10.2, 1.2);
  if (door < 2.0) {
    wall(*map, 5.01, -1.2, 5.19, -0.5 * door - 0.01);
    wall(*map, 5.01, 0.5 * door + 0.01, 5.19, 1.2);
  }
  DriveSetup setup;
  setup.ground = std::make_shared<Ground>(map);
  setup.start = {1.0, 0.0, 0.0};
  setup.goal = {9.0, 0.0, 0.0};
  setup.footprint = sim::circle_polygon(0.28, 24);
  setup.outline = circle_outline(0.30, 0.01);
  setup.time_limit = 60.0;
  return setup;
}

// Steers left when `after` [m] were driven, for so long.
std::shared_ptr<sim::Operator> steering_left(double after, double seconds, double stick = 0.6) {
  sim::ScriptEntry entry;
  entry.after_m = after;
  entry.for_s = seconds;
  entry.stick = {stick, 0.0};
  return std::make_shared<sim::ScriptedOperator>(std::vector<sim::ScriptEntry>{entry});
}

void expect_same(const DriveResult& a, const DriveResult& b) {
  EXPECT_EQ(a.ending, b.ending);
  EXPECT_EQ(a.duration, b.duration);
  EXPECT_EQ(a.length, b.length);
  EXPECT_EQ(a.clearance, b.clearance);
  EXPECT_EQ(a.agreement, b.agreement);
  ASSERT_EQ(a.samples.size(), b.samples.size());
  for (std::size_t i = 0; i < a.samples.size(); ++i) {
    ASSERT_EQ(a.samples[i].pose.x, b.samples[i].pose.x) << i;
    ASSERT_EQ(a.samples[i].pose.theta, b.samples[i].pose.theta) << i;
    ASSERT_TRUE(a.samples[i].command == b.samples[i].command) << i;
    ASSERT_EQ(a.samples[i].state, b.samples[i].state) << i;
  }
}

TEST(Drive, ArrivesAlongACorridor) {
  const DriveResult result = drive(corridor());
  EXPECT_EQ(result.ending, Ending::arrived);
  EXPECT_TRUE(result.arrived);
  EXPECT_EQ(result.contacts, 0);
  EXPECT_EQ(result.failures, 0u);
  EXPECT_NEAR(result.length, 8.0, 0.4);
  EXPECT_LT(result.duration, 1.15 * 8.0 / 0.5);
  EXPECT_EQ(result.interventions, 0);
  EXPECT_EQ(result.agreement, 1.0);
  EXPECT_EQ(result.samples.size(), result.cycles);
  EXPECT_GT(result.clearance, 0.5);
  EXPECT_LE(result.clearance, 0.74);
  EXPECT_GT(result.planning_time, 0.0);
}

TEST(Drive, EqualSetupsGiveEqualBits) {
  DriveSetup setup = corridor(1.2);
  setup.laser.noise = 0.02;
  setup.odometry_noise = {0.05, 0.05, 0.5};
  setup.person = steering_left(2.0, 1.0);
  const DriveResult first = drive(setup);
  setup.person = steering_left(2.0, 1.0);
  const DriveResult second = drive(setup);
  EXPECT_TRUE(first.arrived);
  expect_same(first, second);
}

// A Jackal's accelerations: in a latency and a period its velocity changes by 1 m/s, five times the tolerance. Somebody
// steers, a wall ends the way, and odometry slips.
TEST(Drive, OdometryThatLagsIsNoDisagreement) {
  DriveSetup setup = corridor(1.0);
  setup.limits.max_vel_x = setup.parameters.max_vel_x = 2.0;
  setup.limits.max_vel_theta = setup.parameters.max_vel_theta = 4.0;
  setup.limits.acc_lim_x = setup.limits.decel_lim_x = setup.parameters.acc_lim_x = 10.0;
  setup.limits.acc_lim_theta = setup.limits.decel_lim_theta = setup.parameters.acc_lim_theta = 20.0;
  setup.limits.latency = setup.parameters.control_latency = 0.05;
  setup.odometry_noise = {0.01, 0.01, 0.5};
  setup.person = steering_left(2.0, 1.0, 1.0);
  int cycles = 0, lagging = 0;
  const DriveResult result = drive(setup, [&](const Cycle& cycle) {
    const Situation& s = cycle.situation;
    EXPECT_TRUE(cycle.decision.reference == s.last_command) << cycle.time << " s: odometry " << s.velocity.v;
    ++cycles;
    lagging += std::abs(s.velocity.v - s.last_command.v) > 0.2;  // more than is tolerated
  });
  EXPECT_TRUE(result.arrived);
  EXPECT_EQ(result.contacts, 0);
  EXPECT_GT(cycles, 60);
  EXPECT_GT(lagging, 5);
}

TEST(Drive, EachSeedMatters) {
  DriveSetup setup = corridor(1.2);
  setup.laser.noise = 0.02;
  setup.odometry_noise = {0.05, 0.05, 0.5};
  const auto lethal_cells = [](const DriveSetup& driven) {
    long sum = 0;
    drive(driven, [&sum](const Cycle& cycle) {
      const std::size_t count = cycle.grid.cell_count();
      sum += std::count(cycle.grid.costs, cycle.grid.costs + count, cost::kLethal);
    });
    return sum;
  };
  DriveSetup other = setup;
  other.laser_seed = 77;
  EXPECT_NE(lethal_cells(other), lethal_cells(setup));
  other = setup;
  other.odometry_seed = 77;
  EXPECT_NE(drive(other).length, drive(setup).length);
}

TEST(Drive, AGroundAndARouteMayBeSharedBetweenDrives) {
  DriveSetup setup = corridor(1.2);
  const DriveResult own = drive(setup);
  setup.route = std::make_shared<sim::GridRoute>(*setup.ground->map(),
                                                 navfn_clearance(Footprint(setup.outline).inscribed_radius(), 3.0),
                                                 Eigen::Vector2d(9.0, 0.0));
  expect_same(own, drive(setup));
}

TEST(Drive, TheOperatorsPartIsAddedUp) {
  DriveSetup setup = corridor();
  setup.person = steering_left(2.0, 4.0, 0.8);  // into the wall
  const DriveResult result = drive(setup);
  EXPECT_TRUE(result.arrived);
  EXPECT_EQ(result.contacts, 0);
  EXPECT_EQ(result.interventions, 1);
  EXPECT_NEAR(result.operator_active, 4.0, 0.11);
  EXPECT_GT(result.agreement, 0.0);
  EXPECT_LT(result.agreement, 1.0);
  const auto highest = std::max_element(result.samples.begin(), result.samples.end(),
                                        [](const auto& a, const auto& b) { return a.pose.y < b.pose.y; });
  EXPECT_GT(highest->pose.y, 0.1);  // left of the way
  EXPECT_GT(result.omega_change, drive(corridor()).omega_change);
}

// What the sums say, from the samples.
TEST(Drive, FiguresAgreeWithTheSamples) {
  DriveSetup setup = corridor(1.2);
  setup.person = steering_left(1.5, 2.0);
  const DriveResult result = drive(setup);
  double v = 0.0, omega = 0.0, active = 0.0, clearance = 1.0;
  std::size_t failures = 0, brakes = 0;
  for (std::size_t i = 0; i < result.samples.size(); ++i) {
    const DriveSample& now = result.samples[i];
    if (i > 0) v += std::abs(now.command.v - result.samples[i - 1].command.v);
    if (i > 0) omega += std::abs(now.command.omega - result.samples[i - 1].command.omega);
    const bool steered = now.state == OperatorStateId::shared || now.state == OperatorStateId::blocked;
    active += steered ? 0.05 : 0.0;
    failures += now.outcome == Outcome::fail;
    brakes += now.outcome == Outcome::brake;
    clearance = std::min(clearance, setup.ground->clearance(setup.footprint, now.pose, 1.0));
  }
  const auto changes = static_cast<double>(result.samples.size() - 1);
  EXPECT_NEAR(result.v_change, v / changes, 1e-12);
  EXPECT_NEAR(result.omega_change, omega / changes, 1e-12);
  EXPECT_NEAR(result.operator_active, active, 1e-9);
  EXPECT_EQ(result.failures, failures);
  EXPECT_EQ(result.brakes, brakes);
  EXPECT_NEAR(result.clearance, clearance, 1e-9);
}

TEST(Drive, TheObserverSeesEveryCycleAsThePlannerDid) {
  DriveSetup setup = corridor(1.2);
  setup.person = steering_left(1.5, 1.0);
  Planner twin(critics::built_in());  // decides the same from what is seen
  ASSERT_TRUE(twin.configure(setup.parameters).empty());
  twin.set_footprint(setup.outline);
  Twist2 last;
  std::size_t seen = 0;
  const DriveResult result = drive(setup, [&](const Cycle& cycle) {
    const Decision& decision = twin.plan(cycle.situation, cycle.grid, cycle.intent);
    EXPECT_TRUE(decision.command == cycle.decision.command);
    EXPECT_EQ(decision.outcome, cycle.decision.outcome);
    EXPECT_TRUE(cycle.situation.last_command == last);
    EXPECT_NEAR(cycle.situation.period, 0.05, 1e-12);
    EXPECT_NEAR(cycle.time, 0.05 * static_cast<double>(seen), 1e-9);
    EXPECT_EQ(cycle.planner.candidates().size(), cycle.decision.candidates);
    last = cycle.decision.outcome == Outcome::fail ? Twist2{} : cycle.decision.command;
    ++seen;
  });
  EXPECT_EQ(seen, result.cycles);
}

// The costmap lies in the odometry's frame, in which the robot starts at the origin; lethal cells are where
// walls are.
TEST(Drive, TheCostmapShowsTheWallsWhereTheyAre) {
  DriveSetup setup = corridor(1.2);
  setup.start = {1.0, 0.0, 0.3};
  setup.odometry_noise = {0.0, 0.02, 0.5};
  const sim::OccupancyMap& map = *setup.ground->map();
  std::size_t lethal = 0, off = 0;
  drive(setup, [&](const Cycle& cycle) {
    const sim::Pose odometry = cycle.world.odometry().pose();
    const sim::Pose to_map = sim::compose(cycle.world.pose(), sim::inverse(odometry));
    for (int j = 0; j < cycle.grid.size_y; j += 3) {
      for (int i = 0; i < cycle.grid.size_x; i += 3) {
        if (cycle.grid.at({i, j}) != cost::kLethal) continue;
        const Point centre = cycle.grid.centre({i, j});
        const sim::Pose place = sim::compose(to_map, {centre.x(), centre.y(), 0.0});
        bool near = false;
        for (int row = -2; row <= 2; ++row) {
          for (int column = -2; column <= 2; ++column) {
            near = near || map.occupied(map.column(place.x) + column, map.row(place.y) + row);
          }
        }
        ++lethal;
        off += !near;
      }
    }
  });
  EXPECT_GT(lethal, 1000u);
  EXPECT_LT(static_cast<double>(off), 0.01 * static_cast<double>(lethal));
}

TEST(Drive, AGapTooNarrowEndsThePatience) {
  DriveSetup setup = corridor(0.5);
  // A route that knows nothing of the robot's width.
  setup.route = std::make_shared<sim::GridRoute>(*setup.ground->map(), sim::RouteClearance{0.0, 5.0, 0.0},
                                                 Eigen::Vector2d(9.0, 0.0));
  setup.patience = 4.0;
  const DriveResult result = drive(setup);
  EXPECT_EQ(result.ending, Ending::given_up);
  EXPECT_FALSE(result.arrived);
  EXPECT_EQ(result.contacts, 0);
  EXPECT_GE(result.failures, 4u * 20u);
  EXPECT_EQ(result.samples.back().outcome, Outcome::fail);
  EXPECT_TRUE(result.samples.back().command == Twist2{});
  EXPECT_LT(result.samples.back().pose.x, 5.0);
}

TEST(Drive, WhereThereIsNoWayThereIsNoPlan) {
  const DriveResult result = drive(corridor(0.4));
  EXPECT_EQ(result.ending, Ending::no_plan);
  EXPECT_EQ(result.duration, 0.0);
  EXPECT_TRUE(result.samples.empty());
}

TEST(Drive, EndsAtItsTimeLimit) {
  DriveSetup setup = corridor();
  setup.time_limit = 3.0;
  const DriveResult result = drive(setup);
  EXPECT_EQ(result.ending, Ending::out_of_time);
  EXPECT_NEAR(result.duration, 3.0, 1e-9);
  EXPECT_EQ(result.cycles, 60u);
}

TEST(Drive, SamplesAreLeftOutOnDemand) {
  DriveSetup setup = corridor();
  const DriveResult with = drive(setup);
  setup.keep_samples = false;
  const DriveResult without = drive(setup);
  EXPECT_TRUE(without.samples.empty());
  EXPECT_EQ(with.length, without.length);
  EXPECT_EQ(with.omega_change, without.omega_change);
}

TEST(Drive, RegionsAreCountedAndDoNotBendTheWay) {
  DriveSetup setup = corridor();
  setup.regions.push_back({"wet", {{4.0, -0.5}, {5.0, -0.5}, {5.0, 0.5}, {4.0, 0.5}}});
  setup.regions.push_back({"far", {{4.0, 5.0}, {5.0, 5.0}, {5.0, 6.0}}});
  const DriveResult result = drive(setup);
  EXPECT_EQ(result.regions_crossed, 1);
  EXPECT_EQ(result.length, drive(corridor()).length);
}

TEST(Drive, RatesAndPhaseAreKept) {
  DriveSetup setup = corridor();
  setup.rates.control = 10.0;
  setup.time_limit = 2.0;
  EXPECT_EQ(drive(setup).cycles, 20u);
  // A costmap that is never updated again but once stays where it was first.
  setup.rates = Rates();
  setup.rates.costmap = 0.1;
  setup.rates.costmap_phase = 1.0;
  std::vector<double> moved;
  double origin = 1e9;
  drive(setup, [&](const Cycle& cycle) {
    if (cycle.grid.origin_x != origin) moved.push_back(cycle.time);
    origin = cycle.grid.origin_x;
  });
  ASSERT_EQ(moved.size(), 2u);
  EXPECT_NEAR(moved[1], 1.0, 1e-9);
}

TEST(Drive, RefusesWhatMakesNoSense) {
  DriveSetup setup = corridor();
  setup.ground = nullptr;
  EXPECT_THROW(drive(setup), std::invalid_argument);
  setup = corridor();
  setup.outline.clear();
  EXPECT_THROW(drive(setup), std::invalid_argument);
  setup = corridor();
  setup.parameters.sim_time = -1.0;
  EXPECT_THROW(drive(setup), std::invalid_argument);
  setup = corridor();
  setup.start = {0.0, 0.0, 0.0};  // in the wall
  EXPECT_THROW(drive(setup), std::invalid_argument);
}

TEST(Drive, EveryEndingHasAName) {
  EXPECT_STREQ(to_string(Ending::arrived), "arrived");
  EXPECT_STREQ(to_string(Ending::given_up), "given up");
  EXPECT_STREQ(to_string(Ending::no_plan), "no plan");
  EXPECT_STREQ(to_string(Ending::out_of_time), "out of time");
}

}  // namespace
}  // namespace drive
}  // namespace hidwa_local_planner
