// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "core/collision/collision.hpp"
#include "core/search/way.hpp"

namespace hidwa_local_planner {

/// The smallest clearance of the stations of a way that come up to three seconds after station `part`, on the map that
/// `collision` is prepared with; at most a cell, `cell` [m].
double room_ahead(const Way& way, std::size_t part, const CollisionChecker& collision, double cell);

}  // namespace hidwa_local_planner
