// SPDX-License-Identifier: BSD-3-Clause
#include "core/collision/admissibility.hpp"

#include <gtest/gtest.h>

#include "core/motion/rollout.hpp"
#include "support/scene.hpp"
#include "support/tile_filler.hpp"

namespace hidwa_local_planner {
namespace {

using test::Scene;

// The robot reaches 0.2 m ahead and drives 0.5 m/s; a wall stands `gap` ahead of its front.
class Corridor {
 public:
  Corridor(double gap, const Parameters& p, double longest_period = 0.05)
      : parameters_(p), pending_(PendingMotion({0.5, 0.0}, p.control_latency)) {
    scene_ = Scene::empty(121);
    scene_.fill(1.025, -9.0, 9.0, 9.0);  // cells from x = 1.025 on
    start_.pose = start_.origin = {1.025 - 0.2 - gap, 0.0, 0.0};
    start_.reference = {0.5, 0.0};
    start_.limits = VelocityLimits::from(p);
    start_.pending = &pending_;
    start_.longest_period = longest_period;
    footprint_ = Footprint(scene_.outline);
    checker_.prepare(scene_.grid(), footprint_, true, start_.pose, 2.0, scene_.resolution);
    check_.prepare(parameters_, checker_, footprint_, 0.05, {&start_});
  }
  Corridor(const Corridor&) = delete;
  bool can_brake(const Twist2& sample) { return check_.can_brake(sample, 0); }
  bool confirm_braking(const Twist2& sample) { return check_.confirm_braking(sample); }
  AdmissibilityCheck& check() { return check_; }
  const Scene& scene() const { return scene_; }
  const CycleStart& start() const { return start_; }

 private:
  Parameters parameters_;
  PendingMotionSet pending_;
  Scene scene_;
  CycleStart start_;
  Footprint footprint_;
  CollisionChecker checker_;
  AdmissibilityCheck check_;
};

TEST(CanBrake, TheBrakingDistanceIsTheLimit) {
  Parameters p;
  p.control_latency = 0.0;
  // Going on at 0.5 for one period, then braking: 0.5 * 0.05 + 0.5^2 / (2 * 2.5) = 0.075 m. And the tail: the last
  // 0.0625 m/s evenly over a period, not in 0.025 s: 0.0625 * (0.05 - 0.025) / 2 = 0.8 mm.
  EXPECT_TRUE(Corridor(0.077, p).can_brake({0.5, 0.0}));
  EXPECT_FALSE(Corridor(0.073, p).can_brake({0.5, 0.0}));
  // Braking at once: 0.05 * (0.5 + 0.375) / 2 + 0.375^2 / 5 = 0.05 m, and 0.8 mm.
  EXPECT_TRUE(Corridor(0.052, p).can_brake({0.0, 0.0}));
  EXPECT_FALSE(Corridor(0.048, p).can_brake({0.0, 0.0}));
}

TEST(CanBrake, LatencyLengthensIt) {
  Parameters p;
  p.control_latency = 0.2;
  // 0.2 * 0.5 = 0.1 m more.
  EXPECT_TRUE(Corridor(0.177, p).can_brake({0.5, 0.0}));
  EXPECT_FALSE(Corridor(0.173, p).can_brake({0.5, 0.0}));
}

TEST(CanBrake, WeakerBrakesLengthenIt) {
  Parameters p;
  p.control_latency = 0.0;
  p.decel_lim_x = -0.5;
  // 0.025 + 0.5^2 / (2 * 0.5) = 0.275 m.
  EXPECT_TRUE(Corridor(0.277, p).can_brake({0.5, 0.0}));
  EXPECT_FALSE(Corridor(0.273, p).can_brake({0.5, 0.0}));
}

TEST(CanBrake, SurelyKeepsAThirtySecondOfACellMore) {
  Parameters p;
  p.control_latency = 0.0;
  // 0.0758 + 0.05 / 32 = 0.0773 m.
  EXPECT_TRUE(Corridor(0.078, p).confirm_braking({0.5, 0.0}));
  EXPECT_FALSE(Corridor(0.0767, p).confirm_braking({0.5, 0.0}));
  EXPECT_TRUE(Corridor(0.0767, p).can_brake({0.5, 0.0}));
}

TEST(CanBrake, ALateCommandToBrakeLengthensIt) {
  Parameters p;
  p.control_latency = 0.0;
  // The next command may come 0.03 s late, and again: 0.0758 + 2 * 0.03 * 0.5 = 0.1058 m.
  EXPECT_TRUE(Corridor(0.108, p, 0.08).can_brake({0.5, 0.0}));
  EXPECT_FALSE(Corridor(0.104, p, 0.08).can_brake({0.5, 0.0}));
  EXPECT_TRUE(Corridor(0.104, p, 0.05).can_brake({0.5, 0.0}));
}

// A turning base may be off to the side of where it is thought to be: 0.3 m on, beside a wall that it stands `gap` away
// from.
class Alley {
 public:
  Alley(double gap, const Twist2& u, const Twist2& command) {
    scene_ = Scene::empty(121);
    scene_.fill(-9.0, 0.525, 9.0, 9.0);  // cells from y = 0.525 on
    Parameters p;
    p.control_latency = 0.0;
    parameters_ = p;
    start_.pose = start_.origin = {0.0, 0.525 - 0.2 - gap, 0.0};
    start_.reference = u;
    start_.limits = VelocityLimits::from(p);
    start_.pending = &pending_;
    start_.period = start_.longest_period = 0.1;
    footprint_ = Footprint(scene_.outline);
    pending_ = PendingMotionSet(PendingMotion(u, 0.0));
    checker_.prepare(scene_.grid(), footprint_, true, start_.pose, 2.0, 0.05, 0.5);
    check_.prepare(parameters_, checker_, footprint_, 0.05, {&start_});
    command_ = command;
  }
  Alley(const Alley&) = delete;
  bool can_brake() { return check_.confirm_braking(command_); }

 private:
  Scene scene_;
  Parameters parameters_;
  CycleStart start_;
  Footprint footprint_;
  PendingMotionSet pending_;
  CollisionChecker checker_;
  AdmissibilityCheck check_;
  Twist2 command_;
};

TEST(CanBrake, AWallBesideARobotThatDrivesStraightOnIsNothing) {
  EXPECT_TRUE(Alley(1e-5, {0.5, 0.0}, {0.4, 0.0}).can_brake());
}

// Rear corners swing out when it turns away; nothing of the growth is asked for beyond the distance it has at the
// start, but that is.
TEST(CanBrake, TurningNeedsTheRoomThatTheWaysOfABaseNeed) {
  // From 0 to -0.1 rad/s within 0.1 s: at 3.2 rad/s^2 in 0.03 s or evenly, and as long to brake.
  const auto needs = [](double gap) { return !Alley(gap, {0.4, 0.0}, {0.4, 0.1}).can_brake(); };
  EXPECT_TRUE(needs(0.001));
  EXPECT_FALSE(needs(0.03));
}

TEST(CanBrake, TheFirstStepCountsNotTheSampleItself) {
  Parameters p;
  p.control_latency = 0.0;
  // Asking for 0 gives 0.375 first; asking for 0.375 the same.
  EXPECT_TRUE(Corridor(0.052, p).check().command_for({0.0, 0.0}) == (Twist2{0.375, 0.0}));
  EXPECT_TRUE(Corridor(0.052, p).can_brake({0.375, 0.0}));
  p.method = Method::paper;  // its command is the sample itself, where braking is not checked
  EXPECT_TRUE(Corridor(0.052, p).check().command_for({0.0, 0.0}) == (Twist2{0.375, 0.0}));
  p.admissibility = Admissibility::horizon;
  EXPECT_TRUE(Corridor(0.052, p).check().command_for({0.1, 0.3}) == (Twist2{0.1, 0.3}));
}

const char* rollout_reason(Corridor& corridor, const Parameters& p, const Twist2& sample) {
  Rollout rollout;
  rollout.run(p, corridor.start(), {{sample, SampleKind::grid}});
  Tile tile = rollout.tile(0);
  test::TileFiller tiles;
  tiles.prepare(corridor.scene());
  tiles.fill(tile);
  const char* reason = nullptr;
  corridor.check().check_rollouts(tile, &reason);
  return reason;
}

TEST(RolloutCheck, TheWholeHorizonMustBeFree) {
  Parameters p;
  p.sim_time = 1.7;  // 0.5 * 1.7 = 0.85 m
  Corridor enough(0.86, p);
  EXPECT_EQ(rollout_reason(enough, p, {0.5, 0.0}), nullptr);
  Corridor tight(0.84, p);
  ASSERT_NE(rollout_reason(tight, p, {0.5, 0.0}), nullptr);
  EXPECT_EQ(rollout_reason(tight, p, {0.4, 0.0}), nullptr);
}

TEST(RolloutCheck, NothingSlipsBetweenCoarsePoses) {
  // One step of 0.85 m over a single lethal cell.
  Parameters p;
  p.linear_granularity = 1.0;
  p.method = Method::paper;
  Scene scene = Scene::empty(121);
  scene.at({68, 60}) = cost::kLethal;  // at x = 0.4
  const Footprint footprint(scene.outline);
  const PendingMotionSet steady(PendingMotion({0.5, 0.0}, p.control_latency));
  CycleStart start;
  start.pose = start.origin = {-0.3, 0.0, 0.0};
  start.reference = {1.0, 0.0};
  start.limits = VelocityLimits::from(p);
  start.pending = &steady;
  CollisionChecker checker;
  checker.prepare(scene.grid(), footprint, true, start.pose, 2.0, scene.resolution);
  AdmissibilityCheck check;
  check.prepare(p, checker, footprint, 0.05, {&start});
  Rollout rollout;
  // From -0.3 to 1.4 at 1.0 m/s: both ends are free, the cell lies between.
  Parameters fast = p;
  fast.max_vel_x = 1.0;
  fast.linear_granularity = 1.0;
  fast.generator = Generator::dwa;
  fast.sim_time = 1.0;
  rollout.run(fast, start, {{{1.0, 0.0}, SampleKind::grid}});
  ASSERT_EQ(rollout.tile(0).steps, 1u);
  Tile tile = rollout.tile(0);
  test::TileFiller tiles;
  tiles.prepare(scene);
  tiles.fill(tile);
  const char* reason = nullptr;
  check.check_rollouts(tile, &reason);
  EXPECT_NE(reason, nullptr);
}

}  // namespace
}  // namespace hidwa_local_planner
