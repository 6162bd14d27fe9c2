// SPDX-License-Identifier: BSD-3-Clause
#include "control/twist_watch.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace hidwa_local_planner::control {
namespace {

/// A robot at 20 Hz that moves as `moves`, is commanded `command`, and whose odometry says `says`.
struct Robot {
  void drive(double seconds, const Twist2& moves, const Twist2& command, const Twist2& says) {
    for (int i = 0; 0.05 * i < seconds - 1e-9; ++i) {
      now += 0.05;
      const double middle = pose.theta + 0.025 * moves.omega;
      pose = {pose.x + 0.05 * moves.v * std::cos(middle), pose.y + 0.05 * moves.v * std::sin(middle),
              wrap_angle(pose.theta + 0.05 * moves.omega)};
      watch.observe({now, age, pose, says, command, {1.0, 2.0}});
    }
  }
  TwistWatch watch;
  double now = 100.0, age = 0.0;  // [s]
  Pose2 pose{3.0, -4.0, 3.0};
};

TEST(TwistWatch, DoubtsWhatThePoseAndTheCommandsContradict) {
  for (const Twist2& u : {Twist2{0.5, 0.0}, Twist2{-0.3, 0.0}, Twist2{0.0, 0.8}, Twist2{0.4, -0.6}}) {
    Robot robot;
    robot.drive(0.5, {}, {}, {});
    robot.drive(1.0, u, u, {});
    EXPECT_FALSE(robot.watch.doubts());  // for a second the averages must differ
    robot.drive(1.5, u, u, {});
    EXPECT_TRUE(robot.watch.doubts());
    EXPECT_NEAR(robot.watch.from_pose().v, u.v, 1e-9);
    EXPECT_NEAR(robot.watch.from_pose().omega, u.omega, 1e-9);
  }
}

TEST(TwistWatch, BelievesItAgainAfterTenSecondsOfDriving) {
  Robot robot;
  robot.drive(4.0, {0.5, 0.0}, {0.5, 0.0}, {});
  ASSERT_TRUE(robot.watch.doubts());
  robot.drive(9.0, {0.5, 0.0}, {0.5, 0.0}, {0.5, 0.0});
  robot.drive(60.0, {}, {}, {});  // at rest nothing is learnt
  EXPECT_TRUE(robot.watch.doubts());
  robot.drive(3.0, {0.5, 0.0}, {0.5, 0.0}, {0.5, 0.0});
  EXPECT_FALSE(robot.watch.doubts());
}

// A base that is blocked, slips, is pushed or lags moves otherwise than it was commanded. That is no matter of the
// odometry.
TEST(TwistWatch, DoubtsNothingWhereThePoseDoesNotFollowTheCommands) {
  struct Case {
    Twist2 moves, command, says;
  };
  for (const Case& one : {Case{{}, {0.5, 0.0}, {}}, Case{{}, {0.5, 0.0}, {0.5, 0.0}}, Case{{0.5, 0.0}, {}, {}},
                          Case{{0.1, 0.0}, {0.5, 0.0}, {0.5, 0.0}}, Case{{0.05, 0.0}, {0.05, 0.0}, {}},
                          Case{{0.5, 0.0}, {0.5, 0.0}, {0.3, 0.0}}}) {
    Robot robot;
    robot.drive(20.0, one.moves, one.command, one.says);
    EXPECT_FALSE(robot.watch.doubts()) << one.moves.v << " " << one.command.v << " " << one.says.v;
  }
}

// 2 m/s is what a robot that drives 1 m/s may be pushed to; 2.1 m/s while the pose stands is no velocity.
TEST(TwistWatch, DoubtsWhatNoRobotCanDrive) {
  for (const double says : {2.0, 2.1, 300.0, -300.0}) {
    Robot robot;
    robot.drive(5.0, {}, {}, {});
    robot.drive(15.0, {0.0, 0.0}, {0.1, 0.0}, {says, 0.0});
    EXPECT_EQ(robot.watch.doubts(), std::abs(says) > 2.0) << says;
    Robot pushed;
    pushed.drive(20.0, {says, 0.0}, {}, {says, 0.0});
    EXPECT_FALSE(pushed.watch.doubts()) << says;
  }
}

// The same pose again, and a gap, give no velocity.
TEST(TwistWatch, PosesThatAreNotNewSayNothing) {
  Robot robot;
  robot.drive(4.0, {0.5, 0.0}, {0.5, 0.0}, {});
  robot.age = 0.05;
  robot.now += 0.05;
  robot.watch.observe({robot.now, robot.age, robot.pose, {}, {0.5, 0.0}, {1.0, 2.0}});
  EXPECT_NEAR(robot.watch.from_pose().v, 0.5, 1e-9);
  robot.now += 5.0;
  robot.watch.observe({robot.now, robot.age, {30.0, 0.0, 0.0}, {0.2, 0.0}, {0.5, 0.0}, {1.0, 2.0}});
  EXPECT_EQ(robot.watch.from_pose().v, 0.2);  // as measured, until the next pose
  EXPECT_TRUE(robot.watch.doubts());
}

}  // namespace
}  // namespace hidwa_local_planner::control
