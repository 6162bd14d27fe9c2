// SPDX-License-Identifier: BSD-3-Clause
// A device that this package does not know, driven through the machine: all that is not the device's own meaning of a
// message follows the same rules as for a stick.
#include <cmath>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "person.hpp"

namespace hidwa_local_planner::input {
namespace {

using State = OperatorStateId;

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

Sources with_wheel() {
  Sources sources = built_in_sources();
  sources.push_back(std::make_unique<Wheel>());
  return sources;
}

WheelMessage turned(double received, double turn) {
  WheelMessage message;
  message.turn = turn;
  message.received = received;
  return message;
}

/// A machine that knows the wheel, and its driver.
struct Driver {
  explicit Driver(const Parameters& parameters = Parameters()) : p(parameters) {
    Sources sources = with_wheel();
    wheel = static_cast<Wheel*>(sources.back().get());
    machine = std::make_unique<OperatorStateMachine>(std::move(sources));
    machine->configure(p);
  }
  std::string turn(double time, double turn) { return machine->receive(turned(time, turn)); }
  OperatorIntent cycle(double time) {
    const OperatorIntent intent = machine->update(time);
    machine->debrief(time, {});
    return intent;
  }
  /// Neutral at `time`, turned 0.05 s later, one cycle.
  OperatorIntent steer(double time, double to = 0.5) {
    turn(time, 0.0);
    turn(time + 0.05, to);
    return cycle(time + 0.05);
  }

  Parameters p;  // max_vel_x 0.5, max_vel_theta 1, input_timeout 0.5 s, delta 2 s
  Wheel* wheel = nullptr;
  std::unique_ptr<OperatorStateMachine> machine;
};

TEST(OperatorSource, SteersSharedControlAndIsLetGo) {
  Driver driver;
  driver.turn(1.0, 0.5);
  EXPECT_EQ(driver.cycle(1.0).state, State::autonomy);  // not seen neutral yet
  EXPECT_NE(driver.machine->advice().find("require_neutral"), std::string::npos);
  expect_intent(driver.steer(1.1), State::shared, Influence::shared, 0.5, 0.5);
  driver.turn(1.2, 0.0);
  expect_intent(driver.cycle(1.2), State::hold, Influence::shared, 0.5, 0.0);
  EXPECT_EQ(driver.cycle(3.2).state, State::autonomy);  // delta
}

// What is worked out anew is the same message by other parameters.
TEST(OperatorSource, TakesNewParametersWithoutAnInterruption) {
  Driver driver;
  driver.steer(1.0);
  driver.p.max_vel_theta = 2.0;
  driver.machine->configure(driver.p);
  expect_intent(driver.cycle(1.1), State::shared, Influence::shared, 0.5, 1.0);
  driver.p.exponent = 3.0;  // another mapping, as this device has it
  driver.machine->configure(driver.p);
  driver.turn(1.2, 0.5);
  EXPECT_EQ(driver.cycle(1.2).state, State::hold);
  EXPECT_EQ(driver.wheel->losses, 1);
}

TEST(OperatorSource, TheLastInTheListThatCanSteerDoes) {
  Driver driver;
  driver.machine->receive(stick_at(1.0, 0.0F));
  driver.machine->receive(stick_at(1.05, 1.0F));
  EXPECT_EQ(driver.cycle(1.05).state, State::autonomy);
  EXPECT_EQ(driver.steer(1.1).state, State::shared);
  driver.machine->receive(stick_at(1.2, 0.0F));  // the stick's being neutral releases nothing
  EXPECT_EQ(driver.cycle(1.2).state, State::shared);

  Person person;
  EXPECT_EQ(person.machine.receive(turned(1.0, 7.0)), "");  // nobody knows this kind
  EXPECT_EQ(person.machine.dropped(), 0U);
}

TEST(OperatorSource, TakesControlAndGivesItBack) {
  Parameters p;
  p.mode = OperatorMode::switching;
  Driver driver(p);
  driver.turn(1.0, 0.0);
  EXPECT_EQ(driver.cycle(1.0).state, State::autonomy);
  WheelMessage press = turned(1.1, 0.0);
  press.press = true;
  driver.machine->receive(press);  // at once after a silence: the link may have held it back
  EXPECT_EQ(driver.cycle(1.1).state, State::autonomy);
  driver.turn(1.25, 0.0);
  press.received = 1.3;
  driver.machine->receive(press);
  EXPECT_EQ(driver.cycle(1.3).state, State::manual);
  driver.turn(1.35, -1.0);
  expect_intent(driver.cycle(1.35), State::manual, Influence::direct, 0.5, -1.0);
  press.received = 1.4;
  driver.machine->receive(press);
  EXPECT_EQ(driver.cycle(1.4).state, State::autonomy);
}

TEST(OperatorSource, StopsAtOnceAndLetsGoStrictly) {
  Driver driver;
  driver.steer(1.0);
  WheelMessage stop = turned(1.1, 9.0);  // faulty elsewhere
  stop.sender = "/wheel";
  stop.stop = true;
  EXPECT_EQ(driver.machine->receive(stop), "turn is outside [-1, 1]");
  expect_intent(driver.cycle(1.1), State::stopped, Influence::stop, 0.0, 0.0);

  stop.stop = false;
  stop.received = 1.2;
  driver.machine->receive(stop);  // still faulty: it lets go of nothing
  EXPECT_EQ(driver.cycle(1.2).state, State::stopped);
  WheelMessage other = turned(1.3, 0.0);
  other.sender = "/other_wheel";
  driver.machine->receive(other);
  EXPECT_EQ(driver.cycle(1.3).state, State::stopped);
  StickMessage stick = stick_at(1.35, 0.0F);
  stick.sender = "/wheel";  // one node with two devices
  driver.machine->receive(stick);
  EXPECT_EQ(driver.cycle(1.35).state, State::stopped);
  EXPECT_EQ(driver.cycle(9.0).state, State::stopped);  // nor does silence
  stop.turn = 0.0;
  stop.received = 9.1;
  EXPECT_EQ(driver.machine->receive(stop), "");
  EXPECT_EQ(driver.cycle(9.1).state, State::autonomy);
}

TEST(OperatorSource, DiesAndComesBack) {
  Driver driver;
  driver.steer(1.0);
  EXPECT_EQ(driver.cycle(1.55).state, State::shared);  // 0.5 s after the last message
  EXPECT_EQ(driver.cycle(1.56).state, State::lost);
  EXPECT_EQ(driver.wheel->losses, 1);
  EXPECT_NE(driver.machine->advice().find("fell silent"), std::string::npos);
  driver.turn(2.0, 0.5);
  EXPECT_EQ(driver.cycle(2.0).state, State::lost);  // to be seen neutral
  EXPECT_EQ(driver.steer(2.1).state, State::shared);
  EXPECT_NEAR(driver.machine->input_age(2.25), 0.1, 1e-9);
}

// A part of the device that is silent ends the input before the whole device is.
TEST(OperatorSource, MaySayThatItIsGone) {
  Driver driver;
  driver.steer(1.0);
  WheelMessage message = turned(1.1, 0.5);
  message.one_handed = true;
  driver.machine->receive(message);
  EXPECT_EQ(driver.cycle(1.1).state, State::lost);
  EXPECT_NE(driver.machine->advice().find("Put both hands on the wheel."), std::string::npos);
}

TEST(OperatorSource, LateAndFaultyMessagesAreDroppedAndNamed) {
  Driver driver;
  const auto send = [&driver](double time, double lag, double turn) {
    WheelMessage message = turned(time, turn);
    message.stamp = time - lag;
    return driver.machine->receive(message);
  };
  EXPECT_EQ(send(1.0, 0.0, 0.0), "");
  EXPECT_EQ(send(1.05, 0.0, 0.5), "");
  EXPECT_EQ(driver.cycle(1.05).state, State::shared);
  const std::string late = send(1.1, 0.6, -0.5);  // input_timeout is 0.5 s
  EXPECT_NE(late.find("0.6 s later than the link needs at best"), std::string::npos) << late;
  expect_intent(driver.cycle(1.1), State::shared, Influence::shared, 0.5, 0.5);
  EXPECT_NE(send(1.15, 0.0, 2.0), "");
  EXPECT_EQ(driver.machine->dropped(), 2U);
  EXPECT_NE(driver.machine->advice().find("dropped: turn is outside [-1, 1]"), std::string::npos);
  EXPECT_EQ(send(1.2, 0.0, 0.5), "");
  EXPECT_EQ(driver.machine->advice(), "");
}

TEST(OperatorSource, AnotherSenderMustBeSeenNeutral) {
  Driver driver;
  driver.steer(1.0);
  WheelMessage message = turned(1.1, 0.5);
  message.sender = "/other_wheel";
  driver.machine->receive(message);
  EXPECT_EQ(driver.cycle(1.1).state, State::hold);
}

TEST(OperatorSource, LearnsOfThePlannersOwnPauses) {
  Driver driver;
  driver.machine->heartbeat(1.0);
  driver.steer(1.0);
  EXPECT_EQ(driver.cycle(1.65).state, State::shared);  // nothing was at work for 0.6 s
  EXPECT_DOUBLE_EQ(driver.wheel->pauses, 1.65 - 1.05);
}

// Records of before a device was added stay readable, and the other way round.
TEST(OperatorSource, IsSavedByItsName) {
  Driver driver;
  driver.steer(1.0);
  Bytes bytes;
  ArchiveWriter write(bytes);
  driver.machine->save(write);

  Driver other;
  ArchiveReader read(bytes);
  other.machine->load(read);
  EXPECT_TRUE(read.complete());
  other.p.max_vel_theta = 2.0;
  other.machine->configure(other.p);  // asks the source for its command
  expect_intent(other.cycle(1.1), State::shared, Influence::shared, 0.5, 1.0);

  OperatorStateMachine without;
  ArchiveReader again(bytes);
  without.load(again);
  EXPECT_TRUE(again.complete());
  expect_intent(without.update(1.1), State::shared, Influence::shared, 0.5, 0.5);

  Bytes of_stick;
  ArchiveWriter write_stick(of_stick);
  Person person;
  person.steer(1.0);
  person.machine.save(write_stick);
  ArchiveReader read_stick(of_stick);
  driver.machine->load(read_stick);
  EXPECT_TRUE(read_stick.complete());
  EXPECT_FALSE(driver.wheel->command().active);  // as at the start
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
  p.mode = OperatorMode::gesture;
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
