// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ostream>

#include "study/options.hpp"

namespace hidwa_local_planner {
namespace study {

/// What the command of the same name does. Returns the program's exit code.
int barn(const Options& options, std::ostream& out, std::ostream& errors);
int dynabarn(const Options& options, std::ostream& out, std::ostream& errors);
int crowd(const Options& asked, std::ostream& out, std::ostream& errors);
int passage(const Options& asked, std::ostream& out, std::ostream& errors);
int gap(const Options& options, std::ostream& out, std::ostream& errors);
int attack(const Options& asked, std::ostream& out, std::ostream& errors);

}  // namespace study
}  // namespace hidwa_local_planner
