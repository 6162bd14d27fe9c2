// SPDX-License-Identifier: BSD-3-Clause
#include "hidwa_local_planner/ros/plan_tracker.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace hidwa_local_planner {
namespace {

using Plan = std::vector<geometry_msgs::PoseStamped>;

/// From the origin along x to `length` [m], a pose every 0.1 m.
Plan straight(double length, double goal_yaw = 0.0, const std::string& frame = "map") {
  Plan plan;
  const int steps = static_cast<int>(std::lround(length / 0.1));
  for (int i = 0; i <= steps; ++i) {
    geometry_msgs::PoseStamped pose;
    pose.header.frame_id = frame;
    pose.pose = to_message({0.1 * i, 0.0, i == steps ? goal_yaw : 0.0});
    plan.push_back(pose);
  }
  return plan;
}

TEST(PlanTracker, OnlyAChangedLastPoseIsANewGoal) {
  PlanTracker tracker;
  EXPECT_FALSE(tracker.fault().empty());
  EXPECT_TRUE(tracker.set(straight(3.0)));
  EXPECT_TRUE(tracker.fault().empty());
  EXPECT_FALSE(tracker.set(straight(3.0)));
  Plan shorter = straight(3.0);
  shorter.erase(shorter.begin(), shorter.begin() + 10);  // a replan from further on
  EXPECT_FALSE(tracker.set(shorter));
  EXPECT_TRUE(tracker.set(straight(3.1)));
  EXPECT_TRUE(tracker.set(straight(3.1, 0.5)));
  EXPECT_TRUE(tracker.set(straight(3.1, 0.5, "odom")));
  EXPECT_FALSE(tracker.set(straight(3.1, 0.5, "/odom")));
}

TEST(PlanTracker, AReachedGoalIsNewWhenItComesAgain) {
  PlanTracker tracker;
  tracker.set(straight(3.0));
  tracker.finish();
  EXPECT_TRUE(tracker.set(straight(3.0)));
}

TEST(PlanTracker, AnUnusablePlanIsNoNewGoal) {
  PlanTracker tracker;
  tracker.set(straight(3.0));
  EXPECT_FALSE(tracker.set({}));
  EXPECT_NE(tracker.fault().find("empty"), std::string::npos);
  EXPECT_FALSE(tracker.set(straight(3.0)));  // the same goal as before
  EXPECT_TRUE(tracker.fault().empty());

  Plan bad = straight(1.0);
  bad[3].pose.position.x = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(tracker.set(bad));
  EXPECT_NE(tracker.fault().find("not a number"), std::string::npos);
  bad = straight(1.0);
  bad[3].header.frame_id = "odom";
  tracker.set(bad);
  EXPECT_NE(tracker.fault().find("mixes"), std::string::npos);
  tracker.set(straight(1.0, 0.0, ""));
  EXPECT_NE(tracker.fault().find("no frame"), std::string::npos);
}

TEST(PlanTracker, TheWindowIsInTheOuterFrame) {
  PlanTracker tracker;
  tracker.set(straight(5.0));
  // The plan's frame lies at (10, 20) in the costmap's, turned left by 90 degrees: plan x is costmap y.
  const FrameTransform transform{{10.0, 20.0, M_PI / 2}};
  std::vector<Pose2> window;
  tracker.window(transform, {10.0, 22.0, M_PI / 2}, 0.5, 1.0, window);  // the robot at 2 m of the plan
  ASSERT_FALSE(window.empty());
  EXPECT_NEAR(window.front().x, 10.0, 1e-9);
  EXPECT_NEAR(window.front().y, 21.5, 0.1 + 1e-9);
  EXPECT_NEAR(window.back().y, 23.0, 0.1 + 1e-9);
  EXPECT_NEAR(window.back().theta, M_PI / 2, 1e-9);
}

}  // namespace
}  // namespace hidwa_local_planner
