// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "hidwa_local_planner/core/parameters.hpp"
#include "sim/diff_drive.hpp"

namespace hidwa_local_planner::test {

/// A base that does what these parameters say of it.
inline sim::DriveLimits limits_of(const Parameters& p) {
  sim::DriveLimits limits;
  limits.max_vel_x = p.max_vel_x;
  limits.max_vel_theta = p.max_vel_theta;
  limits.acc_lim_x = p.acc_lim_x;
  limits.decel_lim_x = p.braking_x();
  limits.acc_lim_theta = p.acc_lim_theta;
  limits.decel_lim_theta = p.braking_theta();
  limits.latency = p.control_latency;
  return limits;
}

}  // namespace hidwa_local_planner::test
