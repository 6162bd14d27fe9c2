// SPDX-License-Identifier: BSD-3-Clause
// What a robot may do that stands in collision.
#include "core/collision/escape.hpp"

#include <gtest/gtest.h>

#include "core/collision/admissibility.hpp"
#include "core/motion/rollout.hpp"
#include "support/round_outline.hpp"
#include "support/scene.hpp"

namespace hidwa_local_planner {
namespace {

using test::Scene;

constexpr double kDelay = 0.15;  // 0.1 s of latency and a period

VelocityLimits limits_of(double min_x, double max_x) {
  VelocityLimits limits;
  limits.x = {min_x, max_x, 2.5, 2.5};
  limits.theta = {-1.0, 1.0, 3.2, 3.2};
  return limits;
}

TEST(EscapeSpeed, StopsWithinHalfACell) {
  const EscapeSpeed speed(limits_of(-0.5, 0.5), 0.3, 0.05, kDelay);
  // 0.15 v + v^2 / 5 = 0.025: v = 2.5 (sqrt(0.15^2 + 2 * 0.025 / 2.5) - 0.15) = 0.14039 m/s.
  EXPECT_NEAR(speed.slowed().x.max, 0.14039, 1e-5);
  EXPECT_NEAR(speed.slowed().x.min, -0.14039, 1e-5);
  EXPECT_NEAR(speed.way({0.14039, 0.0}), 0.025, 1e-5);
  // 0.3 (0.15 w + w^2 / 6.4) = 0.025: w = 3.2 (sqrt(0.15^2 + 2 * 0.0833 / 3.2) - 0.15) = 0.3939 rad/s.
  EXPECT_NEAR(speed.slowed().theta.max, 0.3939, 1e-4);
  EXPECT_TRUE(speed.allows({0.14, 0.0}, {}, 0.05));
  EXPECT_FALSE(speed.allows({0.142, 0.0}, {}, 0.05));
  EXPECT_FALSE(speed.allows({0.1, 0.3}, {}, 0.05));  // 0.017 + 0.018 m
}

TEST(EscapeSpeed, ACircleMayTurnAsEver) {
  const EscapeSpeed speed(limits_of(-0.5, 0.5), 0.0, 0.05, kDelay);
  EXPECT_EQ(speed.slowed().theta.max, 1.0);
  EXPECT_TRUE(speed.allows({0.14, 1.0}, {}, 0.05));
}

TEST(EscapeSpeed, WhoIsFasterBrakes) {
  const EscapeSpeed speed(limits_of(0.0, 0.5), 0.3, 0.05, kDelay);
  // 0.5 - 2.5 * 0.05 = 0.375 m/s after a period.
  EXPECT_TRUE(speed.allows({0.375, 0.0}, {0.5, 0.0}, 0.05));
  EXPECT_FALSE(speed.allows({0.4, 0.0}, {0.5, 0.0}, 0.05));
  EXPECT_FALSE(speed.allows({0.375, 0.2}, {0.5, 0.0}, 0.05));
}

// One robot in one scene, at rest.
class Caught {
 public:
  Caught(const Scene& scene, const Pose2& start, bool steered = false)
      : scene_(scene), pending_(PendingMotion({}, scene.parameters.control_latency)) {
    footprint_ = Footprint::from_outline(scene_.outline, 0.0);
    start_.pose = start_.origin = start;
    start_.limits = VelocityLimits::from(scene.parameters);
    start_.pending = &pending_;
    rule_.look(scene_.parameters, scene_.grid(), footprint_, start_);
    if (!rule_.applies()) return;
    rule_.prepare(1.0, 0.05, 0.4);
    AdmissibilityCheck::Setup setup;
    setup.start = &start_;
    setup.steered = steered;
    setup.escape = &rule_;
    check_.prepare(scene_.parameters, rule_.rest(), footprint_, 0.05, setup);
  }
  Caught(const Caught&) = delete;
  EscapeRule& rule() { return rule_; }
  /// Why it may not; empty where it may.
  std::string rejection(const Twist2& sample) {
    Rollout rollout;
    rollout.run(scene_.parameters, start_, {{sample, SampleKind::grid}}, {}, scene_.parameters.sim_time);
    const char* reason = nullptr;
    check_.check_rollouts(rollout.tile(0), &reason);
    if (reason != nullptr) return reason;
    return check_.can_brake(sample) && check_.confirm_braking(sample) ? "" : "cannot brake";
  }
  bool may(const Twist2& sample) { return rejection(sample).empty(); }

 private:
  Scene scene_;
  CycleStart start_;
  PendingMotionSet pending_;
  Footprint footprint_;
  EscapeRule rule_;
  AdmissibilityCheck check_;
};

// The square of 0.4 m; cells (i, j) span (i - 60.5) * 0.05 on.
Scene square() {
  Scene scene = Scene::empty(121);
  scene.parameters = Parameters();
  scene.parameters.min_vel_x = -0.5;
  return scene;
}

TEST(EscapeRule, InFreeSpaceItDoesNotApply) {
  Scene scene = square();
  scene.fill(0.2, -9.0, 9.0, 9.0);  // from x = 0.225 on
  EXPECT_FALSE(Caught(scene, {0.02, 0.0, 0.0}).rule().applies());
  EXPECT_TRUE(Caught(scene, {0.03, 0.0, 0.0}).rule().overlaps());
  scene.parameters.method = Method::paper;
  EXPECT_FALSE(Caught(scene, {0.03, 0.0, 0.0}).rule().applies());
}

TEST(EscapeRule, OutAndNeverDeeper) {
  Scene scene = square();
  scene.fill(0.2, -9.0, 9.0, 9.0);
  Caught robot(scene, {0.035, 0.0, 0.0});  // 0.235 - 0.225 = 10 mm deep
  EXPECT_NEAR(robot.rule().start().total, 0.01, 1e-9);
  EXPECT_TRUE(robot.may({-0.14, 0.0}));
  EXPECT_NE(robot.rejection({0.02, 0.0}).find("deeper"), std::string::npos);
  EXPECT_NE(robot.rejection({-0.2, 0.0}).find("too fast"), std::string::npos);
  EXPECT_NE(robot.rejection({0.0, 0.2}).find("deeper"), std::string::npos);  // its corners would
  EXPECT_NE(robot.rejection({}).find("not out"), std::string::npos);
}

// It leaves what is behind it and would come upon a post that it does not overlap, though no deeper than now.
TEST(EscapeRule, RoomToWhatItDoesNotOverlapIsToldAsFarAsAsked) {
  Scene scene = square();
  scene.at({64, 60}) = cost::kLethal;      // from x = 0.175 on, in its front
  scene.at({50, 60}) = cost::kLethal;      // up to x = -0.475
  Caught robot(scene, {0.035, 0.0, 0.0});  // its rear at -0.165
  EXPECT_NEAR(robot.rule().rest().clearance({0.035, 0.0, 0.0}, {1.0, 0.0}, 0.4), 0.31, 1e-6);
}

TEST(EscapeRule, LeavingOneObstacleDoesNotPayForAnother) {
  for (const bool post : {false, true}) {
    Scene scene = square();
    scene.at({56, 60}) = cost::kLethal;            // from x = -0.225 to -0.175
    if (post) scene.at({68, 60}) = cost::kLethal;  // from x = 0.375 on: 0.175 m ahead
    Caught robot(scene, {0.0, 0.0, 0.0});          // 25 mm deep
    EXPECT_NEAR(robot.rule().start().total, 0.025, 1e-9);
    EXPECT_EQ(robot.may({0.14, 0.0}), !post);  // 1.85 s * 0.14 = 0.26 m
    EXPECT_TRUE(robot.may({0.08, 0.0}));       // 0.15 m
  }
}

// The wall beside it is 5 mm in its left side: straight on is allowed, though it comes upon further cells of the wall.
TEST(EscapeRule, AlongAWallThatItGrazes) {
  Scene scene = square();
  scene.fill(-9.0, 0.2, 9.0, 9.0);                        // from y = 0.225 on
  for (const double x : {0.0, 0.01, 0.02, 0.03, 0.04}) {  // wherever its cells begin
    Caught robot(scene, {x, 0.03, 0.0});
    EXPECT_NEAR(robot.rule().start().total, 0.005, 1e-9);
    EXPECT_TRUE(robot.may({0.14, 0.0}));
    EXPECT_TRUE(robot.may({-0.14, 0.0}));
    EXPECT_FALSE(robot.may({0.1, 0.05}));
  }
  // Deeper than half a cell it may not.
  EXPECT_FALSE(Caught(scene, {0.0, 0.055, 0.0}).may({0.14, 0.0}));  // 30 mm
}

// A cell juts out of the wall ahead, 20 mm farther than the robot stands in it.
TEST(EscapeRule, NotDeeperIntoANeighbour) {
  Scene scene = square();
  scene.fill(-9.0, 0.2, 9.0, 9.0);
  scene.at({66, 64}) = cost::kLethal;  // from (0.275, 0.175) on
  Caught robot(scene, {0.0, 0.03, 0.0});
  EXPECT_FALSE(robot.may({0.14, 0.0}));
  EXPECT_TRUE(robot.may({0.03, 0.0}));  // 0.2 + 1.85 * 0.03 = 0.2555
  EXPECT_TRUE(robot.may({-0.14, 0.0}));
}

// Two posts, one behind it and one on its left: they are no one cluster, and their depths add up.
TEST(EscapeRule, DepthsOfSeparateObstaclesAddUp) {
  Scene scene = square();
  scene.at({56, 60}) = cost::kLethal;  // from x = -0.225 to -0.175
  scene.at({60, 64}) = cost::kLethal;  // from y = 0.175 to 0.225
  Caught robot(scene, {0.0, -0.01, 0.0});
  EXPECT_NEAR(robot.rule().start().total, 0.025 + 0.015, 1e-9);  // 0.2 - 0.175 and 0.19 - 0.175
}

// A person may have it stand, and turn where that is no deeper; autonomy gets out.
TEST(EscapeRule, APersonMayHaveItStandAndTurn) {
  Scene scene = square();
  scene.outline = test::round_outline(0.2);
  scene.fill(0.1, -9.0, 9.0, 9.0);  // from x = 0.125 on: 75 mm deep
  Caught person(scene, {0.0, 0.0, 0.0}, true), autonomy(scene, {0.0, 0.0, 0.0});
  EXPECT_TRUE(person.may({}));
  EXPECT_TRUE(person.may({0.0, 0.5}));
  EXPECT_FALSE(person.may({0.1, 0.0}));
  EXPECT_FALSE(autonomy.may({}));
  EXPECT_FALSE(autonomy.may({0.0, 0.5}));
  EXPECT_TRUE(autonomy.may({-0.1, 0.0}));
}

// A disc whose outline is free, its centre's cell inscribed by rounding: it drives as ever, but touches nothing.
TEST(EscapeRule, AnInscribedCentreIsNoOverlap) {
  Scene scene = square();
  scene.outline = test::round_outline(0.2);
  scene.fill(-9.0, 0.2, 9.0, 9.0);
  scene.at({60, 60}) = cost::kInscribed;
  Caught robot(scene, {0.0, 0.024, 0.0});  // 1 mm beside the wall
  EXPECT_TRUE(robot.rule().applies());
  EXPECT_FALSE(robot.rule().overlaps());
  EXPECT_TRUE(robot.may({0.5, 0.0}));
  EXPECT_FALSE(robot.may({0.5, 0.1}));
}

}  // namespace
}  // namespace hidwa_local_planner
