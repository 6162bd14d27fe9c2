// SPDX-License-Identifier: BSD-3-Clause
#include "hidwa_local_planner/core/critic_registry.hpp"

#include <utility>

#include "critics/base_obstacle.hpp"
#include "critics/goal_align.hpp"
#include "critics/goal_dist.hpp"
#include "critics/obstacle_footprint.hpp"
#include "critics/oscillation.hpp"
#include "critics/path_align.hpp"
#include "critics/path_dist.hpp"
#include "critics/prefer_forward.hpp"
#include "critics/rotate_to_goal.hpp"
#include "critics/twirling.hpp"

namespace hidwa_local_planner {

CriticRegistry CriticRegistry::with_built_in() {
  CriticRegistry registry;
  registry.add("BaseObstacle", [] { return std::make_shared<BaseObstacleCritic>(); });
  registry.add("GoalAlign", [] { return std::make_shared<GoalAlignCritic>(); });
  registry.add("GoalDist", [] { return std::make_shared<GoalDistCritic>(); });
  registry.add("ObstacleFootprint", [] { return std::make_shared<ObstacleFootprintCritic>(); });
  registry.add("Oscillation", [] { return std::make_shared<OscillationCritic>(); });
  registry.add("PathAlign", [] { return std::make_shared<PathAlignCritic>(); });
  registry.add("PathDist", [] { return std::make_shared<PathDistCritic>(); });
  registry.add("PreferForward", [] { return std::make_shared<PreferForwardCritic>(); });
  registry.add("RotateToGoal", [] { return std::make_shared<RotateToGoalCritic>(); });
  registry.add("Twirling", [] { return std::make_shared<TwirlingCritic>(); });
  return registry;
}

void CriticRegistry::add(const std::string& name, Maker maker) { makers_[name] = std::move(maker); }

std::shared_ptr<Critic> CriticRegistry::make(const std::string& name) const {
  const auto found = makers_.find(name);
  return found == makers_.end() ? nullptr : found->second();
}

std::vector<std::string> CriticRegistry::names() const {
  std::vector<std::string> names;
  for (const auto& [name, maker] : makers_) names.push_back(name);
  return names;
}

}  // namespace hidwa_local_planner
