// SPDX-License-Identifier: BSD-3-Clause
#include "core/collision/admissibility.hpp"

#include <gtest/gtest.h>

#include "core/motion/rollout.hpp"
#include "support/scene.hpp"
#include "support/tile_filler.hpp"

namespace hidwa_local_planner {
namespace {

using test::Scene;

// The checks of a robot on its way: it reaches 0.2 m to each side.
class Checked {
 public:
  Checked(const Scene& scene, const Parameters& p, const Pose2& pose, const Twist2& u, double period = 0.05,
          double longest_period = 0.05)
      : scene_(scene), parameters_(p), pending_(PendingMotion(u, p.control_latency)), footprint_(scene.outline) {
    start_.pose = start_.origin = pose;
    start_.reference = u;
    start_.limits = VelocityLimits::from(p);
    start_.pending = &pending_;
    start_.period = period;
    start_.longest_period = longest_period;
    checker_.prepare(scene_.grid(), footprint_, true, pose, 2.0, scene_.resolution, 0.5);
    check_.prepare(parameters_, checker_, footprint_, scene_.resolution, {&start_});
  }
  Checked(const Checked&) = delete;
  AdmissibilityCheck& check() { return check_; }
  bool can_brake(const Twist2& sample) { return check_.can_brake(sample); }
  bool confirm_braking(const Twist2& sample) { return check_.confirm_braking(sample); }
  /// Why a sample's rollout is not free; null where it is.
  const char* rejection(const Twist2& sample) {
    rollout_.run(parameters_, start_, {{sample, SampleKind::grid}}, {}, parameters_.sim_time);
    Tile tile = rollout_.tile(0);
    test::TileFiller tiles;
    tiles.prepare(scene_);
    tiles.fill(tile);
    const char* reason = nullptr;
    check_.check_rollouts(tile, &reason);
    return reason;
  }
  /// Of that rollout.
  std::size_t steps() const { return rollout_.tile(0).steps; }

 private:
  Scene scene_;
  Parameters parameters_;
  PendingMotionSet pending_;
  Footprint footprint_;
  CycleStart start_;
  CollisionChecker checker_;
  AdmissibilityCheck check_;
  Rollout rollout_;
};

// It drives at 0.5 m/s, and a wall stands `gap` [m] ahead of its front.
Checked before_a_wall(double gap, const Parameters& p, double longest_period = 0.05) {
  Scene scene = Scene::empty(121);
  scene.fill(1.025, -9.0, 9.0, 9.0);  // cells from x = 1.025 on
  return Checked(scene, p, {1.025 - 0.2 - gap, 0.0, 0.0}, {0.5, 0.0}, 0.05, longest_period);
}

Parameters without_latency() {
  Parameters p;
  p.control_latency = 0.0;
  return p;
}

struct Braking {
  const char* of;
  double latency, limit, longest_period;  // [s], [m/s^2], [s]
  Twist2 sample;
  double way;  // [m]
};

TEST(CanBrake, TheBrakingDistanceIsTheLimit) {
  for (const Braking& row : {
           // For one period at 0.5, then braking: 0.5 * 0.05 + 0.5^2 / (2 * 2.5) = 0.075 m. And the tail: the last
           // 0.0625 m/s evenly over a period, not in 0.025 s: 0.0625 * (0.05 - 0.025) / 2 = 0.8 mm.
           Braking{"it goes on", 0.0, 2.5, 0.05, {0.5, 0.0}, 0.0758},
           // Braking at once: 0.05 * (0.5 + 0.375) / 2 + 0.375^2 / 5 = 0.05 m, and 0.8 mm.
           Braking{"it brakes", 0.0, 2.5, 0.05, {0.0, 0.0}, 0.0508},
           Braking{"the first step counts, not the sample itself", 0.0, 2.5, 0.05, {0.375, 0.0}, 0.0508},
           // 0.2 * 0.5 = 0.1 m more.
           Braking{"after a latency", 0.2, 2.5, 0.05, {0.5, 0.0}, 0.1758},
           // 0.025 + 0.5^2 / (2 * 0.5) = 0.275 m, and 0.0125 * (0.05 - 0.025) / 2 = 0.2 mm.
           Braking{"by weaker brakes", 0.0, 0.5, 0.05, {0.5, 0.0}, 0.2752},
           // The next command may come 0.03 s late, and again: 2 * 0.03 * 0.5 = 0.03 m more.
           Braking{"by a late command", 0.0, 2.5, 0.08, {0.5, 0.0}, 0.1058},
       }) {
    Parameters p;
    p.control_latency = row.latency;
    p.decel_lim_x = -row.limit;
    EXPECT_TRUE(before_a_wall(row.way + 0.0012, p, row.longest_period).can_brake(row.sample)) << row.of;
    EXPECT_FALSE(before_a_wall(row.way - 0.0018, p, row.longest_period).can_brake(row.sample)) << row.of;
  }
}

TEST(CanBrake, SurelyKeepsAThirtySecondOfACellMore) {
  const Parameters p = without_latency();
  // 0.0758 + 0.05 / 32 = 0.0773 m.
  EXPECT_TRUE(before_a_wall(0.078, p).confirm_braking({0.5, 0.0}));
  EXPECT_FALSE(before_a_wall(0.0767, p).confirm_braking({0.5, 0.0}));
  EXPECT_TRUE(before_a_wall(0.0767, p).can_brake({0.5, 0.0}));
}

// It drives along a wall that is `gap` [m] away, with a period of 0.1 s.
bool can_brake_beside_a_wall(double gap, const Twist2& u, const Twist2& command) {
  Scene scene = Scene::empty(121);
  scene.fill(-9.0, 0.525, 9.0, 9.0);  // cells from y = 0.525 on
  return Checked(scene, without_latency(), {0.0, 0.525 - 0.2 - gap, 0.0}, u, 0.1, 0.1).confirm_braking(command);
}

TEST(CanBrake, AWallBesideARobotThatDrivesStraightOnIsNothing) {
  EXPECT_TRUE(can_brake_beside_a_wall(1e-5, {0.5, 0.0}, {0.4, 0.0}));
}

// A turning base may be off to the side of where it is thought to be. Rear corners swing out when it turns away;
// nothing of the growth is asked for beyond the distance it has at the start, but that is.
TEST(CanBrake, TurningNeedsTheRoomThatTheWaysOfABaseNeed) {
  // From 0 to -0.1 rad/s within 0.1 s: at 3.2 rad/s^2 in 0.03 s or evenly, and as long to brake.
  EXPECT_FALSE(can_brake_beside_a_wall(0.001, {0.4, 0.0}, {0.4, 0.1}));
  EXPECT_TRUE(can_brake_beside_a_wall(0.03, {0.4, 0.0}, {0.4, 0.1}));
}

TEST(CommandFor, ASampleIsItsFirstStep) {
  Parameters p;
  EXPECT_EQ(before_a_wall(1.0, p).check().command_for({0.0, 0.0}), (Twist2{0.375, 0.0}));
  p.method = Method::paper;  // its command is the sample itself, where braking is not checked
  EXPECT_EQ(before_a_wall(1.0, p).check().command_for({0.0, 0.0}), (Twist2{0.375, 0.0}));
  p.admissibility = Admissibility::horizon;
  EXPECT_EQ(before_a_wall(1.0, p).check().command_for({0.1, 0.3}), (Twist2{0.1, 0.3}));
}

TEST(RolloutCheck, TheWholeHorizonMustBeFree) {
  Parameters p;
  p.sim_time = 1.7;  // 0.5 * 1.7 = 0.85 m
  EXPECT_EQ(before_a_wall(0.86, p).rejection({0.5, 0.0}), nullptr);
  EXPECT_NE(before_a_wall(0.84, p).rejection({0.5, 0.0}), nullptr);
  EXPECT_EQ(before_a_wall(0.84, p).rejection({0.4, 0.0}), nullptr);
}

// From -0.3 to 0.7 m in one step: both ends are free, a single lethal cell lies between.
TEST(RolloutCheck, NothingSlipsBetweenCoarsePoses) {
  Parameters p;
  p.max_vel_x = p.sim_time = p.linear_granularity = 1.0;
  p.generator = Generator::dwa;
  p.method = Method::paper;
  Scene scene = Scene::empty(121);
  scene.at({68, 60}) = cost::kLethal;  // at x = 0.4
  Checked robot(scene, p, {-0.3, 0.0, 0.0}, {1.0, 0.0});
  EXPECT_NE(robot.rejection({1.0, 0.0}), nullptr);
  EXPECT_EQ(robot.steps(), 1u);
}

}  // namespace
}  // namespace hidwa_local_planner
