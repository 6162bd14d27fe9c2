// SPDX-License-Identifier: BSD-3-Clause
#include "study/takeover_person.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace hidwa_local_planner {
namespace study {
namespace {

constexpr double kStep = 0.05;  // [s]

Participant flawless() {
  Participant person = draw_participant(1, 1);
  person.button_time = 0.2;
  person.give_back_pause = 0.5;
  person.notice_time = 2.0;
  person.forget_probability = person.double_press_probability = person.early_stick_probability = 0.0;
  return person;
}

struct Seen {
  double time;
  sim::Controls controls;
};

// Wants left from 1 s to 3 s of 10 s.
std::vector<Seen> watch(TakeoverPerson& person) {
  std::vector<Seen> seen;
  for (int i = 0; i < 200; ++i) {
    const double time = i * kStep;
    seen.push_back({time, person.update(time, {time >= 1.0 && time < 3.0 ? 0.6 : 0.0, 0.0})});
  }
  return seen;
}

std::vector<double> presses(const std::vector<Seen>& seen) {
  std::vector<double> times;
  bool held = false;
  for (const Seen& s : seen) {
    if (s.controls.toggle && !held) times.push_back(s.time);
    held = s.controls.toggle;
  }
  return times;
}

double driven(const std::vector<Seen>& seen) {
  return kStep * static_cast<double>(
                     std::count_if(seen.begin(), seen.end(), [](const Seen& s) { return s.controls.stick.up > 0.0; }));
}

TEST(TakeoverPerson, TakesControlDrivesAndGivesItBack) {
  TakeoverPerson person(flawless(), 1);
  const std::vector<Seen> seen = watch(person);
  const std::vector<double> at = presses(seen);
  ASSERT_EQ(at.size(), 2u);
  EXPECT_NEAR(at[0], 1.2, 0.051);
  EXPECT_NEAR(at[1], 3.0 + 0.5 + 0.2, 0.101);
  for (const Seen& s : seen) {
    const bool drives = s.time >= at[0] && s.time < at[1];
    EXPECT_EQ(s.controls.stick.up, drives ? 1.0 : 0.0) << s.time;
    EXPECT_EQ(s.controls.stick.left, drives && s.time < 3.0 ? 0.6 : 0.0) << s.time;
  }
  EXPECT_EQ(person.errors(), 0);
}

TEST(TakeoverPerson, ForgetsToGiveControlBackAndNotices) {
  Participant traits = flawless();
  traits.forget_probability = 1.0;
  TakeoverPerson person(traits, 1);
  const std::vector<Seen> seen = watch(person);
  const std::vector<double> at = presses(seen);
  ASSERT_EQ(at.size(), 2u);
  EXPECT_NEAR(at[1], 3.5 + 2.0, 0.101);
  EXPECT_NEAR(driven(seen), 3.5 - at[0], 0.101);  // the stick is let go meanwhile
  EXPECT_EQ(person.errors(), 1);
}

TEST(TakeoverPerson, PressesTwiceAndNotices) {
  Participant traits = flawless();
  traits.double_press_probability = 1.0;
  TakeoverPerson person(traits, 1);
  const std::vector<double> at = presses(watch(person));
  ASSERT_GE(at.size(), 2u);
  EXPECT_NEAR(at[1] - at[0], 0.3, 0.051);
  EXPECT_EQ(at.size() % 2, 0u);  // control stays the robot's
  EXPECT_GE(person.errors(), 1);
}

TEST(TakeoverPerson, DeflectsTheStickWithoutTakingControlAndNotices) {
  Participant traits = flawless();
  traits.early_stick_probability = 1.0;
  traits.notice_time = 1.0;
  TakeoverPerson person(traits, 1);
  const std::vector<Seen> seen = watch(person);
  const std::vector<double> at = presses(seen);
  ASSERT_EQ(at.size(), 2u);
  EXPECT_NEAR(at[0], 1.0 + 1.0 + 0.2, 0.101);
  EXPECT_EQ(seen[30].controls.stick.left, 0.6);
  EXPECT_EQ(person.errors(), 1);
}

TEST(TakeoverPerson, LeavesTheButtonAloneForAWishThatPasses) {
  TakeoverPerson person(flawless(), 1);
  for (int i = 0; i < 100; ++i) {
    const sim::Controls controls = person.update(i * kStep, {i == 20 || i == 21 ? 0.6 : 0.0, 0.0});
    EXPECT_FALSE(controls.toggle);
    EXPECT_EQ(controls.stick.up, 0.0);
  }
}

TEST(TakeoverPerson, ARoundGateTakesSpeedFromTurns) {
  Participant traits = flawless();
  traits.round_gate = 1.0;
  TakeoverPerson person(traits, 1);
  const std::vector<Seen> seen = watch(person);
  EXPECT_NEAR(seen[40].controls.stick.up, 0.8, 1e-12);
  EXPECT_NEAR(seen[62].controls.stick.up, 1.0, 1e-12);
}

}  // namespace
}  // namespace study
}  // namespace hidwa_local_planner
