// SPDX-License-Identifier: BSD-3-Clause
// A device that this package does not know, driven through the machine: all that is not the device's own meaning of a
// message follows the same rules as for a stick.
#include <cmath>
#include <memory>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "person.hpp"

namespace hidwa_local_planner::input {
namespace {

struct WheelMessage : OperatorMessage {
  double turn = 0.0;   // in [-1, 1], left positive
  bool press = false;  // hands control over
  bool stop = false;
  bool one_handed = false;
};

struct WheelState {
  double turn = 0.0;
  bool one_handed = false;

  template <typename Self, typename Archive>
  static void archive(Self& self, Archive& io) {
    io(self.turn, self.one_handed);
  }
};

/// Full speed, and the turn times the largest one. It takes the stick's place, in mode gesture the hand's.
class Wheel : public SourceOf<WheelMessage, WheelState> {
 public:
  SourceKind kind() const override { return {"wheel", true, false}; }
  SourceTopic topic(const Parameters&) const override { return {"wheel_topic", "wheel", "wheel"}; }
  bool can_steer(const Parameters&) const override { return true; }
  bool same_mapping(const Parameters& a, const Parameters& b) const override { return a.exponent == b.exponent; }
  OperatorCommand command() const override {
    return {state_.turn != 0.0, {parameters().max_vel_x, state_.turn * parameters().max_vel_theta}};
  }
  bool gone(double) const override { return state_.one_handed; }
  void lose() override { ++losses; }
  void exclude_pause(double pause) override { pauses += pause; }
  std::string advice() const override { return state_.one_handed ? "Put both hands on the wheel." : ""; }

  int losses = 0;
  double pauses = 0.0;  // [s]

 protected:
  ParsedMessage parsed(const WheelMessage& message) override {
    return {std::abs(message.turn) <= 1.0 ? "" : "turn is outside [-1, 1]",
            StopReading{message.stop, std::nullopt, message.shape()}, false};
  }
  SourceReading taken(const WheelMessage& message, double) override {
    state_.turn = message.turn;
    state_.one_handed = message.one_handed;
    SourceReading reading;
    reading.command = command();
    reading.buttons = Buttons{message.press, false};
    return reading;
  }
};

WheelMessage turned(double received, double turn) {
  WheelMessage message;
  message.turn = turn;
  message.received = received;
  return message;
}

WheelMessage pressed(double received) {
  WheelMessage message = turned(received, 0.0);
  message.press = true;
  return message;
}

/// A person whose machine knows the wheel.
struct Driver : Person {
  explicit Driver(const Parameters& parameters = Parameters()) : Person(parameters) {
    Sources sources = built_in_sources();
    sources.push_back(std::make_unique<Wheel>());
    wheel = static_cast<Wheel*>(sources.back().get());
    machine = OperatorStateMachine(std::move(sources));
    configure();
  }
  OperatorIntent cycle_with_turn(double time, double turn) { return cycle_with(turned(time, turn)); }
  /// Neutral at `time`, turned 0.05 s later, one cycle.
  OperatorIntent steer(double time) {
    machine.receive(turned(time, 0.0));
    return cycle_with_turn(time + 0.05, 0.5);
  }

  Wheel* wheel = nullptr;
};

TEST(OperatorSource, SteersSharedControlAndIsLetGo) {
  Driver driver;
  EXPECT_EQ(driver.cycle_with_turn(1.0, 0.5).state, State::autonomy);  // not seen neutral yet
  EXPECT_TRUE(says(driver.machine.advice(), "require_neutral"));
  expect_shared(driver.steer(1.1), 0.5, 0.5);
  expect_hold(driver.cycle_with_turn(1.2, 0.0), 0.5);
  EXPECT_EQ(driver.cycle(3.2).state, State::autonomy);  // delta
}

// What is worked out anew is the same message by other parameters.
TEST(OperatorSource, TakesNewParametersWithoutAnInterruption) {
  Driver driver;
  driver.steer(1.0);
  driver.p.max_vel_theta = 2.0;
  driver.configure();
  expect_shared(driver.cycle(1.1), 0.5, 1.0);
  driver.p.exponent = 3.0;  // another mapping, as this device has it
  driver.configure();
  EXPECT_EQ(driver.cycle_with_turn(1.2, 0.5).state, State::hold);
  EXPECT_EQ(driver.wheel->losses, 1);
}

TEST(OperatorSource, TheLastInTheListThatCanSteerDoes) {
  Driver driver;
  driver.stick(1.0, 0.0F);
  EXPECT_EQ(driver.cycle_with_stick(1.05, 1.0F).state, State::autonomy);
  EXPECT_EQ(driver.steer(1.1).state, State::shared);
  // The stick's being neutral releases nothing.
  EXPECT_EQ(driver.cycle_with_stick(1.2, 0.0F).state, State::shared);

  Person person;
  EXPECT_EQ(person.machine.receive(turned(1.0, 7.0)), "");  // nobody knows this kind
  EXPECT_EQ(person.machine.dropped(), 0U);
}

TEST(OperatorSource, TakesControlAndGivesItBack) {
  Driver driver(in_mode(OperatorMode::switching));
  EXPECT_EQ(driver.cycle_with_turn(1.0, 0.0).state, State::autonomy);
  // At once after a silence the link may have held the press back.
  EXPECT_EQ(driver.cycle_with(pressed(1.1)).state, State::autonomy);
  driver.machine.receive(turned(1.25, 0.0));
  EXPECT_EQ(driver.cycle_with(pressed(1.3)).state, State::manual);
  expect_manual(driver.cycle_with_turn(1.35, -1.0), 0.5, -1.0);
  EXPECT_EQ(driver.cycle_with(pressed(1.4)).state, State::autonomy);
}

TEST(OperatorSource, StopsAtOnceAndLetsGoStrictly) {
  Driver driver;
  driver.steer(1.0);
  WheelMessage stop = from("/wheel", turned(1.1, 9.0));  // faulty elsewhere
  stop.stop = true;
  expect_stopped(driver.cycle_with(stop));
  EXPECT_TRUE(says(driver.machine.advice(), "turn is outside [-1, 1]"));
  // What is still faulty lets go of nothing; nor does another wheel, another device of the same node, or silence.
  expect_stopped(driver.cycle_with(from("/wheel", turned(1.2, 9.0))));
  expect_stopped(driver.cycle_with(from("/other_wheel", turned(1.3, 0.0))));
  expect_stopped(driver.cycle_with(from("/wheel", stick_at(1.35, 0.0F))));
  expect_stopped(driver.cycle(9.0));
  EXPECT_EQ(driver.cycle_with(from("/wheel", turned(9.1, 0.0))).state, State::autonomy);
}

TEST(OperatorSource, DiesAndComesBack) {
  Driver driver;
  driver.steer(1.0);
  EXPECT_EQ(driver.cycle(1.55).state, State::shared);  // 0.5 s after the last message
  EXPECT_EQ(driver.cycle(1.56).state, State::lost);
  EXPECT_EQ(driver.wheel->losses, 1);
  EXPECT_TRUE(says(driver.machine.advice(), "fell silent"));
  EXPECT_EQ(driver.cycle_with_turn(2.0, 0.5).state, State::lost);  // to be seen neutral
  EXPECT_EQ(driver.steer(2.1).state, State::shared);
  EXPECT_NEAR(driver.machine.input_age(2.25), 0.1, 1e-9);
}

// A part of the device that is silent ends the input before the whole device is.
TEST(OperatorSource, MaySayThatItIsGone) {
  Driver driver;
  driver.steer(1.0);
  WheelMessage message = turned(1.1, 0.5);
  message.one_handed = true;
  EXPECT_EQ(driver.cycle_with(message).state, State::lost);
  EXPECT_TRUE(says(driver.machine.advice(), "Put both hands on the wheel."));
}

TEST(OperatorSource, LateAndFaultyMessagesAreDroppedAndNamed) {
  Driver driver;
  driver.machine.receive(stamped(1.0, turned(1.0, 0.0)));
  EXPECT_EQ(driver.cycle_with(stamped(1.05, turned(1.05, 0.5))).state, State::shared);
  // 0.6 s late, and input_timeout is 0.5 s.
  EXPECT_TRUE(says(driver.machine.receive(stamped(0.5, turned(1.1, -0.5))), "0.6 s later than the link needs at best"));
  expect_shared(driver.cycle(1.1), 0.5, 0.5);
  EXPECT_NE(driver.machine.receive(stamped(1.15, turned(1.15, 2.0))), "");
  EXPECT_EQ(driver.machine.dropped(), 2U);
  EXPECT_TRUE(says(driver.machine.advice(), "dropped: turn is outside [-1, 1]"));
  EXPECT_EQ(driver.machine.receive(stamped(1.2, turned(1.2, 0.5))), "");
  EXPECT_EQ(driver.machine.advice(), "");
}

TEST(OperatorSource, LearnsOfThePlannersOwnPauses) {
  Driver driver;
  driver.machine.heartbeat(1.0);
  driver.steer(1.0);
  EXPECT_EQ(driver.cycle(1.65).state, State::shared);  // nothing was at work for 0.6 s
  EXPECT_DOUBLE_EQ(driver.wheel->pauses, 1.65 - 1.05);
}

TEST(OperatorSource, IsSaved) {
  Driver driver, other;
  driver.steer(1.0);
  load(other.machine, saved(driver.machine));
  other.p.max_vel_theta = 2.0;
  other.configure();  // asks the source for its command
  expect_shared(other.cycle(1.1), 0.5, 1.0);
}

TEST(OperatorSource, WhoSubscribesIsToldWhatEachModeListensTo) {
  const OperatorStateMachine machine;
  const auto described = [&machine](const Parameters& p) {
    std::string text;
    for (const ListedSource& source : machine.sources(p)) {
      if (!source.listened_to) continue;
      text += source.kind.name + (source.steers ? "! " : " ") + source.topic.label + "; ";
    }
    return text;
  };
  Parameters p;
  EXPECT_EQ(described(p), "stick! joy; ");
  p = in_mode(OperatorMode::gesture);
  EXPECT_EQ(described(p), "stick joy; hand! hand_pose; ");
  p.twist_topic = "keys";
  EXPECT_EQ(described(p), "stick joy; hand! hand_pose; ");
  p.gesture_frame = "hand";
  p.gesture_parent_frame = "room";
  EXPECT_EQ(described(p), "stick joy; hand! tf room -> hand; ");
  p.mode = OperatorMode::switching;
  EXPECT_EQ(described(p), "stick joy; twist! keys; ");
  p.mode = OperatorMode::off;
  EXPECT_EQ(described(p), "");
}

TEST(OperatorSource, SentencesStandApartByOneSpace) {
  std::string text;
  const auto with = [&text](const char* sentence) {
    add_sentence(text, sentence);
    return text;
  };
  EXPECT_EQ(with(""), "");
  EXPECT_EQ(with("One."), "One.");
  EXPECT_EQ(with(""), "One.");
  EXPECT_EQ(with("Two."), "One. Two.");
}

}  // namespace
}  // namespace hidwa_local_planner::input
