// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace hidwa_local_planner::input {

/// One axis: 0 where |deflection| <= dead_zone, else |deflection|^exponent with its sign, times maximum.
/// Kalliokoski 2022, the maps of (p_x, p_y) to (v_h, omega_h) in section IV-A. Deflections beyond [-1, 1] are
/// clipped.
double map_axis(double deflection, double dead_zone, double exponent, double maximum);

}  // namespace hidwa_local_planner::input
