// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "hidwa_local_planner/core/types.hpp"

namespace hidwa_local_planner {

/// The corners of the convex hull [m], counter-clockwise, without those on a straight side; of points on a line its
/// ends.
Polygon convex_hull(Polygon points);

}  // namespace hidwa_local_planner
