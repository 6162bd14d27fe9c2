// SPDX-License-Identifier: BSD-3-Clause
// Mode gesture over its real topics: the hand as PoseStamped or in tf, the clutch on the stick.
#include <memory>

#include <geometry_msgs/PoseStamped.h>

#include "person.hpp"

namespace hidwa_plugin_tests {
namespace {

/// The hand's tracker, once a period, half a metre in front of the head and off to its left by `left` [m].
class Gesture : public Operated {
 protected:
  enum class Tracker { silent, topic, topic_lost, tf, tf_repeats };

  void start_gesture() {
    set("mode", "gesture");
    set("delta", 0.5);
    start();
    publisher_ = node_.advertise<geometry_msgs::PoseStamped>("hand_pose", 1);
    ticking_ = std::make_unique<Ticking>([this] { track(); });
  }

  void track() {
    if (tracker_ == Tracker::tf || tracker_ == Tracker::tf_repeats) {
      geometry_msgs::TransformStamped hand;
      if (tracker_ == Tracker::tf) stamp_ = ros::Time::now();
      hand.header.stamp = stamp_;
      hand.header.frame_id = "head";
      hand.child_frame_id = "hand";
      hand.transform.translation.x = 0.5;
      hand.transform.translation.y = left_;
      hand.transform.rotation.w = 1.0;
      Stage::get().tf.setTransform(hand, "tracker", false);
    } else if (tracker_ != Tracker::silent) {
      geometry_msgs::PoseStamped hand;
      hand.header.stamp = ros::Time::now();
      hand.header.frame_id = "head";
      hand.pose.position.x = 0.5;
      hand.pose.position.y = left_;
      if (tracker_ == Tracker::topic) hand.pose.orientation.w = 1.0;
      deliver(publisher_, hand);
    }
  }

  /// Presses the clutch where the hand is; every cycle until it counts is nobody's.
  void press_clutch() {
    person().button = true;
    EXPECT_TRUE(all_cycles([this](const Host::Cycle&) { return !state().active; }, 0.3));
  }
  void release_clutch() {
    person().button = false;
    EXPECT_TRUE(reaches("AUTONOMY"));
    // The release has come, too, where it was AUTONOMY before.
    EXPECT_TRUE(all_cycles([this](const Host::Cycle&) { return !state().active; }, 0.2));
  }

  ros::NodeHandle node_;
  Tracker tracker_ = Tracker::topic;
  double left_ = 0.0;
  ros::Time stamp_;
  ros::Publisher publisher_;
  std::unique_ptr<Ticking> ticking_;
};

TEST_F(Gesture, TheHandSteersWhileTheClutchIsHeld) {
  start_gesture();
  drive();
  left_ = 0.2;
  EXPECT_TRUE(all_cycles([this](const Host::Cycle&) { return !state().active; }, 0.4));  // no clutch

  press_clutch();  // the origin is where the hand is now
  left_ = 0.35;    // half of gesture_range to the left: 0.5^2 of 1 rad/s
  ASSERT_TRUE(reaches("SHARED"));
  EXPECT_EQ(state().mode, OperatorState::MODE_GESTURE);
  EXPECT_NEAR(state().wanted.angular.z, 0.25, 1e-6);
  EXPECT_DOUBLE_EQ(state().wanted.linear.x, 0.5);
  EXPECT_TRUE(cycle_until([](const Host::Cycle& c) { return std::abs(c.command.angular.z - 0.25) < 0.01; }));

  person().button = false;
  ASSERT_TRUE(reaches("HOLD"));
  EXPECT_DOUBLE_EQ(state().wanted.angular.z, 0.0);
  ASSERT_TRUE(reaches("AUTONOMY"));

  press_clutch();  // anew: another origin
  left_ = 0.2;
  ASSERT_TRUE(reaches("SHARED"));
  EXPECT_NEAR(state().wanted.angular.z, -0.25, 1e-6);
  expect_within_limits();
}

TEST_F(Gesture, ATriggerBeyondItsThresholdIsAClutch) {
  set("clutch_axis", 2);
  start_gesture();
  drive();
  person().button = true;  // means nothing now
  person().trigger = 0.4f;
  EXPECT_TRUE(all_cycles([this](const Host::Cycle&) { return !state().active; }, 0.3));
  left_ = 0.2;
  EXPECT_TRUE(all_cycles([this](const Host::Cycle&) { return !state().active; }, 0.3));
  person().trigger = 0.6f;
  EXPECT_TRUE(all_cycles([this](const Host::Cycle&) { return !state().active; }, 0.3));
  left_ = 0.0;
  ASSERT_TRUE(reaches("SHARED"));
  EXPECT_LT(state().wanted.angular.z, -0.4);
  person().trigger = 0.4f;
  EXPECT_TRUE(reaches("HOLD"));
}

TEST_F(Gesture, AHandInTfSteersAndItsSilenceIsALoss) {
  set("gesture_frame", "hand");
  set("gesture_parent_frame", "head");
  tracker_ = Tracker::tf;
  start_gesture();
  drive();
  for (const Tracker silence : {Tracker::tf_repeats, Tracker::silent}) {
    left_ = 0.0;
    press_clutch();
    left_ = 0.3;
    ASSERT_TRUE(reaches("SHARED"));
    EXPECT_NEAR(state().wanted.angular.z, 1.0, 1e-6);
    EXPECT_TRUE(all_cycles([this](const Host::Cycle&) { return state().state_name == "SHARED"; }, 0.7));
    tracker_ = silence;  // also where the same transform comes again and again
    ASSERT_TRUE(reaches("LOST"));
    EXPECT_DOUBLE_EQ(state().wanted.angular.z, 0.0);
    tracker_ = Tracker::tf;
    release_clutch();
  }
}

TEST_F(Gesture, AHandWithoutOrientationIsLostAtOnce) {
  start_gesture();
  drive();
  press_clutch();
  left_ = 0.3;
  ASSERT_TRUE(reaches("SHARED"));
  tracker_ = Tracker::topic_lost;
  // Poses go on to come, and no timeout says so, which would be 0.5 s.
  ASSERT_TRUE(reaches("LOST", 0.4));
  EXPECT_DOUBLE_EQ(state().wanted.angular.z, 0.0);
  EXPECT_GT(state().dropped, 0u);
  // Tracked again, but the clutch is still held: that hand's origin is gone.
  tracker_ = Tracker::topic;
  EXPECT_TRUE(all_cycles([this](const Host::Cycle&) { return state().wanted.angular.z == 0.0; }, 0.5));
  release_clutch();
  press_clutch();
  left_ = 0.0;
  EXPECT_TRUE(reaches("SHARED"));
}

}  // namespace
}  // namespace hidwa_plugin_tests

int main(int argc, char** argv) {
  ros::init(argc, argv, "gesture_test");
  ros::NodeHandle node;
  ::testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
