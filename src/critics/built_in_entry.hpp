// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "hidwa_local_planner/core/critic.hpp"
#include "hidwa_local_planner/core/critic_registry.hpp"

namespace hidwa_local_planner::critics {

/// Puts a critic on the list of built_in(). The file of each critic ends with one:
///   const BuiltInEntry entry("Twirling", make<Twirling>);
/// The list is linked through the entries: it allocates nothing, and the order in which files are initialised does not
/// matter.
class BuiltInEntry {
 public:
  using Maker = std::shared_ptr<Critic> (*)();

  BuiltInEntry(const char* name, Maker maker) noexcept : name_(name), maker_(maker), next_(first) { first = this; }
  BuiltInEntry(const BuiltInEntry&) = delete;
  BuiltInEntry& operator=(const BuiltInEntry&) = delete;

  static void add_all(CriticRegistry& registry) {
    for (const BuiltInEntry* entry = first; entry != nullptr; entry = entry->next_) {
      registry.add(entry->name_, entry->maker_);
    }
  }

 private:
  static const BuiltInEntry* first;

  const char* name_;
  Maker maker_;
  const BuiltInEntry* next_;
};

template <typename OneCritic>
std::shared_ptr<Critic> make() {
  return std::make_shared<OneCritic>();
}

}  // namespace hidwa_local_planner::critics
