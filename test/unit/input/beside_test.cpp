// SPDX-License-Identifier: BSD-3-Clause
// Several nodes that send on one topic: devices are told apart and remembered, and one that nobody touches takes
// nothing from one that steers.
#include <optional>
#include <string>

#include <gtest/gtest.h>

#include "person.hpp"

namespace hidwa_local_planner::input {
namespace {

/// A person at a page whose stick is sent 20 times a second while it is held, and what else sends on its topic.
struct Beside : Person {
  explicit Beside(const Parameters& parameters = Parameters()) : Person(parameters) {}

  std::string page(float angular) { return machine.receive(from("/console", stick_at(now, angular))); }
  std::string other(float angular, const std::string& sender = "/joy_node") {
    return machine.receive(from(sender, stick_at(now, angular)));
  }
  /// One period of 0.05 s: the page's message, where it sends one, then the other's, then a cycle.
  State period(const std::optional<float>& page_angular, float other_angular) {
    now += 0.05;
    if (page_angular) {
      EXPECT_EQ(page(*page_angular), "");
    }
    EXPECT_EQ(other(other_angular), "");
    const OperatorIntent intent = cycle(now);
    turn = intent.u_h.omega;
    return intent.state;
  }
  /// Both are centred once, then the page is held.
  void steer_page(float other_angular = 0.0F) {
    period(0.0F, other_angular);
    EXPECT_EQ(period(1.0F, other_angular), State::shared);
  }

  double now = 100.0;  // [s]
  double turn = 0.0;   // that the last cycle's intent asks for [rad/s]
};

TEST(Beside, AnIdleNodeTakesNothingFromThePage) {
  Beside both;
  both.period(std::nullopt, 0.0F);
  both.steer_page();
  for (int i = 0; i < 200; ++i) ASSERT_EQ(both.period(1.0F, 0.0F), State::shared) << i;
  EXPECT_EQ(both.machine.dropped(), 0U);
  EXPECT_EQ(both.machine.sender(), "/console");
  EXPECT_EQ(both.period(0.0F, 0.0F), State::hold);
  EXPECT_EQ(both.period(-0.5F, 0.0F), State::shared);  // no second centring
  EXPECT_TRUE(says(both.machine.advice(), "/joy_node and /console")) << both.machine.advice();
}

// 0.09 lies within the dead zone of 0.1; at 0.11 beyond it the stick trembles around its edge; 1 is a trigger, or a
// stick that lies on its side.
TEST(Beside, AWornStickTakesNothing) {
  for (const float rest : {0.09F, 0.11F, 1.0F}) {
    Beside both;
    both.period(std::nullopt, rest);
    both.period(0.0F, rest);
    both.steer_page(rest);
    for (int i = 0; i < 100; ++i) {
      ASSERT_EQ(both.period(1.0F, rest - (i % 2 == 0 ? 0.0F : 0.02F)), State::shared) << rest << ' ' << i;
      ASSERT_DOUBLE_EQ(both.turn, 1.0) << rest << ' ' << i;
    }
  }
}

TEST(Beside, EachSteersWhileTheOtherIsIdle) {
  Beside both;
  both.period(0.0F, 0.0F);
  for (int i = 0; i < 5; ++i) {
    EXPECT_EQ(both.period(1.0F, 0.0F), State::shared);
    EXPECT_DOUBLE_EQ(both.turn, 1.0);
    both.period(0.0F, 0.0F);
    EXPECT_EQ(both.period(std::nullopt, -1.0F), State::shared);
    EXPECT_DOUBLE_EQ(both.turn, -1.0);
    EXPECT_EQ(both.machine.sender(), "/joy_node");
    both.period(std::nullopt, 0.0F);
  }
}

TEST(Beside, WhoSteersGoesOnWhereAnotherBeginsTo) {
  Beside both;
  both.steer_page();
  EXPECT_EQ(both.period(1.0F, -1.0F), State::shared);
  EXPECT_DOUBLE_EQ(both.turn, 1.0);
  both.period(0.0F, -1.0F);  // let go: the other one, which was seen centred, steers
  EXPECT_DOUBLE_EQ(both.turn, -1.0);
}

// The page falls silent while it steers: an idle node beside it does not end the loss. Moving its stick does.
TEST(Beside, AnIdleNodeEndsNoLoss) {
  Beside both;
  both.steer_page();
  for (int i = 0; i < 9; ++i) ASSERT_EQ(both.period(std::nullopt, 0.0F), State::shared);  // 0.45 s
  both.period(std::nullopt, 0.0F);
  for (int i = 0; i < 100; ++i) ASSERT_EQ(both.period(std::nullopt, 0.0F), State::lost) << i;
  EXPECT_EQ(both.period(1.0F, 0.0F), State::lost);  // not yet centred
  EXPECT_EQ(both.period(std::nullopt, -0.5F), State::shared);
  EXPECT_EQ(both.period(0.0F, 0.0F), State::hold);
  EXPECT_EQ(both.period(1.0F, 0.0F), State::shared);
}

TEST(Beside, ASuccessorOfTheLostDeviceEndsTheLoss) {
  Beside both;
  both.steer_page();
  both.now += 0.6;
  EXPECT_EQ(both.cycle(both.now).state, State::lost);
  both.other(0.0F, "/console_2");
  EXPECT_NE(both.cycle(both.now).state, State::lost);
}

// A button that one of them holds is pressed once, however often the other says that its own is not.
TEST(Beside, APressOfOneCountsOnce) {
  Beside both(in_mode(OperatorMode::switching));
  for (int i = 0; i < 10; ++i) both.period(0.0F, 0.0F);
  for (const bool page_presses : {true, false, true}) {
    const std::string presser = page_presses ? "/console" : "/joy_node",
                      other = page_presses ? "/joy_node" : "/console";
    const bool before = both.machine.manual();
    for (int i = 0; i < 20; ++i) {
      both.now += 0.05;
      both.machine.receive(from(presser, button_at(both.now, kToggle)));
      both.machine.receive(from(other, stick_at(both.now + 0.01, 0.0F)));
      both.cycle(both.now + 0.02);
      ASSERT_NE(both.machine.manual(), before) << presser << ' ' << i;
    }
    both.period(0.0F, 0.0F);
  }
}

// The page's clutch in mode gesture, beside a joystick whose button is not held.
TEST(Beside, AnIdleNodeTakesNoClutch) {
  Beside both(in_mode(OperatorMode::gesture));
  const auto frame = [&](bool clutch, double y) {
    both.now += 0.02;
    both.machine.receive(from("/console", clutch ? button_at(both.now, kClutch) : stick_at(both.now, 0.0F)));
    both.machine.receive(from("/console", hand_at(both.now, 1.0, y, 1.0)));
    both.other(0.0F);
    return both.cycle(both.now).state;
  };
  for (int i = 0; i < 5; ++i) frame(false, 0.0);
  for (int i = 0; i < 5; ++i) frame(true, 0.0);
  EXPECT_EQ(frame(true, 0.15), State::shared);
  for (int i = 0; i < 100; ++i) ASSERT_EQ(frame(true, 0.2), State::shared) << i;
}

// Also one whose Twist is never quite 0, and one that is heard for the first time while the other steers.
TEST(Beside, AnIdleKeyboardTakesNothingFromATwist) {
  for (const double rest : {0.0, 0.009}) {
    Parameters p;
    p.twist_topic = "twist";
    Person person(p);
    const auto send = [&](const std::string& sender, double time, double omega) {
      person.machine.receive(from(sender, twist_at(time, 0.0, omega)));
    };
    send("/keyboard", 1.0, rest);
    send("/mapper", 1.01, rest);
    for (int i = 0; i < 100; ++i) {
      const double time = 1.1 + 0.05 * i;
      send("/mapper", time, 0.5);
      send("/keyboard", time + 0.01, rest);
      if (i > 50) send("/filter", time + 0.015, rest);
      ASSERT_EQ(person.cycle(time + 0.02).state, State::shared) << i;
    }
  }
}

// Each device has a lag of its own: clocks that are an hour apart make neither of them late.
TEST(Beside, ClocksOfTheirOwn) {
  for (const double ahead : {3600.0, -3600.0, 0.5}) {
    Person person;
    person.machine.receive(from("/console", stamped(1e4 + ahead, stick_at(1e4, 0.0F))));
    for (int i = 1; i <= 100; ++i) {
      const double now = 1e4 + 0.05 * i;
      person.machine.receive(from("/console", stamped(now + ahead, stick_at(now, 1.0F))));
      person.machine.receive(from("/joy_node", stamped(now, stick_at(now, 0.0F))));
      ASSERT_EQ(person.cycle(now).state, State::shared) << i;
    }
    EXPECT_EQ(person.machine.dropped(), 0U);
  }
}

// Parameters that read the sticks otherwise: all of them must be seen centred again.
TEST(Beside, AnotherMappingAsksAllOfThem) {
  Beside both;
  both.steer_page();
  both.p.axis_angular.reversed = true;
  both.configure();
  EXPECT_NE(both.period(1.0F, -1.0F), State::shared);
  EXPECT_NE(both.period(1.0F, -1.0F), State::shared);
  both.period(0.0F, -1.0F);
  EXPECT_EQ(both.period(1.0F, -1.0F), State::shared);
  EXPECT_DOUBLE_EQ(both.turn, -1.0);
}

TEST(Beside, ManyNamesFillNoMemoryAndTakeNothing) {
  Beside both;
  both.page(0.0F);
  for (int i = 0; i < 100; ++i) {
    both.now += 0.05;
    both.page(1.0F);
    both.other(0.0F, "/joy_" + std::to_string(i));
    ASSERT_EQ(both.cycle(both.now).state, State::shared) << i;
  }
}

}  // namespace
}  // namespace hidwa_local_planner::input
