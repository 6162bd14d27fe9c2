// SPDX-License-Identifier: BSD-3-Clause
// A person at the real Joy topic: steering, release, silence.
#include <cmath>

#include <gtest/gtest.h>
#include <hidwa_local_planner/OperatorState.h>
#include <sensor_msgs/Joy.h>

#include "stage.hpp"

namespace hidwa_plugin_tests {
namespace {

using hidwa_local_planner::OperatorState;

class Person : public ::testing::Test {
 protected:
  Person() : host_(start()) {
    publisher_ = node_.advertise<sensor_msgs::Joy>("joy", 1);
    ros::NodeHandle topics("~/" + host_.name());
    state_subscriber_ = topics.subscribe<OperatorState>("operator_state", 10, [this](const OperatorState::ConstPtr& m) {
      const std::lock_guard<std::mutex> lock(mutex_);
      state_ = *m;
    });
    // A stick that nobody hears steers nothing.
    wait_for([this] { return publisher_.getNumSubscribers() > 0 && state_subscriber_.getNumPublishers() > 0; });
  }

  static std::string start() {
    const std::string name = ::testing::UnitTest::GetInstance()->current_test_info()->name();
    ros::param::set(ros::this_node::getName() + "/" + name + "/delta", 0.5);
    return name;
  }

  void send() {
    if (silent_) return;
    sensor_msgs::Joy message;
    message.header.stamp = ros::Time::now();
    message.axes = {stick_, 0.0f};
    message.buttons = {0};
    deliver(publisher_, message);
  }

  OperatorState state() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return state_;
  }

  bool reaches(const std::string& name, double seconds = kPatience) {
    return host_.cycle_until([&](const Host::Cycle&) { return state().state_name == name; }, seconds);
  }

  void drive() {
    ASSERT_TRUE(host_.plan_ahead(8.0));
    ASSERT_TRUE(host_.cycle_until([](const Host::Cycle& c) { return c.command.linear.x > 0.49; }));
    EXPECT_EQ(state().state_name, "AUTONOMY");
  }

  ros::NodeHandle node_;
  Host host_;
  float stick_ = 0.0f;
  bool silent_ = false;
  ros::Publisher publisher_;
  ros::Subscriber state_subscriber_;
  mutable std::mutex mutex_;
  OperatorState state_;
  Ticking ticking_{[this] { send(); }};
};

TEST_F(Person, SteersLetsGoAndTheRobotTakesOver) {
  drive();
  stick_ = 1.0f;  // left
  ASSERT_TRUE(reaches("SHARED"));
  EXPECT_TRUE(state().active);
  EXPECT_DOUBLE_EQ(state().wanted.linear.x, 0.5);
  EXPECT_DOUBLE_EQ(state().wanted.angular.z, 1.0);
  ASSERT_TRUE(host_.cycle_until([](const Host::Cycle& c) { return c.command.angular.z > 0.9; }));

  stick_ = 0.0f;
  ASSERT_TRUE(reaches("HOLD"));
  EXPECT_DOUBLE_EQ(state().wanted.linear.x, 0.5);
  EXPECT_DOUBLE_EQ(state().wanted.angular.z, 0.0);
  EXPECT_TRUE(host_.cycle_until(
      [this](const Host::Cycle& c) { return c.command.angular.z == 0.0 && state().state_name == "HOLD"; }));
  EXPECT_TRUE(reaches("AUTONOMY"));
  EXPECT_FALSE(state().active);
}

TEST_F(Person, RightIsNegative) {
  drive();
  stick_ = -1.0f;
  EXPECT_TRUE(host_.cycle_until([](const Host::Cycle& c) { return c.command.angular.z < -0.9; }));
}

TEST_F(Person, SilenceWhileSteeringIsLost) {
  drive();
  stick_ = 1.0f;
  ASSERT_TRUE(reaches("SHARED"));
  silent_ = true;
  ASSERT_TRUE(reaches("LOST"));
  EXPECT_DOUBLE_EQ(state().wanted.angular.z, 0.0);
  EXPECT_GT(state().input_age, 0.4);
  // Back, but not centred yet: it does not count.
  silent_ = false;
  EXPECT_FALSE(reaches("SHARED", 0.7));
  stick_ = 0.0f;
  ASSERT_TRUE(reaches("AUTONOMY"));
  host_.cycle_until([](const Host::Cycle&) { return false; }, 0.2);
  stick_ = 1.0f;
  EXPECT_TRUE(reaches("SHARED"));
}

TEST_F(Person, MessagesThatMakeNoSenseAreCounted) {
  drive();
  sensor_msgs::Joy none;  // no axes
  publisher_.publish(none);
  EXPECT_TRUE(host_.cycle_until([this](const Host::Cycle& c) { return c.success && state().dropped > 0; }));
}

}  // namespace
}  // namespace hidwa_plugin_tests

int main(int argc, char** argv) {
  ros::init(argc, argv, "operator_test");
  ros::NodeHandle node;
  ::testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
