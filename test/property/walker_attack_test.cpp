// SPDX-License-Identifier: BSD-3-Clause
// Nobody who keeps the bounds touches the robot while it moves: see walker_attack.hpp.
//
// Argument: how many drives of 30 s of each kind (12), and "table" for what happens beyond the bounds.
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include <gtest/gtest.h>

#include "property/walker_attack.hpp"

namespace hidwa_local_planner {
namespace {

using test::walkers::Bounds;
using test::walkers::Count;
using test::walkers::Who;
using test::walkers::World;

std::uint64_t drives = 12;
bool table = false;

Count campaign(const char* what, Who who, const Bounds& bounds) {
  Count all;
  for (std::uint64_t seed = 1; seed <= drives; ++seed) all = all + World(seed, who, bounds).run(30.0);
  std::printf(
      "%-34s %6llu encounters, touched moving %llu, leaving %llu, at %.3f m/s, at rest %llu; %.0f m in %.0f s\n", what,
      static_cast<unsigned long long>(all.encounters.met), static_cast<unsigned long long>(all.encounters.moving),
      static_cast<unsigned long long>(all.encounters.leaving), all.encounters.fastest,
      static_cast<unsigned long long>(all.encounters.at_rest), all.driven, all.time);
  return all;
}

void expect_untouched(const char* what, Who who, const Bounds& bounds = {}) {
  const Count all = campaign(what, who, bounds);
  EXPECT_EQ(all.encounters.moving, 0U);
  // It was among people, and drove: 12 drives of 30 s.
  EXPECT_GT(all.encounters.met, 8 * drives);
  EXPECT_GT(all.driven, 1.0 * static_cast<double>(drives));
  EXPECT_GT(all.refused, 0U);
}

TEST(WalkerAttack, AutonomyIsNeverTouchedWhileItMoves) { expect_untouched("autonomy", Who::nobody); }
TEST(WalkerAttack, SharedControlIsNeverTouchedWhileItMoves) { expect_untouched("hostile, shared", Who::hostile); }
TEST(WalkerAttack, ManualIsNeverTouchedWhileItMoves) { expect_untouched("hostile, manual", Who::manual); }

// Where everything is known exactly, nobody counts as left but who all but touched the robot when it set off.
TEST(WalkerAttack, NeverTouchedWhileItMovesWhereEverythingIsKnown) {
  Bounds exact;
  exact.position_error = exact.velocity_error = exact.oldest = 0.0;
  expect_untouched("hostile, shared, exact states", Who::hostile, exact);
}

// A robot that leaves somebody creeps, and does not move into him. It leaves him where his states are known well: they
// must say that he stands.
TEST(WalkerAttack, WhoLingersIsLeftAsSafetyAllows) {
  for (const Who who : {Who::nobody, Who::hostile}) {
    Bounds lingering;
    lingering.lingering = 1.0;
    lingering.count = 2;
    lingering.position_error = lingering.velocity_error = lingering.oldest = 0.0;
    const Count all = campaign("lingering", who, lingering);
    EXPECT_EQ(all.encounters.moving, 0U);
    EXPECT_GT(all.encounters.met, 2 * drives);
  }
}

// Errors of up to one deviation, of which one counts.
TEST(WalkerAttack, NeverTouchedWhileItMovesWhereFewerDeviationsCountAndErrorsAreWithinThem) {
  Bounds bounds;
  bounds.told_errors = 3.0;
  bounds.told_deviations = 1.0;
  expect_untouched("hostile, shared, one deviation", Who::hostile, bounds);
}

// Walkers who know that the planner knows nothing of them: what the test would see.
TEST(WalkerAttack, SeesTouchesWhereThePlannerIsToldTooLittle) {
  Bounds bounds;
  bounds.told_acc = 0.0;
  bounds.told_speed = 0.0;
  bounds.told_errors = 0.0;
  bounds.base_latency = 0.3;
  EXPECT_GT(campaign("told nothing, latency 0.3 s", Who::hostile, bounds).encounters.moving, 0U);
}

TEST(WalkerAttack, TableBeyondTheBounds) {
  if (!table) GTEST_SKIP() << "argument: table";
  for (const double factor : {1.5, 2.0, 3.0, 5.0}) {
    Bounds acc, speed, errors, latency;
    acc.acc *= factor;
    speed.speed *= factor;
    errors.told_errors = 1.0 / factor;
    latency.base_latency *= factor;
    for (const auto& [what, bounds] : {std::pair<const char*, Bounds>{"accelerations", acc},
                                       {"speeds", speed},
                                       {"errors", errors},
                                       {"latency of the base", latency}}) {
      char label[64];
      std::snprintf(label, sizeof(label), "%s x %.1f", what, factor);
      campaign(label, Who::hostile, bounds);
    }
  }
}

}  // namespace
}  // namespace hidwa_local_planner

int main(int argc, char** argv) {
  ::testing::InitGoogleTest(&argc, argv);
  for (int i = 1; i < argc; ++i) {
    if (std::strcmp(argv[i], "table") == 0) {
      hidwa_local_planner::table = true;
    } else {
      hidwa_local_planner::drives = std::strtoull(argv[i], nullptr, 10);
    }
  }
  return RUN_ALL_TESTS();
}
