// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdlib>

namespace hidwa_local_planner::test {

// True in the long form of a test, which HIDWA_LONG in the environment asks for.
inline bool long_form() { return std::getenv("HIDWA_LONG") != nullptr; }

// How many cases a test tries: `brief` where everybody runs it, `whole` in the long form.
template <typename Number>
Number effort(Number brief, Number whole) {
  return long_form() ? whole : brief;
}

}  // namespace hidwa_local_planner::test
