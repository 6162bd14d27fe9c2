// SPDX-License-Identifier: BSD-3-Clause
#include "hidwa_local_planner/core/critic_registry.hpp"

#include <gtest/gtest.h>

#include "hidwa_local_planner/critics/built_in.hpp"

namespace hidwa_local_planner {
namespace {

class Mine : public Critic {
 public:
  double configure(const Parameters& /*parameters*/, const ParameterSource& /*own*/) override { return 1.0; }
  void score(const CycleView& /*cycle*/, const Tile& /*tile*/, TileScores& /*scores*/) override {}
};

TEST(BuiltIn, HasTheCriticsOfTheHandbook) {
  const CriticRegistry registry = critics::built_in();
  for (const char* name : {"BaseObstacle", "GoalAlign", "GoalDist", "ObstacleFootprint", "Oscillation", "PathAlign",
                           "PathDist", "PreferForward", "RotateToGoal", "Twirling"}) {
    EXPECT_NE(registry.make(name), nullptr) << name;
  }
}

// Each has a weight, under its own name; but Oscillation, which only rejects, PreferForward, whose terms have theirs,
// and Occlusion, which `occlusion` switches.
TEST(BuiltIn, EveryCriticThatScoresHasAScaleAmongTheParameters) {
  const Parameters parameters;
  for (const std::string& name : critics::built_in().names()) {
    if (name == "Oscillation" || name == "PreferForward" || name == "Occlusion") continue;
    EXPECT_NO_THROW(get_parameter(parameters, name + "_scale")) << name;
  }
}

TEST(CriticRegistry, UnknownNamesGiveNothing) {
  const CriticRegistry registry = critics::built_in();
  EXPECT_FALSE(registry.knows("PathDst"));
  EXPECT_EQ(registry.make("PathDst"), nullptr);
}

TEST(CriticRegistry, AddsAndReplaces) {
  CriticRegistry registry = critics::built_in();
  const std::size_t built_in = registry.names().size();
  int made = 0;
  registry.add("PathDist", [&made] {
    ++made;
    return std::make_shared<Mine>();
  });
  registry.add("Mine", [] { return std::make_shared<Mine>(); });
  EXPECT_EQ(registry.names().size(), built_in + 1);
  EXPECT_NE(dynamic_cast<Mine*>(registry.make("PathDist").get()), nullptr);
  EXPECT_EQ(made, 1);
  EXPECT_NE(registry.make("Mine"), registry.make("Mine"));  // a new one each time
}

}  // namespace
}  // namespace hidwa_local_planner
