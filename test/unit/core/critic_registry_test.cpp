// SPDX-License-Identifier: BSD-3-Clause
#include "hidwa_local_planner/core/critic_registry.hpp"

#include <gtest/gtest.h>

#include "critics/twirling.hpp"

namespace hidwa_local_planner {
namespace {

TEST(CriticRegistry, KnowsTheTenOfThisPackage) {
  const CriticRegistry registry = CriticRegistry::with_built_in();
  const std::vector<std::string> expected{"BaseObstacle", "GoalAlign", "GoalDist", "ObstacleFootprint",
                                          "Oscillation",  "PathAlign", "PathDist", "PreferForward",
                                          "RotateToGoal", "Twirling"};
  EXPECT_EQ(registry.names(), expected);
  for (const std::string& name : expected) EXPECT_NE(registry.make(name), nullptr) << name;
}

TEST(CriticRegistry, UnknownNamesGiveNothing) {
  const CriticRegistry registry = CriticRegistry::with_built_in();
  EXPECT_FALSE(registry.knows("PathDst"));
  EXPECT_EQ(registry.make("PathDst"), nullptr);
}

TEST(CriticRegistry, AddsAndReplaces) {
  CriticRegistry registry = CriticRegistry::with_built_in();
  int made = 0;
  registry.add("PathDist", [&made] {
    ++made;
    return std::make_shared<TwirlingCritic>();
  });
  registry.add("Mine", [] { return std::make_shared<TwirlingCritic>(); });
  EXPECT_EQ(registry.names().size(), 11u);
  EXPECT_NE(dynamic_cast<TwirlingCritic*>(registry.make("PathDist").get()), nullptr);
  EXPECT_EQ(made, 1);
  EXPECT_NE(registry.make("Mine"), registry.make("Mine"));  // a new one each time
}

}  // namespace
}  // namespace hidwa_local_planner
