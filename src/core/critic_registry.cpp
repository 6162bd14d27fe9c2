// SPDX-License-Identifier: BSD-3-Clause
#include "hidwa_local_planner/core/critic_registry.hpp"

#include <utility>

namespace hidwa_local_planner {

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
