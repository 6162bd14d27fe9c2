// SPDX-License-Identifier: BSD-3-Clause
// The parameter sets that come with the planner, against messages of exactly their device's shape.
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "person.hpp"

namespace hidwa_local_planner::input {
namespace {

using State = OperatorStateId;

std::string trimmed(const std::string& text) {
  const std::size_t first = text.find_first_not_of(' ');
  if (first == std::string::npos) return "";
  return text.substr(first, text.find_last_not_of(' ') - first + 1);
}

/// A value as YAML understands it.
ParameterValue value_of(const std::string& text) {
  if (text == "true" || text == "false") return text == "true";
  if (text == "\"\"") return std::string();
  if (text.find_first_not_of("-0123456789") == std::string::npos) return std::stoi(text);
  if (text.find_first_not_of("-.0123456789") == std::string::npos) return std::stod(text);
  return text;
}

/// Reads the flat "  key: value  # comment" lines below HIDWAPlannerROS.
Parameters shipped(const std::string& name) {
  const std::string path = std::string(HIDWA_DEVICES) + "/" + name + ".yaml";
  std::ifstream file(path);
  EXPECT_TRUE(file.is_open()) << path;
  Parameters p;
  bool below = false;
  int keys = 0;
  for (std::string line; std::getline(file, line);) {
    line = line.substr(0, line.find('#'));
    const std::string text = trimmed(line);
    if (text.empty()) continue;
    if (text == "HIDWAPlannerROS:") {
      EXPECT_EQ(line[0], 'H') << path;
      below = true;
      continue;
    }
    EXPECT_TRUE(below && line.rfind("  ", 0) == 0 && line[2] != ' ') << path << ": " << line;
    const std::size_t colon = text.find(": ");
    EXPECT_NE(colon, std::string::npos) << path << ": " << line;
    const std::string key = text.substr(0, colon);
    const ParameterValue before = get_parameter(p, key);
    EXPECT_EQ(set_parameter(p, key, value_of(trimmed(text.substr(colon + 1)))), "") << path;
    EXPECT_NE(get_parameter(p, key), before) << path << ": " << key << " is the default or said twice";
    ++keys;
  }
  EXPECT_GT(keys, 0) << path;
  EXPECT_EQ(validate(p), std::vector<std::string>()) << path;
  return p;
}

/// A device of a known shape at rest, and who holds it.
struct Device : Person {
  Device(const std::string& name, std::vector<float> axes, std::size_t buttons, double rate)
      : Person(shipped(name)), rest_axes(axes), rest_buttons(buttons, 0), period(1.0 / rate) {
    message.axes = rest_axes;
    message.buttons = rest_buttons;
  }
  void let_go() {
    message.axes = rest_axes;
    message.buttons = rest_buttons;
  }
  /// Sends the message for `duration` [s] at the device's rate, one cycle at the end.
  OperatorIntent play(double duration) {
    const double end = now + duration;
    for (; now < end; now += period) send();
    return cycle(now);
  }
  void send() {
    message.received = now;
    if (stamped) message.stamp = now;
    EXPECT_EQ(machine.receive(message), "") << machine.advice();
    if (p.mode != OperatorMode::gesture) return;
    HandMessage pose = hand_at(now, hand.x(), hand.y(), hand.z());
    pose.stamp = message.stamp;
    EXPECT_EQ(machine.receive(pose), "");
  }

  std::vector<float> rest_axes;
  std::vector<int> rest_buttons;
  double period;         // [s]
  double now = 100.0;    // [s]
  bool stamped = false;  // else the stamps are empty
  StickMessage message;
  Eigen::Vector3d hand{0.2, -0.3, 1.1};  // [m]
};

/// The stick with the axes `angular` and `linear`, steered, stopped and released. `left` and `up`: what the
/// device sends for them. `stop`: its button, if it has so many.
void steer_and_stop(Device& device, std::size_t angular, std::size_t linear, float left, float up, std::size_t stop) {
  std::vector<float>& axes = device.message.axes;
  expect_intent(device.play(0.2), State::autonomy, Influence::none, 0.0, 0.0);
  axes[angular] = left;
  expect_intent(device.play(0.2), State::shared, Influence::shared, 0.5, 1.0);  // 1^2 * max_vel_theta
  axes[angular] = -0.5F * left;
  expect_intent(device.play(0.2), State::shared, Influence::shared, 0.5, -0.25);  // -(0.5^2)
  axes[linear] = -up;
  expect_intent(device.play(0.2), State::stopped, Influence::stop, 0.0, 0.0);
  axes[linear] = up;
  expect_intent(device.play(0.2), State::shared, Influence::shared, 0.5, -0.25);
  if (stop < device.message.buttons.size()) {
    device.message.buttons[stop] = 1;
    expect_intent(device.play(0.2), State::stopped, Influence::stop, 0.0, 0.0);
    device.message.buttons[stop] = 0;
    EXPECT_EQ(device.play(0.2).state, State::shared);
  }
  device.let_go();
  expect_intent(device.play(0.2), State::hold, Influence::shared, 0.5, 0.0);
  expect_intent(device.play(2.1), State::autonomy, Influence::none, 0.0, 0.0);  // delta 2 s
}

/// The same stick in mode switching: taken and given back by `toggle`.
void take_and_give_back(Device& device, std::size_t angular, std::size_t linear, float left, float up,
                        std::size_t toggle) {
  device.p.mode = OperatorMode::switching;
  device.machine.configure(device.p);
  const auto press = [&] {
    device.message.buttons[toggle] = 1;
    device.play(0.1);
    device.message.buttons[toggle] = 0;
    return device.play(0.1);
  };
  device.let_go();
  for (int i = 0; i < 5; ++i) EXPECT_EQ(device.play(0.1).state, State::autonomy);
  expect_intent(press(), State::manual, Influence::direct, 0.0, 0.0);
  device.message.axes[angular] = left;
  device.message.axes[linear] = 0.5F * up;
  expect_intent(device.play(0.1), State::manual, Influence::direct, 0.125, 1.0);  // 0.5^2 * 0.5, 1^2
  device.let_go();
  expect_intent(device.play(0.1), State::manual, Influence::direct, 0.0, 0.0);
  expect_intent(press(), State::autonomy, Influence::none, 0.0, 0.0);
}

// xpad's axes: left x, left y, left trigger, right x, right y, right trigger, cross x, cross y.
TEST(Devices, XboxOnJoyNode) {
  Device device("xbox", {0, 0, 1, 0, 0, 1, 0, 0}, 11, 20.0);
  device.stamped = true;
  steer_and_stop(device, 0, 1, 1.0F, 1.0F, 1);
  device.message.axes[5] = -1.0F;  // a trigger pressed: nobody reads it
  device.message.axes[3] = 1.0F;   // nor the right stick
  EXPECT_EQ(device.play(0.2).state, State::autonomy);
  take_and_give_back(device, 0, 1, 1.0F, 1.0F, 3);
}

// joy_node says 0 for a trigger until it first moves, and its stick overshoots by rounding.
TEST(Devices, XboxOnJoyNodeBeforeATriggerMoved) {
  Device device("xbox", {0, 0, 0, 0, 0, 0, 0, 0}, 11, 20.0);
  device.stamped = true;
  steer_and_stop(device, 0, 1, 1.0F, 1.0F, 1);
  device.message.axes[0] = -1.00003F;
  expect_intent(device.play(0.2), State::shared, Influence::shared, 0.5, -1.0);
}

TEST(Devices, Ps4OnJoyNode) {
  Device device("ps4", {0, 0, 1, 0, 0, 1, 0, 0}, 13, 20.0);
  device.stamped = true;
  steer_and_stop(device, 0, 1, 1.0F, 1.0F, 1);
  take_and_give_back(device, 0, 1, 1.0F, 1.0F, 2);
}

// Left x, left y, right x, right y, triggers, grips; right is +1.
TEST(Devices, QuestOnUnityRosTeleoperation) {
  for (const double rate : {72.0, 120.0}) {
    Device device("quest_joystick", {0, 0, 0, 0, 0, 0, 0, 0}, 17, rate);
    EXPECT_EQ(device.p.joy_topic, "/quest/joystick");
    steer_and_stop(device, 0, 1, -1.0F, 1.0F, 2);
    device.message.axes[7] = 1.0F;  // a grip held, and its button
    device.message.buttons[11] = 1;
    EXPECT_EQ(device.play(0.2).state, State::autonomy);
    take_and_give_back(device, 0, 1, -1.0F, 1.0F, 0);
  }
}

TEST(Devices, UnityRosTcp) {
  for (const bool stamped : {false, true}) {
    Device device("unity_tcp", {0, 0}, 2, 50.0);
    device.stamped = stamped;
    steer_and_stop(device, 0, 1, -1.0F, 1.0F, 99);
    take_and_give_back(device, 0, 1, -1.0F, 1.0F, 0);
  }
}

/// A hand that is moved by `left` (full deflection), half of it back to the right and so on, while `press`
/// and `release` work its clutch.
template <typename Press, typename Release>
void steer_by_hand(Device& device, const Eigen::Vector3d& left, Press press, Release release) {
  EXPECT_EQ(device.p.mode, OperatorMode::gesture);
  expect_intent(device.play(0.2), State::autonomy, Influence::none, 0.0, 0.0);
  device.hand += left;  // without the clutch
  EXPECT_EQ(device.play(0.2).state, State::autonomy);
  press();
  EXPECT_EQ(device.play(0.2).state, State::autonomy);  // here is the origin
  const Eigen::Vector3d origin = device.hand;
  device.hand = origin + 0.9 * left;  // no jump
  const double p = static_cast<double>(0.9F);
  OperatorIntent intent = device.play(0.2);
  EXPECT_EQ(intent.state, State::shared);
  EXPECT_NEAR(intent.u_h.omega, p * p, 1e-6);  // 0.27 m / gesture_range = 0.9; 0.9^2 * 1 rad/s
  EXPECT_DOUBLE_EQ(intent.u_h.v, 0.5);
  device.hand = origin + 0.1 * left;
  EXPECT_EQ(device.play(0.2).state, State::hold);
  device.hand = origin - 0.5 * left;
  EXPECT_NEAR(device.play(0.2).u_h.omega, -0.25, 1e-6);  // -(0.5^2)
  device.message.buttons[static_cast<std::size_t>(device.p.stop_button)] = 1;
  expect_intent(device.play(0.2), State::stopped, Influence::stop, 0.0, 0.0);
  device.message.buttons[static_cast<std::size_t>(device.p.stop_button)] = 0;
  EXPECT_EQ(device.play(0.2).state, State::shared);
  release();
  expect_intent(device.play(0.2), State::hold, Influence::shared, 0.5, 0.0);
  device.hand = origin + Eigen::Vector3d(5.0, 5.0, 5.0);  // with the clutch released it may jump
  EXPECT_EQ(device.play(2.1).state, State::autonomy);
}

// thumb_stick_horizontal, thumb_stick_vertical, press_index, press_middle; the frame is aligned: y is left.
TEST(Devices, Quest2Ros) {
  Device device("quest2ros", {0, 0, 0, 0}, 2, 72.0);
  steer_by_hand(
      device, {0.0, 0.3, 0.0}, [&] { device.message.axes[3] = 0.8F; }, [&] { device.message.axes[3] = 0.0F; });
  device.message.axes[2] = 1.0F;  // the other trigger is no clutch
  EXPECT_EQ(device.play(0.2).state, State::autonomy);
  device.message.axes[1] = -1.0F;
  EXPECT_EQ(device.play(0.2).state, State::stopped);
}

// Track pad x, y, trigger; menu, trigger, pad, grip. OpenVR's x is right.
TEST(Devices, Vive) {
  Device device("vive", {0, 0, 0}, 4, 30.0);
  device.stamped = true;
  steer_by_hand(
      device, {-0.3, 0.0, 0.0},
      [&] {
        device.message.axes[2] = 1.0F;
        device.message.buttons[1] = 1;
      },
      [&] { device.let_go(); });
  device.message.axes[1] = -1.0F;  // a thumb at the pad's lower edge
  EXPECT_EQ(device.play(0.2).state, State::autonomy);
}

// i: straight on, u: on and left, j: turn left, comma: back, k: stop. One message for a key press, no more.
TEST(Devices, KeyboardTwist) {
  Person person(shipped("keyboard"));
  const auto key = [&person](double time, double v, double omega) {
    TwistMessage message;
    message.u = {v, omega};
    message.received = time;
    message.sender = "/teleop_twist_keyboard";
    EXPECT_EQ(person.machine.receive(message), "");
  };
  EXPECT_EQ(person.cycle(100.0).state, State::autonomy);
  key(100.1, 0.0, 0.0);  // k
  EXPECT_EQ(person.cycle(100.1).state, State::autonomy);
  key(101.0, 0.5, 1.0);  // u
  expect_intent(person.cycle(101.0), State::shared, Influence::shared, 0.5, 1.0);
  expect_intent(person.cycle(105.0), State::shared, Influence::shared, 0.5,
                1.0);    // a key once pressed counts on
  key(105.1, 0.5, 0.0);  // i
  expect_intent(person.cycle(105.1), State::shared, Influence::shared, 0.5, 0.0);
  key(106.0, 0.0, 1.0);  // j
  expect_intent(person.cycle(106.0), State::shared, Influence::shared, 0.0, 1.0);
  key(106.5, -0.5, 0.0);  // comma: a Twist is no pulled stick
  expect_intent(person.cycle(106.5), State::shared, Influence::shared, -0.5, 0.0);
  key(107.0, 0.5, 0.0);
  person.cycle(107.0);
  key(108.0, 0.0, 0.0);  // k
  expect_intent(person.cycle(108.0), State::hold, Influence::shared, 0.5, 0.0);
  expect_intent(person.cycle(110.1), State::autonomy, Influence::none, 0.0, 0.0);
}

}  // namespace
}  // namespace hidwa_local_planner::input
