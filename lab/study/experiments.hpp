// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "study/options.hpp"

namespace hidwa_local_planner {
namespace study {

/// What the command of the same name does. Returns the program's exit code.
int barn(const Options& options, std::ostream& out, std::ostream& errors);
int dynabarn(const Options& options, std::ostream& out, std::ostream& errors);
int crowd(const Options& asked, std::ostream& out, std::ostream& errors);
int passage(const Options& asked, std::ostream& out, std::ostream& errors);
int gap(const Options& options, std::ostream& out, std::ostream& errors);

/// Likewise: one control loop for hours of simulated time, with random goals, people who steer and walk, faults and
/// changed parameters. Writes minutes.csv and summary.json. 0: memory and cycle time stay flat, every cycle was
/// answered, every state was seen, nothing was touched; else 1.
int soak(const Options& options, std::ostream& out, std::ostream& errors);

/// Likewise: people who want a collision, drive after drive, until `cycles` are driven (docs/evidence/attack.md). Goes
/// on where an earlier call into the same folder ended. 0: it held; 1: something within the promise was found.
int hostile(const Options& options, std::ostream& out, std::ostream& errors);

/// Whether these parts are of a hostile study; joins them.
bool are_hostile(const std::vector<std::string>& parts);
int merge_hostile(const Options& options, std::ostream& out);

}  // namespace study
}  // namespace hidwa_local_planner
