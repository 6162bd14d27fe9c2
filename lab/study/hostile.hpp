// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ostream>

#include "study/options.hpp"

namespace hidwa_local_planner {
namespace study {

/// hidwa_study hostile: people who want a collision, drive after drive, until `cycles` are driven
/// (docs/evidence/attack.md). Goes on where an earlier call into the same folder ended. 0: it held; 1: something within
/// the promise was found.
int hostile(const Options& options, std::ostream& out, std::ostream& errors);

/// Whether these parts are of a hostile study; joins them.
bool are_hostile(const std::vector<std::string>& parts);
int merge_hostile(const Options& options, std::ostream& out);

}  // namespace study
}  // namespace hidwa_local_planner
