// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "hidwa_local_planner/core/critic_registry.hpp"

namespace hidwa_local_planner::critics {

/// A registry with the critics of this package, by the names that the parameter `critics` takes. Link hidwa_critics.
CriticRegistry built_in();

}  // namespace hidwa_local_planner::critics
