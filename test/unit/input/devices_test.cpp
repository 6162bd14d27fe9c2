// SPDX-License-Identifier: BSD-3-Clause
// The parameter sets that come with the planner, against messages of exactly their device's shape.
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "person.hpp"

namespace hidwa_local_planner::input {
namespace {

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

/// Some sticks, whose axes 0 and 1 go to the side and forward. Forward is +1.
struct Sticks {
  const char* name;
  const char* parameters;   // the file's name
  std::vector<float> rest;  // the axes at rest
  std::size_t buttons;      // their number
  double rate;              // [Hz]
  bool stamped;
  float left;  // what axis 0 sends for it
  int stop;    // the button; -1: none
  std::size_t toggle;
};

// xpad's axes: left x, left y, left trigger, right x, right y, right trigger, cross x, cross y. joy_node says 0 for a
// trigger until it first moves. The Quest's axes: left x, left y, right x, right y, triggers, grips.
const Sticks kSticks[] = {
    {"xbox on joy_node", "xbox", {0, 0, 1, 0, 0, 1, 0, 0}, 11, 20.0, true, 1.0F, 1, 3},
    {"xbox before a trigger moved", "xbox", {0, 0, 0, 0, 0, 0, 0, 0}, 11, 20.0, true, 1.0F, 1, 3},
    {"ps4 on joy_node", "ps4", {0, 0, 1, 0, 0, 1, 0, 0}, 13, 20.0, true, 1.0F, 1, 2},
    {"quest at 72 Hz", "quest_joystick", {0, 0, 0, 0, 0, 0, 0, 0}, 17, 72.0, false, -1.0F, 2, 0},
    {"quest at 120 Hz", "quest_joystick", {0, 0, 0, 0, 0, 0, 0, 0}, 17, 120.0, false, -1.0F, 2, 0},
    {"unity_ros_tcp without stamps", "unity_tcp", {0, 0}, 2, 50.0, false, -1.0F, -1, 0},
    {"unity_ros_tcp with stamps", "unity_tcp", {0, 0}, 2, 50.0, true, -1.0F, -1, 0},
};

void steer_and_stop(Device& device, const Sticks& sticks) {
  std::vector<float>& axes = device.message.axes;
  expect_autonomy(device.play(0.2));
  axes[0] = sticks.left;
  expect_shared(device.play(0.2), 0.5, 1.0);  // 1^2 * max_vel_theta
  axes[0] = -1.00003F * sticks.left;          // joy_node overshoots by rounding
  expect_shared(device.play(0.2), 0.5, -1.0);
  axes[0] = -0.5F * sticks.left;
  expect_shared(device.play(0.2), 0.5, -0.25);  // -(0.5^2)
  axes[1] = -1.0F;
  expect_stopped(device.play(0.2));
  axes[1] = 1.0F;
  expect_shared(device.play(0.2), 0.5, -0.25);
  if (sticks.stop >= 0) {
    int& stop = device.message.buttons[static_cast<std::size_t>(sticks.stop)];
    stop = 1;
    expect_stopped(device.play(0.2));
    stop = 0;
    EXPECT_EQ(device.play(0.2).state, State::shared);
  }
  device.let_go();
  expect_hold(device.play(0.2), 0.5);
  expect_autonomy(device.play(2.1));  // delta 2 s
}

void play_with_all_that_nobody_reads(Device& device, const Sticks& sticks) {
  for (std::size_t k = 2; k < sticks.rest.size(); ++k) device.message.axes[k] = sticks.rest[k] > 0 ? -1.0F : 1.0F;
  device.message.buttons.assign(sticks.buttons, 1);
  if (sticks.stop >= 0) device.message.buttons[static_cast<std::size_t>(sticks.stop)] = 0;
  expect_autonomy(device.play(0.2));
  device.let_go();
}

/// In mode switching.
void take_control_and_give_it_back(Device& device, const Sticks& sticks) {
  device.set_mode(OperatorMode::switching);
  const auto press = [&] {
    device.message.buttons[sticks.toggle] = 1;
    device.play(0.1);
    device.message.buttons[sticks.toggle] = 0;
    return device.play(0.1);
  };
  for (int i = 0; i < 5; ++i) EXPECT_EQ(device.play(0.1).state, State::autonomy);
  expect_manual(press(), 0.0, 0.0);
  device.message.axes[0] = sticks.left;
  device.message.axes[1] = 0.5F;
  expect_manual(device.play(0.1), 0.125, 1.0);  // 0.5^2 * 0.5, 1^2
  device.let_go();
  expect_manual(device.play(0.1), 0.0, 0.0);
  expect_autonomy(press());
}

TEST(Devices, SticksSteerStopAndTakeControl) {
  for (const Sticks& sticks : kSticks) {
    SCOPED_TRACE(sticks.name);
    Device device(sticks.parameters, sticks.rest, sticks.buttons, sticks.rate);
    device.stamped = sticks.stamped;
    steer_and_stop(device, sticks);
    play_with_all_that_nobody_reads(device, sticks);
    take_control_and_give_it_back(device, sticks);
  }
}

TEST(Devices, TheQuestsTopicIsThatOfUnityRosTeleoperation) {
  EXPECT_EQ(shipped("quest_joystick").joy_topic, "/quest/joystick");
}

/// A hand that is moved by `left` (full deflection), half of it back to the right and so on, while `press`
/// and `release` work its clutch.
template <typename Press, typename Release>
void steer_by_hand(Device& device, const Eigen::Vector3d& left, Press press, Release release) {
  EXPECT_EQ(device.p.mode, OperatorMode::gesture);
  expect_autonomy(device.play(0.2));
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
  expect_stopped(device.play(0.2));
  device.message.buttons[static_cast<std::size_t>(device.p.stop_button)] = 0;
  EXPECT_EQ(device.play(0.2).state, State::shared);
  release();
  expect_hold(device.play(0.2), 0.5);
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
    return person.cycle_with(from("/teleop_twist_keyboard", twist_at(time, v, omega)));
  };
  EXPECT_EQ(person.cycle(100.0).state, State::autonomy);
  EXPECT_EQ(key(100.1, 0.0, 0.0).state, State::autonomy);  // k
  expect_shared(key(101.0, 0.5, 1.0), 0.5, 1.0);           // u
  expect_shared(person.cycle(105.0), 0.5, 1.0);            // a key once pressed counts on
  expect_shared(key(105.1, 0.5, 0.0), 0.5, 0.0);           // i
  expect_shared(key(106.0, 0.0, 1.0), 0.0, 1.0);           // j
  expect_shared(key(106.5, -0.5, 0.0), -0.5, 0.0);         // comma: a Twist is no pulled stick
  key(107.0, 0.5, 0.0);
  expect_hold(key(108.0, 0.0, 0.0), 0.5);  // k
  expect_autonomy(person.cycle(110.1));
  EXPECT_EQ(person.machine.dropped(), 0U);
}

}  // namespace
}  // namespace hidwa_local_planner::input
