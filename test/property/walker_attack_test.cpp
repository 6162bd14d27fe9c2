// SPDX-License-Identifier: BSD-3-Clause
// Walkers who want to touch the robot while it moves, on an open floor: none who keeps the bounds does. The drive, the
// walkers and the judge of contacts are the hostile campaign's.
//
// HIDWA_LONG: 100 drives of each kind instead of 12, and what happens beyond the bounds.
#include <algorithm>
#include <cstdio>

#include <gtest/gtest.h>

#include "attack/drive.hpp"
#include "attack/random.hpp"
#include "support/effort.hpp"

namespace hidwa_attack {
namespace {

const std::uint64_t drives = hidwa_local_planner::test::effort(12, 100);

// The defaults of the planner are what walkers keep.
Spec spec_of(std::uint64_t seed, Steering steering) {
  Random random(seed);
  Spec spec;
  spec.place = Place::open;
  spec.outline = random.of({Outline::circle, Outline::long_rectangle, Outline::off_centre});
  spec.seconds = 30;
  spec.late_share = 0.1;
  spec.late_most = 0.6;
  spec.reaching = random.of({Reaching::evenly, Reaching::at_limit});
  spec.steering = steering;
  spec.relentless = true;
  spec.walkers = 4;
  Parameters& p = spec.parameters;
  if (steering == Steering::manual) p.mode = hidwa_local_planner::OperatorMode::switching;
  p.linear = hidwa_local_planner::LinearPolicy::axis;
  p.stop_pull = 0.0;
  p.cycle_budget = -1.0;
  p.vx_samples = 12;
  p.vth_samples = 15;
  if (random.chance(0.5)) p.min_vel_x = -0.2;
  if (random.chance(0.3)) p.max_vel_x = 1.0;
  if (random.chance(0.3)) p.acc_lim_x = 1.2;
  if (random.chance(0.3)) p.SocialDistance_scale = 0.0;
  return spec;
}

struct Count {
  Encounters encounters;
  int cycles = 0, moving = 0;
};

template <typename Change>
Count campaign(const char* what, Steering steering, Change change) {
  Count all;
  Encounters& sum = all.encounters;
  for (std::uint64_t seed = 1; seed <= drives; ++seed) {
    Spec spec = spec_of(seed, steering);
    change(spec);
    const DriveResult result = drive(spec, seed);
    const Encounters& one = result.encounters;
    sum = {sum.met + one.met, sum.moving + one.moving, sum.leaving + one.leaving, std::max(sum.fastest, one.fastest),
           sum.at_rest + one.at_rest};
    all.cycles += result.cycles;
    all.moving += result.moving;
  }
  std::printf("%-34s %6d encounters, touched moving %d, leaving %d, at %.3f m/s, at rest %d; it moved in %.0f %%\n",
              what, static_cast<int>(sum.met), static_cast<int>(sum.moving), static_cast<int>(sum.leaving), sum.fastest,
              static_cast<int>(sum.at_rest), 100.0 * all.moving / all.cycles);
  return all;
}

void as_it_is(Spec&) {}

void know_exactly(Spec& spec) { spec.bounds.position_error = spec.bounds.velocity_error = spec.bounds.oldest = 0.0; }

template <typename Change>
void expect_untouched(const char* what, Steering steering, Change change) {
  const Count all = campaign(what, steering, change);
  EXPECT_EQ(all.encounters.moving, 0U);
  // It was among people, and drove.
  EXPECT_GT(all.encounters.met, 8 * drives);
  EXPECT_GT(all.moving, all.cycles / 5);
}

TEST(WalkerAttack, AutonomyIsNeverTouchedWhileItMoves) { expect_untouched("autonomy", Steering::nobody, as_it_is); }
TEST(WalkerAttack, SharedControlIsNeverTouchedWhileItMoves) {
  expect_untouched("hostile, shared", Steering::shared, as_it_is);
}
TEST(WalkerAttack, ManualIsNeverTouchedWhileItMoves) {
  expect_untouched("hostile, manual", Steering::manual, as_it_is);
}

// Where everything is known exactly, nobody counts as left but who all but touched the robot when it set off.
TEST(WalkerAttack, NeverTouchedWhileItMovesWhereEverythingIsKnown) {
  expect_untouched("hostile, shared, exact states", Steering::shared, know_exactly);
}

// A robot that leaves somebody creeps, and does not move into him. It leaves him where his states are known well: they
// must say that he stands.
TEST(WalkerAttack, WhoLingersIsLeftAsSafetyAllows) {
  for (const Steering steering : {Steering::nobody, Steering::shared}) {
    const Count all = campaign("lingering", steering, [](Spec& spec) {
      know_exactly(spec);
      spec.bounds.lingering = 1.0;
      spec.walkers = 2;
    });
    EXPECT_EQ(all.encounters.moving, 0U);
    EXPECT_GT(all.encounters.met, 2 * drives);
  }
}

// Errors of up to one deviation, of which one counts.
TEST(WalkerAttack, NeverTouchedWhileItMovesWhereFewerDeviationsCountAndErrorsAreWithinThem) {
  expect_untouched("hostile, shared, one deviation", Steering::shared, [](Spec& spec) {
    spec.bounds.told_errors = 3.0;
    spec.parameters.moving_obstacle_deviations = 1.0;
  });
}

// Walkers who know that the planner knows nothing of them: what the test would see.
TEST(WalkerAttack, SeesTouchesWhereThePlannerIsToldTooLittle) {
  const Count all = campaign("told nothing, latency 0.3 s", Steering::shared, [](Spec& spec) {
    spec.parameters.moving_obstacle_acc = 0.0;
    spec.parameters.moving_obstacle_speed = 0.0;
    spec.bounds.told_errors = 0.0;
    spec.latency = 300;
  });
  EXPECT_GT(all.encounters.moving, 0U);
}

TEST(WalkerAttack, TableBeyondTheBounds) {
  if (!hidwa_local_planner::test::long_form()) GTEST_SKIP() << "HIDWA_LONG is not set";
  for (const double factor : {1.5, 2.0, 3.0, 5.0}) {
    std::printf("beyond the bounds, times %.1f\n", factor);
    campaign("accelerations", Steering::shared, [&](Spec& spec) { spec.bounds.acc *= factor; });
    campaign("speeds", Steering::shared, [&](Spec& spec) { spec.bounds.speed *= factor; });
    campaign("errors", Steering::shared, [&](Spec& spec) { spec.bounds.told_errors = 1.0 / factor; });
    campaign("latency of the base", Steering::shared,
             [&](Spec& spec) { spec.latency = static_cast<int>(100 * factor); });
  }
}

}  // namespace
}  // namespace hidwa_attack
