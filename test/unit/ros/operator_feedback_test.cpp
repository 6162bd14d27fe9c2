// SPDX-License-Identifier: BSD-3-Clause
#include "ros/operator_feedback.hpp"

#include <gtest/gtest.h>

namespace hidwa_local_planner {
namespace {

TEST(RumbleIntensity, NoneAtAgreementOrWhereNothingIsWanted) {
  EXPECT_EQ(rumble_intensity(true, 1.0), 0.0F);
  EXPECT_EQ(rumble_intensity(true, 0.97), 0.0F);  // samples lie a little apart
  EXPECT_EQ(rumble_intensity(false, 0.0), 0.0F);
  EXPECT_EQ(rumble_intensity(false, 0.5), 0.0F);
}

TEST(RumbleIntensity, GrowsWithDisagreementUpToOne) {
  float before = 0.0F;
  for (int percent = 96; percent >= 0; --percent) {
    const float intensity = rumble_intensity(true, percent / 100.0);
    EXPECT_GT(intensity, before) << percent;
    before = intensity;
  }
  EXPECT_EQ(before, 1.0F);
  EXPECT_EQ(rumble_intensity(true, -3.0), 1.0F);  // the motor's range, whatever comes
}

TEST(NameOfMode, IsThatOfTheParameterForEach) {
  EXPECT_EQ(name_of(OperatorMode::off), "off");
  EXPECT_EQ(name_of(OperatorMode::joystick), "joystick");
  EXPECT_EQ(name_of(OperatorMode::gesture), "gesture");
  EXPECT_EQ(name_of(OperatorMode::switching), "switching");
}

// Messages carry the values as they are.
TEST(OperatorStateMessage, NumbersModesAndStatesAsTheCodeDoes) {
  EXPECT_EQ(static_cast<int>(OperatorMode::off), OperatorState::MODE_OFF);
  EXPECT_EQ(static_cast<int>(OperatorMode::joystick), OperatorState::MODE_JOYSTICK);
  EXPECT_EQ(static_cast<int>(OperatorMode::gesture), OperatorState::MODE_GESTURE);
  EXPECT_EQ(static_cast<int>(OperatorMode::switching), OperatorState::MODE_SWITCHING);
  EXPECT_EQ(static_cast<int>(OperatorStateId::autonomy), OperatorState::AUTONOMY);
  EXPECT_EQ(static_cast<int>(OperatorStateId::shared), OperatorState::SHARED);
  EXPECT_EQ(static_cast<int>(OperatorStateId::hold), OperatorState::HOLD);
  EXPECT_EQ(static_cast<int>(OperatorStateId::manual), OperatorState::MANUAL);
  EXPECT_EQ(static_cast<int>(OperatorStateId::stopped), OperatorState::STOPPED);
  EXPECT_EQ(static_cast<int>(OperatorStateId::lost), OperatorState::LOST);
  EXPECT_EQ(static_cast<int>(OperatorStateId::blocked), OperatorState::BLOCKED);
}

}  // namespace
}  // namespace hidwa_local_planner
