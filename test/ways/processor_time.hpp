// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ctime>

namespace hidwa_ways {

/// What this thread has used of a processor [s].
inline double processor_time() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace hidwa_ways
