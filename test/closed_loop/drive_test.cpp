// SPDX-License-Identifier: BSD-3-Clause
// Whole drives through the office without ROS, in the default profile.
#include <algorithm>
#include <cmath>
#include <memory>

#include <gtest/gtest.h>

#include "drive/drive.hpp"
#include "sim/avoiding_operator.hpp"
#include "sim/scripted_operator.hpp"
#include "support/effort.hpp"
#include "support/office.hpp"

namespace hidwa_local_planner::test {
namespace {

using drive::DriveResult;
using drive::DriveSample;
using drive::DriveSetup;

/// It arrives and touches nothing.
DriveResult arrives(const DriveSetup& setup) {
  const DriveResult result = drive::drive(setup);
  EXPECT_TRUE(result.arrived);
  EXPECT_EQ(result.contacts, 0);
  return result;
}

/// Besides, every step of the commands is within the acceleration limits, except where a failure hands the stop to the
/// host.
DriveResult arrives_smoothly(const DriveSetup& setup) {
  const DriveResult result = arrives(setup);
  const Parameters& p = setup.parameters;
  for (std::size_t i = 1; i < result.samples.size(); ++i) {
    const DriveSample& before = result.samples[i - 1];
    const DriveSample& now = result.samples[i];
    if (now.outcome == Outcome::fail) continue;
    EXPECT_LE(std::abs(now.command.v - before.command.v), p.acc_lim_x * 0.05 + 1e-9) << now.time;
    EXPECT_LE(std::abs(now.command.omega - before.command.omega), p.acc_lim_theta * 0.05 + 1e-9) << now.time;
  }
  return result;
}

TEST(ClosedLoop, AutonomyArrivesAndCannotSeeRegions) {
  const DriveSetup setup = office();
  const DriveResult result = arrives_smoothly(setup);
  EXPECT_GE(result.regions_crossed, 1);
  EXPECT_EQ(result.failures, 0u);
  // Hardly slower than driving all of the way at full speed: corners and the final turn.
  EXPECT_LT(result.duration, 1.1 * result.length / setup.parameters.max_vel_x);
}

TEST(ClosedLoop, AutonomyArrivesWithThePolygonToo) {
  DriveSetup setup = office();
  setup.outline = drive::padded_outline(drive::telepresence_footprint(), 0.01);
  arrives(setup);
}

// On a machine so busy that the budget leaves the fewest samples.
TEST(ClosedLoop, TheFewestSamplesArriveToo) {
  DriveSetup setup = office();
  setup.sampling = {6, 6};
  EXPECT_EQ(arrives_smoothly(setup).failures, 0u);
}

TEST(ClosedLoop, PaperProfileArrives) {
  DriveSetup setup = office();
  Parameters& p = setup.parameters;
  p.max_vel_x = 0.26;
  p.method = Method::paper;
  p.admissibility = Admissibility::horizon;
  p.forward_prune_distance = 1.0;
  p.trans_stopped_velocity = p.rot_stopped_velocity = 0.25;
  arrives(setup);
}

// Somebody who knows of the regions, and takes the robot for the demo's, keeps it out of them; it cannot see them.
DriveResult drive_avoiding(DriveSetup setup, std::uint64_t seed) {
  setup.person = std::make_shared<sim::AvoidingOperator>(sim::OperatorTraits(), sim::RobotHabits(),
                                                         *setup.ground->map(), setup.regions, seed);
  SCOPED_TRACE(seed);
  const DriveResult result = arrives(setup);
  EXPECT_EQ(result.regions_crossed, 0);
  return result;
}

TEST(ClosedLoop, APersonKeepsItOutOfTheRegions) {
  for (std::uint64_t seed = 1; seed <= effort(1u, 4u); ++seed) {
    const DriveResult result = drive_avoiding(office(), seed);
    EXPECT_GE(result.interventions, 3) << seed;
    EXPECT_GT(result.agreement, 0.5) << seed;
    // Help, not driving.
    EXPECT_GT(result.operator_active, 4.0) << seed;
    EXPECT_LT(result.operator_active, 0.3 * result.duration) << seed;
  }
}

TEST(ClosedLoop, ARobotSomewhatOtherThanThoughtIsMasteredToo) {
  DriveSetup setup = office(0.15);
  setup.parameters.delta = 1.0;
  setup.parameters.max_vel_theta = 0.9;
  drive_avoiding(setup, 9);
}

TEST(ClosedLoop, SameSeedSameDrive) {
  const DriveResult first = drive_avoiding(office(), 3), second = drive_avoiding(office(), 3);
  ASSERT_EQ(first.samples.size(), second.samples.size());
  for (std::size_t i = 0; i < first.samples.size(); ++i) {
    ASSERT_TRUE(first.samples[i].wanted == second.samples[i].wanted) << i;
    ASSERT_TRUE(first.samples[i].command == second.samples[i].command) << i;
  }
}

// Full deflection to either side, again and again, all the way: the robot turns where it can and touches nothing.
TEST(ClosedLoop, NothingThePersonDoesSteersItIntoAnything) {
  for (const double side : {1.0, -1.0}) {
    DriveSetup setup = office();
    std::vector<sim::ScriptEntry> script;
    for (int i = 0; i < 12; ++i) {
      sim::ScriptEntry entry;
      entry.after_m = 3.0 + 5.0 * i;
      entry.for_s = 3.0;
      entry.stick = {i % 3 == 2 ? -side : side, 0.0};
      script.push_back(entry);
    }
    setup.person = std::make_shared<sim::ScriptedOperator>(script);
    SCOPED_TRACE(side);
    const DriveResult result = arrives_smoothly(setup);
    const auto steered = std::count_if(result.samples.begin(), result.samples.end(), [](const DriveSample& sample) {
      return sample.state == OperatorStateId::shared || sample.state == OperatorStateId::blocked;
    });
    EXPECT_GE(steered, 12 * 3 * 20 - 60);  // 12 deflections of 3 s at 20 Hz
  }
}

}  // namespace
}  // namespace hidwa_local_planner::test
