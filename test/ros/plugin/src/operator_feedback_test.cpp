// SPDX-License-Identifier: BSD-3-Clause
// What the person is told: the state, the stick's motor, markers.
#include <algorithm>
#include <cmath>

#include <sensor_msgs/JoyFeedbackArray.h>
#include <visualization_msgs/MarkerArray.h>

#include "change.hpp"
#include "person.hpp"

namespace hidwa_plugin_tests {
namespace {

constexpr double kToWall = 1.8;  // [m]

/// The stick's motor.
class Motor {
 public:
  explicit Motor(const std::string& topic) : heard_(topic) {}
  std::vector<float> felt() const {
    std::vector<float> intensities;
    for (const sensor_msgs::JoyFeedbackArray& message : heard_.all()) {
      for (const sensor_msgs::JoyFeedback& part : message.array) {
        EXPECT_EQ(part.type, sensor_msgs::JoyFeedback::TYPE_RUMBLE);
        intensities.push_back(part.intensity);
      }
    }
    return intensities;
  }
  void forget() { heard_.forget(); }
  bool silent() const { return felt().empty() || felt().back() == 0.0f; }

 private:
  Messages<sensor_msgs::JoyFeedbackArray> heard_;
};

class Feedback : public Operated {
 protected:
  /// On at the wall, hardly turning, until the robot stands before it.
  void steer_at_the_wall() {
    Stage::get().robot.wall_ahead(kToWall);
    person().left = 0.15f;
    ASSERT_TRUE(reaches("SHARED"));
    ASSERT_TRUE(cycle_until(
        [this](const Host::Cycle& c) { return !state().refused_by.empty() && std::abs(c.command.linear.x) < 0.05; }));
  }
  /// The motor falls silent, not merely for want of messages, and nothing follows.
  void expect_ends(const Motor& motor) {
    ASSERT_TRUE(cycle_until([&](const Host::Cycle&) { return motor.silent(); }));
    const std::size_t ended = motor.felt().size();
    EXPECT_GT(ended, 0u);
    pass_cycles(0.3);
    EXPECT_EQ(motor.felt().size(), ended);
  }
};

TEST_F(Feedback, TheStateTellsEverything) {
  start();
  drive();
  person().left = 0.8f;
  ASSERT_TRUE(reaches("SHARED"));
  const double wanted = std::pow(static_cast<double>(0.8f), 2);
  Host::Cycle last;
  ASSERT_TRUE(
      cycle_until([&](const Host::Cycle& c) { return last = c, std::abs(c.command.angular.z - wanted) < 0.01; }));
  ASSERT_TRUE(wait_for([&] { return state().command.angular.z == last.command.angular.z; }));
  const OperatorState steered = state();
  EXPECT_EQ(steered.mode, OperatorState::MODE_JOYSTICK);
  EXPECT_EQ(steered.mode_name, "joystick");
  EXPECT_EQ(steered.state, OperatorState::SHARED);
  EXPECT_EQ(steered.state_name, "SHARED");
  EXPECT_TRUE(steered.active);
  EXPECT_EQ(steered.header.frame_id, "odom");
  EXPECT_DOUBLE_EQ(steered.wanted.linear.x, 0.5);
  EXPECT_DOUBLE_EQ(steered.wanted.angular.z, wanted);
  EXPECT_EQ(steered.command.linear.x, last.command.linear.x);
  EXPECT_GT(steered.agreement, 0.97);
  EXPECT_EQ(steered.refused_by, "");
  EXPECT_GE(steered.input_age, 0.0);
  EXPECT_LT(steered.input_age, 0.3);
  EXPECT_EQ(steered.dropped, 0u);

  person().left = 2.0f;  // no stick can
  ASSERT_TRUE(cycle_until([this](const Host::Cycle&) { return state().dropped > 0; }));
  person().left = 0.0f;
  ASSERT_TRUE(reaches("AUTONOMY"));

  steer_at_the_wall();
  EXPECT_TRUE(state().refused_by == "Collision" || state().refused_by == "Braking") << state().refused_by;
  EXPECT_LT(state().agreement, 0.7);
  for (const OperatorState& each : person().states()) {
    EXPECT_GE(each.agreement, 0.0);
    EXPECT_LE(each.agreement, 1.0);
  }
}

TEST_F(Feedback, TheStickRumblesTheMoreTheLessIsDone) {
  start();
  Motor motor("joy/set_feedback");
  drive();
  EXPECT_TRUE(motor.felt().empty());
  person().left = 0.3f;
  ASSERT_TRUE(
      cycle_until([&](const Host::Cycle&) { return state().active && state().agreement > 0.98 && motor.silent(); }));
  motor.forget();
  EXPECT_TRUE(all_cycles([](const Host::Cycle& c) { return c.success; }, 0.5));
  EXPECT_TRUE(motor.felt().empty());  // silent where the robot does what is wanted
  person().left = 0.0f;
  ASSERT_TRUE(reaches("AUTONOMY"));
  motor.forget();

  steer_at_the_wall();
  const std::vector<float> rising = motor.felt();
  ASSERT_GT(rising.size(), 3u);
  EXPECT_LT(rising.front(), 0.3f);
  EXPECT_GT(rising.back(), 0.4f);
  // As strong as the newest disagreement.
  ASSERT_TRUE(cycle_until([&](const Host::Cycle&) {
    return !motor.felt().empty() && std::abs(motor.felt().back() - (1.0 - state().agreement)) < 1e-6;
  }));

  person().left = 0.0f;
  ASSERT_TRUE(cycle_until([this](const Host::Cycle&) { return !state().active; }));
  expect_ends(motor);
}

TEST_F(Feedback, AnotherMotorTakesOver) {
  set("rumble_topic", in_namespace("first"));
  start();
  const Motor first(in_namespace("first"));
  drive();
  steer_at_the_wall();
  ASSERT_FALSE(first.silent());
  ASSERT_TRUE(Change().set("rumble_topic", in_namespace("second")).send(host()));
  expect_ends(first);
}

TEST_F(Feedback, MarkersArePublished) {
  start();
  const Messages<visualization_msgs::MarkerArray> shown(in_namespace("operator_markers"));
  drive();
  person().left = 1.0f;
  ASSERT_TRUE(reaches("SHARED"));
  EXPECT_TRUE(cycle_until([&](const Host::Cycle&) {
    const visualization_msgs::MarkerArray newest = shown.newest();
    return std::any_of(newest.markers.begin(), newest.markers.end(), [](const auto& marker) {
      return marker.header.frame_id == "base_link" && marker.text.find("SHARED") != std::string::npos;
    });
  }));
}

}  // namespace
}  // namespace hidwa_plugin_tests
