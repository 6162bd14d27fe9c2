// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "spec.hpp"

namespace hidwa_attack {

// How hard the robot brakes by what the planner is told [m/s^2, rad/s^2]: 0 means as it accelerates. The campaign's own
// reading of the parameters.
inline double braking(double told, double acc) { return told != 0.0 ? std::abs(told) : acc; }
inline double braking_x(const Parameters& p) { return braking(p.decel_lim_x, p.acc_lim_x); }
inline double braking_theta(const Parameters& p) { return braking(p.decel_lim_theta, p.acc_lim_theta); }

}  // namespace hidwa_attack
