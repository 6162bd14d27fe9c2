// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>

#include "summary.hpp"

namespace hidwa_attack {

struct Extent {
  int drives = 300;  // of each condition
  int seconds = 20;  // of each drive [s]
  std::uint64_t first_seed = 1;
  int threads = 1;
};

/// All drives of a condition, in the order of their seeds, whatever the number of threads.
std::vector<DriveResult> run(const Condition& condition, const Extent& extent);

}  // namespace hidwa_attack
