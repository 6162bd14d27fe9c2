// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "control/control_loop.hpp"

namespace hidwa_local_planner {

/// What a cycle went without.
enum class Missing { nothing = 0, parameters, plan, odometry, costmap, transform, footprint };

/// What a cycle came to.
struct CycleResult : control::Result {
  Missing missing = Missing::nothing;
  std::string fault;  // the missing input, in words; then there is no decision
  Sampling sampling;  // in force
};

/// The decision's problem, and how many candidates each check and critic rejected.
std::string rejections_in_words(const Decision& decision);

/// What a host is told of a cycle: the fault, the problem, that it escapes; empty where it just drives.
std::string in_words(const CycleResult& result);

extern const char* const kEscapes;  // what is said while the robot leaves a collision

}  // namespace hidwa_local_planner
