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

class Feedback : public Operated {
 protected:
  static constexpr double kToWall = 1.8;  // [m]

  void feel(const std::string& topic) {
    motor_ = node_.subscribe<sensor_msgs::JoyFeedbackArray>(
        topic, 100, [this](const sensor_msgs::JoyFeedbackArray::ConstPtr& message) {
          const std::lock_guard<std::mutex> lock(mutex_);
          for (const sensor_msgs::JoyFeedback& part : message->array) {
            EXPECT_EQ(part.type, sensor_msgs::JoyFeedback::TYPE_RUMBLE);
            felt_.push_back(part.intensity);
          }
        });
  }
  std::vector<float> felt() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return felt_;
  }
  void forget() {
    const std::lock_guard<std::mutex> lock(mutex_);
    felt_.clear();
  }
  bool silent() const { return felt().empty() || felt().back() == 0.0f; }

  /// On at the wall, hardly turning, until the robot stands before it.
  void steer_at_the_wall() {
    Stage::get().robot.wall_ahead(kToWall);
    person().left = 0.15f;
    ASSERT_TRUE(reaches("SHARED"));
    ASSERT_TRUE(cycle_until(
        [this](const Host::Cycle& c) { return !state().refused_by.empty() && std::abs(c.command.linear.x) < 0.05; }));
  }

  ros::NodeHandle node_;
  mutable std::mutex mutex_;
  std::vector<float> felt_;
  ros::Subscriber motor_;
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
  EXPECT_EQ(state().refused_by == "Collision" || state().refused_by == "Braking", true) << state().refused_by;
  EXPECT_LT(state().agreement, 0.7);
  for (const OperatorState& each : person().states()) {
    EXPECT_GE(each.agreement, 0.0);
    EXPECT_LE(each.agreement, 1.0);
  }
}

TEST_F(Feedback, TheStickRumblesTheMoreTheLessIsDone) {
  start();
  feel("joy/set_feedback");
  drive();
  EXPECT_TRUE(felt().empty());
  person().left = 0.3f;
  ASSERT_TRUE(
      cycle_until([this](const Host::Cycle&) { return state().active && state().agreement > 0.98 && silent(); }));
  forget();
  EXPECT_TRUE(all_cycles([](const Host::Cycle& c) { return c.success; }, 0.5));
  EXPECT_TRUE(felt().empty());  // silent where the robot does what is wanted
  person().left = 0.0f;
  ASSERT_TRUE(reaches("AUTONOMY"));
  forget();

  steer_at_the_wall();
  const std::vector<float> rising = felt();
  ASSERT_GT(rising.size(), 3u);
  EXPECT_LT(rising.front(), 0.3f);
  EXPECT_GT(rising.back(), 0.4f);
  // As strong as the newest disagreement.
  ASSERT_TRUE(cycle_until([this](const Host::Cycle&) {
    return !felt().empty() && std::abs(felt().back() - (1.0 - state().agreement)) < 1e-6;
  }));

  person().left = 0.0f;
  ASSERT_TRUE(cycle_until([this](const Host::Cycle&) { return !state().active && silent(); }));
  const std::size_t ended = felt().size();
  EXPECT_EQ(felt().back(), 0.0f);  // not merely no more messages
  EXPECT_TRUE(all_cycles([](const Host::Cycle&) { return true; }, 0.3));
  EXPECT_EQ(felt().size(), ended);
}

TEST_F(Feedback, AnotherMotorTakesOver) {
  set("rumble_topic", in_namespace("first"));
  start();
  feel(in_namespace("first"));
  drive();
  steer_at_the_wall();
  ASSERT_FALSE(silent());
  ASSERT_TRUE(Change().set("rumble_topic", in_namespace("second")).send(host()));
  ASSERT_TRUE(cycle_until([this](const Host::Cycle&) { return silent(); }));
  const std::size_t ended = felt().size();
  EXPECT_TRUE(all_cycles([](const Host::Cycle&) { return true; }, 0.3));
  EXPECT_EQ(felt().size(), ended);
}

TEST_F(Feedback, MarkersArePublished) {
  start();
  std::vector<visualization_msgs::MarkerArray> shown;
  const ros::Subscriber subscriber = node_.subscribe<visualization_msgs::MarkerArray>(
      in_namespace("operator_markers"), 10, [&](const visualization_msgs::MarkerArray::ConstPtr& message) {
        const std::lock_guard<std::mutex> lock(mutex_);
        shown.push_back(*message);
      });
  drive();
  person().left = 1.0f;
  ASSERT_TRUE(reaches("SHARED"));
  const auto says_shared = [&](const Host::Cycle&) {
    const std::lock_guard<std::mutex> lock(mutex_);
    return !shown.empty() && std::any_of(shown.back().markers.begin(), shown.back().markers.end(), [](const auto& m) {
      return m.header.frame_id == "base_link" && m.text.find("SHARED") != std::string::npos;
    });
  };
  EXPECT_TRUE(cycle_until(says_shared));
}

}  // namespace
}  // namespace hidwa_plugin_tests

int main(int argc, char** argv) {
  ros::init(argc, argv, "operator_feedback_test");
  ros::NodeHandle node;
  ::testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
