// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ostream>

#include "study/options.hpp"

namespace hidwa_local_planner {
namespace study {

/// hidwa_study soak: one control loop for hours of simulated time, with random goals, people who steer and walk, faults
/// and changed parameters. Writes minutes.csv and summary.json. 0: memory and cycle time stay flat, every cycle was
/// answered, every state was seen, nothing was touched; else 1.
int soak(const Options& options, std::ostream& out, std::ostream& errors);

}  // namespace study
}  // namespace hidwa_local_planner
