// SPDX-License-Identifier: BSD-3-Clause
#include "hidwa_local_planner/critics/built_in.hpp"

#include "critics/built_in_entry.hpp"

namespace hidwa_local_planner::critics {

const BuiltInEntry* BuiltInEntry::first = nullptr;  // before any entry is made, whichever file is initialised first

CriticRegistry built_in() {
  CriticRegistry registry;
  BuiltInEntry::add_all(registry);
  return registry;
}

}  // namespace hidwa_local_planner::critics
