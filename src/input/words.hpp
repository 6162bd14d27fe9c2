// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdio>
#include <string>

namespace hidwa_local_planner::input {

/// A number as a person writes it: 0.5, 3, 12.3.
inline std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof(text), "%.3g", value);
  return text;
}

}  // namespace hidwa_local_planner::input
