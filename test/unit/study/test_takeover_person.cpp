// SPDX-License-Identifier: BSD-3-Clause
#include "study/takeover_person.hpp"

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

struct Watched {
  std::vector<Seen> seen;
  std::vector<double> presses;  // of the button: when [s]
  double driven = 0.0;          // [s]
  int errors = 0;
};

// Somebody like this wants left from 1 s to 3 s of 10 s.
Watched watch(const Participant& traits) {
  TakeoverPerson person(traits, 1);
  Watched watched;
  bool held = false;
  for (int i = 0; i < 200; ++i) {
    const double time = i * kStep;
    const sim::Controls controls = person.update(time, {time >= 1.0 && time < 3.0 ? 0.6 : 0.0, 0.0});
    watched.seen.push_back({time, controls});
    if (controls.toggle && !held) watched.presses.push_back(time);
    held = controls.toggle;
    watched.driven += controls.stick.up > 0.0 ? kStep : 0.0;
  }
  watched.errors = person.errors();
  return watched;
}

TEST(TakeoverPerson, TakesControlDrivesAndGivesItBack) {
  const Watched watched = watch(flawless());
  const std::vector<double>& at = watched.presses;
  ASSERT_EQ(at.size(), 2u);
  EXPECT_NEAR(at[0], 1.2, 0.051);
  EXPECT_NEAR(at[1], 3.0 + 0.5 + 0.2, 0.101);
  for (const Seen& s : watched.seen) {
    const bool drives = s.time >= at[0] && s.time < at[1];
    EXPECT_EQ(s.controls.stick.up, drives ? 1.0 : 0.0) << s.time;
    EXPECT_EQ(s.controls.stick.left, drives && s.time < 3.0 ? 0.6 : 0.0) << s.time;
  }
  EXPECT_EQ(watched.errors, 0);
}

TEST(TakeoverPerson, ForgetsToGiveControlBackAndNotices) {
  Participant traits = flawless();
  traits.forget_probability = 1.0;
  const Watched watched = watch(traits);
  ASSERT_EQ(watched.presses.size(), 2u);
  EXPECT_NEAR(watched.presses[1], 3.5 + 2.0, 0.101);
  EXPECT_NEAR(watched.driven, 3.5 - watched.presses[0], 0.101);  // the stick is let go meanwhile
  EXPECT_EQ(watched.errors, 1);
}

TEST(TakeoverPerson, PressesTwiceAndNotices) {
  Participant traits = flawless();
  traits.double_press_probability = 1.0;
  const Watched watched = watch(traits);
  ASSERT_GE(watched.presses.size(), 2u);
  EXPECT_NEAR(watched.presses[1] - watched.presses[0], 0.3, 0.051);
  EXPECT_EQ(watched.presses.size() % 2, 0u);  // control stays the robot's
  EXPECT_GE(watched.errors, 1);
}

TEST(TakeoverPerson, DeflectsTheStickWithoutTakingControlAndNotices) {
  Participant traits = flawless();
  traits.early_stick_probability = 1.0;
  traits.notice_time = 1.0;
  const Watched watched = watch(traits);
  ASSERT_EQ(watched.presses.size(), 2u);
  EXPECT_NEAR(watched.presses[0], 1.0 + 1.0 + 0.2, 0.101);
  EXPECT_EQ(watched.seen[30].controls.stick.left, 0.6);
  EXPECT_EQ(watched.errors, 1);
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
  const std::vector<Seen> seen = watch(traits).seen;
  EXPECT_NEAR(seen[40].controls.stick.up, 0.8, 1e-12);
  EXPECT_NEAR(seen[62].controls.stick.up, 1.0, 1e-12);
}

}  // namespace
}  // namespace study
}  // namespace hidwa_local_planner
