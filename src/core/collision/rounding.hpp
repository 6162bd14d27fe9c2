// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

namespace hidwa_local_planner {

// Lengths of this order are rounding, touching included: more than a position's rounding over a rollout.
inline constexpr double kRounding = 1e-9;  // [m]

// How far a coordinate lies outside of [-half, half] [m].
inline double beyond(double value, double half) { return std::max(std::abs(value) - half, 0.0); }

}  // namespace hidwa_local_planner
