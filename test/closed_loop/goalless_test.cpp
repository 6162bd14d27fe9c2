// SPDX-License-Identifier: BSD-3-Clause
// Without a goal the robot does what its operator means: walls, doorways, posts and corners that the stick alone would
// run into, and what must stop it.
#include "goalless_scenes.hpp"

#include <cstdio>
#include <string>

#include <gtest/gtest.h>

#include "support/effort.hpp"

namespace hidwa_local_planner::test {
namespace {

constexpr double kDegree = M_PI / 180.0;

class Goalless : public testing::TestWithParam<const char*> {};

// Of the scenes that are asked for, nine in ten are passed without a stop; none is touched in any.
TEST_P(Goalless, WhatIsMeantIsDriven) {
  const std::string kind = GetParam();
  const Parameters p = goalless_parameters();
  const int scenes = effort(9, 501);
  int passed = 0;
  for (int k = 0; k < scenes; ++k) {
    SCOPED_TRACE(kind + " " + std::to_string(k));
    Random random(47000 + static_cast<std::uint64_t>(k) + 1000000 * static_cast<std::uint64_t>(kind[0]));
    const GoallessScene scene = make_scene(kind, k % 3, random);
    GoallessPlanner planner(scene, p);
    const GoallessRun run = run_goalless(scene, p, std::ref(planner));
    EXPECT_FALSE(run.touched);
    EXPECT_FALSE(run.against);
    EXPECT_LT(run.most_off, 32.5 * kDegree);  // 30 degrees, and a little to keep clear of a wall
    if (run.passed && kind != "wall") {
      EXPECT_LT(run.off_at_end, 3.0 * kDegree);
    }
    passed += run.passed && !run.stopped ? 1 : 0;
  }
  std::printf("%s: %d of %d passed without a stop\n", kind.c_str(), passed, scenes);
  EXPECT_GE(10 * passed, 9 * scenes);
}

INSTANTIATE_TEST_SUITE_P(Scenes, Goalless, testing::Values("wall", "doorway", "post", "corner"),
                         [](const auto& kind) { return std::string(kind.param); });

GoallessScene free_scene(const Twist2& stick) {
  GoallessScene scene;
  scene.outline = goalless_outline(1);
  scene.stick = stick;
  scene.finish = 100.0;
  return scene;
}

/// Where the robot ends, and its last command, after `seconds`.
struct End {
  GoallessRun run;
  Twist2 command;
  Pose2 pose;
  std::string rejected_by;
};
End drive_for(const GoallessScene& scene, double seconds, const std::function<Twist2(double)>& stick) {
  GoallessScene changing = scene;
  GoallessPlanner planner(changing, goalless_parameters());
  End end;
  end.run = run_goalless(
      changing, goalless_parameters(),
      [&](const control::Observation& seen) {
        changing.stick = stick(seen.timing.now);
        end.pose = seen.pose;
        end.command = planner(seen);
        end.rejected_by = planner.rejected_by();
        return end.command;
      },
      seconds);
  return end;
}

TEST(Goalless, InTheOpenTheStickIsDriven) {
  for (const Twist2& stick : {Twist2{0.6, 0.0}, {0.6, 0.4}, {-0.15, 0.3}, {0.3, -0.9}}) {
    const End end = drive_for(free_scene(stick), 4.0, [&](double) { return stick; });
    EXPECT_NEAR(end.command.v, stick.v, 1e-9);
    EXPECT_NEAR(end.command.omega, stick.omega, 0.02);  // it keeps to the direction that the turn began with
  }
}

TEST(Goalless, AWallMetSquarelyStopsTheRobotWhichDoesNotTurnAndSaysWhy) {
  GoallessScene scene = free_scene({0.6, 0.0});
  scene.world.walls.push_back({{2.0, -5.0}, {2.0, 5.0}});
  const End end = drive_for(scene, 12.0, [](double) { return Twist2{0.6, 0.0}; });
  EXPECT_TRUE(end.run.stopped);
  EXPECT_LT(end.run.most_off, 2.0 * kDegree);
  EXPECT_GT(end.pose.x, 1.3);  // its front, 0.3 m ahead of its centre, is within 0.4 m of the wall
  EXPECT_TRUE(end.rejected_by == "Collision" || end.rejected_by == "Braking") << end.rejected_by;
}

TEST(Goalless, ATableOfTwoMetresIsNotDrivenRound) {
  GoallessScene scene = free_scene({0.5, 0.0});
  scene.world.walls = {{{1.5, -1.0}, {1.5, 1.0}}, {{1.5, 1.0}, {2.5, 1.0}}, {{1.5, -1.0}, {2.5, -1.0}}};
  const End end = drive_for(scene, 12.0, [](double) { return Twist2{0.5, 0.0}; });
  EXPECT_TRUE(end.run.stopped);
  EXPECT_LT(end.pose.x, 1.5);
}

// A stick held back drives back, never forwards, and round a post as well.
TEST(Goalless, BackwardsRoundAPost) {
  GoallessScene scene = free_scene({-0.2, 0.0});
  scene.world.posts.push_back({{-1.2, 0.12}, 0.05});
  const End end = drive_for(scene, 16.0, [](double) { return Twist2{-0.2, 0.0}; });
  EXPECT_FALSE(end.run.touched);
  EXPECT_LT(end.pose.x, -1.9);
}

TEST(Goalless, ACentredStickMovesNothing) {
  const End end = drive_for(free_scene({}), 2.0, [](double) { return Twist2{}; });
  EXPECT_TRUE(end.command == Twist2{});
  EXPECT_EQ(end.pose.x, 0.0);
}

// While the robot passes a post the operator turns the stick: from then on the direction is what they see.
TEST(Goalless, WhoSteersAnewIsFollowed) {
  GoallessScene scene = free_scene({0.5, 0.0});
  scene.world.posts.push_back({{1.5, 0.1}, 0.1});
  const End end = drive_for(scene, 9.0, [](double now) {
    return now < 4.0 ? Twist2{0.5, 0.0} : now < 5.0 ? Twist2{0.5, -0.8} : Twist2{0.5, 0.0};
  });
  EXPECT_LT(wrap_angle(end.pose.theta), -0.5);  // about 0.8 rad/s for a second, and it stays there
  EXPECT_FALSE(end.run.touched);
}

}  // namespace
}  // namespace hidwa_local_planner::test
