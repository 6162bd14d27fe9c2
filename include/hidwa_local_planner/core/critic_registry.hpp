// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "hidwa_local_planner/core/critic.hpp"

namespace hidwa_local_planner {

/// Finds the parameters of critics of other packages; returned pointers must outlive the planner.
using SourceFor = std::function<std::unique_ptr<ParameterSource>(const std::string& critic)>;

/// Makes critics by name. Empty at first: critics::built_in() has those of this package, and the plugin adds those of
/// other packages.
class CriticRegistry {
 public:
  using Maker = std::function<std::shared_ptr<Critic>()>;

  /// Adds a critic, or replaces the one of that name.
  void add(const std::string& name, Maker maker) { makers_[name] = std::move(maker); }
  bool knows(const std::string& name) const { return makers_.count(name) != 0; }
  /// nullptr for an unknown name.
  std::shared_ptr<Critic> make(const std::string& name) const { return knows(name) ? makers_.at(name)() : nullptr; }
  std::vector<std::string> names() const {
    std::vector<std::string> names;
    for (const auto& [name, maker] : makers_) names.push_back(name);
    return names;
  }

 private:
  std::map<std::string, Maker> makers_;
};

}  // namespace hidwa_local_planner
