// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ostream>

#include "study/options.hpp"

namespace hidwa_local_planner {
namespace study {

/// `hidwa_study passage`. Returns the exit code.
int passage(Options options, std::ostream& out, std::ostream& errors);

}  // namespace study
}  // namespace hidwa_local_planner
