// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace hidwa_local_planner {
namespace study {

/// The path of one of the package's files, such as maps/office.yaml: where the package is installed, seen
/// from the program, or else where it was built from.
std::string share_file(const std::string& name);

}  // namespace study
}  // namespace hidwa_local_planner
