// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "hidwa_local_planner/core/types.hpp"

namespace hidwa_local_planner {

/// The area inside a polygon, negative where its corners go right round [m^2].
double signed_area(const Polygon& outline);
/// Without corners that lie on the one before them. What is not a number repeats nothing.
Polygon without_repeats(const Polygon& outline);

}  // namespace hidwa_local_planner
