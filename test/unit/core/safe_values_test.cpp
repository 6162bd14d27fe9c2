// SPDX-License-Identifier: BSD-3-Clause
#include "core/planner/safe_values.hpp"

#include <gtest/gtest.h>

#include "hidwa_local_planner/core/planner.hpp"
#include "hidwa_local_planner/critics/built_in.hpp"

namespace hidwa_local_planner {
namespace {

TEST(SafeValues, TheDefaultsAreSafe) {
  Parameters p;
  EXPECT_TRUE(make_safe(p).empty());
}

TEST(SafeValues, TheCheckForBrakingNeedsFeasibleCommands) {
  Parameters p;
  p.admissibility = Admissibility::braking;
  p.command = CommandPolicy::target;
  const std::vector<std::string> reasons = make_safe(p);
  EXPECT_EQ(p.command, CommandPolicy::feasible);
  ASSERT_EQ(reasons.size(), 1u);
  for (const char* word : {"command: feasible", "target", "admissibility: horizon"}) {
    EXPECT_NE(reasons[0].find(word), std::string::npos) << reasons[0];
  }
}

TEST(SafeValues, WithTheHorizonAloneATargetStays) {
  Parameters p;
  p.admissibility = Admissibility::horizon;
  p.command = CommandPolicy::target;
  EXPECT_TRUE(make_safe(p).empty());
  EXPECT_EQ(p.command, CommandPolicy::target);
}

TEST(SafeValues, ThePlannerRunsWithThem) {
  Parameters p;
  p.command = CommandPolicy::target;
  Planner planner(critics::built_in());
  EXPECT_TRUE(planner.configure(p).empty());  // it is no fault: a robot drives on after an update
  EXPECT_EQ(planner.parameters().command, CommandPolicy::feasible);
  EXPECT_EQ(planner.parameters().admissibility, Admissibility::braking);
}

}  // namespace
}  // namespace hidwa_local_planner
