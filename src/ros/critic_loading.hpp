// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "hidwa_local_planner/core/critic_registry.hpp"

namespace hidwa_local_planner {

/// The built-in critics and those that other packages export for pluginlib:
///   <export><hidwa_local_planner plugin="${prefix}/critics.xml"/></export>
/// A class `package/Name` is known by that name, by its C++ type and, where no other critic has it, as
/// `Name`. Classes are loaded when they are first made. The registry keeps the class loader alive.
CriticRegistry registry_with_plugins();

}  // namespace hidwa_local_planner
