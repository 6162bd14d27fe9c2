// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdio>
#include <string>

namespace hidwa_local_planner::robot {

/// A number as people write it: four digits, no trailing zeros.
inline std::string worded(double number) {
  char text[32];
  std::snprintf(text, sizeof(text), "%.4g", number);
  return text;
}

}  // namespace hidwa_local_planner::robot
