// SPDX-License-Identifier: BSD-3-Clause
// Drives with what a person may hold: a stick, a clutch and a hand, a button.
#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "drive/drive.hpp"
#include "drive/outline.hpp"
#include "sim/scripted_operator.hpp"

namespace hidwa_local_planner {
namespace drive {
namespace {

// A hall of 8 m x 12 m without anything in it; somebody steers left once 2 m are driven.
DriveSetup hall(OperatorMode mode, double seconds = 1.5) {
  auto map = std::make_shared<sim::OccupancyMap>(sim::make_map(240, 160, 0.05, -1.0, -4.0));
  DriveSetup setup;
  setup.ground = std::make_shared<Ground>(map);
  setup.goal = {9.0, 0.0, 0.0};
  setup.footprint = sim::circle_polygon(0.28, 24);
  setup.outline = circle_outline(0.30, 0.01);
  setup.time_limit = 60.0;
  setup.parameters.mode = mode;
  sim::ScriptEntry entry;
  entry.after_m = 2.0;
  entry.for_s = seconds;
  entry.stick = {0.7, 0.0};
  setup.person = std::make_shared<sim::ScriptedOperator>(std::vector<sim::ScriptEntry>{entry});
  return setup;
}

double first_time(const DriveResult& result, OperatorStateId state) {
  const auto at = std::find_if(result.samples.begin(), result.samples.end(),
                               [state](const DriveSample& sample) { return sample.state == state; });
  return at == result.samples.end() ? NAN : at->time;
}

TEST(OperatorLink, AStickIsWhatThereIsWithoutADevice) {
  DriveSetup setup = hall(OperatorMode::joystick);
  const DriveResult without = drive(setup);
  setup = hall(OperatorMode::joystick);
  setup.device = sim::make_operator_device("joystick", 0.3);
  const DriveResult with = drive(setup);
  EXPECT_TRUE(with.arrived);
  EXPECT_EQ(with.interventions, 1);
  EXPECT_EQ(with.length, without.length);
  EXPECT_EQ(with.operator_active, without.operator_active);
}

TEST(OperatorLink, AHandSteersWhileItsClutchIsHeld) {
  DriveSetup setup = hall(OperatorMode::gesture);
  setup.device = sim::make_operator_device("gesture", setup.parameters.gesture_range);
  const DriveResult result = drive(setup);
  EXPECT_TRUE(result.arrived);
  EXPECT_EQ(result.interventions, 1);
  EXPECT_NEAR(result.operator_active, 1.5, 0.2);
  double most = 0.0;  // [rad/s]
  for (const DriveSample& sample : result.samples) most = std::max(most, sample.wanted.omega);
  EXPECT_NEAR(most, 0.49, 1e-6);
  EXPECT_TRUE(std::isnan(first_time(result, OperatorStateId::manual)));
}

TEST(OperatorLink, AButtonTakesControlAndGivesItBack) {
  DriveSetup setup = hall(OperatorMode::switching);
  setup.device = sim::make_operator_device("switching", 0.3);
  const DriveResult result = drive(setup);
  EXPECT_TRUE(result.arrived);
  EXPECT_EQ(result.interventions, 1);
  EXPECT_GT(result.operator_active, 1.5);
  EXPECT_LT(result.operator_active, 3.0);
  EXPECT_FALSE(std::isnan(first_time(result, OperatorStateId::manual)));
  EXPECT_TRUE(std::isnan(first_time(result, OperatorStateId::shared)));
  EXPECT_EQ(result.samples.back().state, OperatorStateId::autonomy);
}

TEST(OperatorLink, MessagesArriveLaterByTheLinksDelay) {
  for (const double delay : {0.05, 0.15, 0.3}) {
    const DriveResult at_once = drive(hall(OperatorMode::joystick));
    DriveSetup setup = hall(OperatorMode::joystick);
    setup.link_delay = delay;
    const DriveResult later = drive(setup);
    EXPECT_NEAR(first_time(later, OperatorStateId::shared) - first_time(at_once, OperatorStateId::shared), delay, 1e-6);
    EXPECT_TRUE(later.arrived);
  }
}

TEST(OperatorLink, ADelayThatIsNoneIsRefused) {
  DriveSetup setup = hall(OperatorMode::joystick);
  setup.link_delay = -0.1;
  EXPECT_THROW(drive(setup), std::invalid_argument);
  setup.link_delay = NAN;
  EXPECT_THROW(drive(setup), std::invalid_argument);
}

}  // namespace
}  // namespace drive
}  // namespace hidwa_local_planner
