// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ostream>
#include <string>
#include <vector>

namespace hidwa_local_planner {
namespace study {

/// hidwa_study: does what the arguments after the program's name say. Results are told to `out`, progress and
/// errors to `errors`. Returns the exit code: 0; 1 where a run could not be made; 2 where the arguments make
/// no sense.
int program(const std::vector<std::string>& arguments, std::ostream& out, std::ostream& errors);

}  // namespace study
}  // namespace hidwa_local_planner
