// SPDX-License-Identifier: BSD-3-Clause
// Counts calls of operator new in the whole program, shared libraries included. Linking
// allocation_counter.cpp replaces the global operators; memory taken from malloc directly is not seen.
#pragma once

#include <cstddef>

namespace hidwa_local_planner::test {

/// Counts while it lives, in every thread. One at a time.
class AllocationCounter {
 public:
  AllocationCounter();
  ~AllocationCounter();
  AllocationCounter(const AllocationCounter&) = delete;
  AllocationCounter& operator=(const AllocationCounter&) = delete;

  /// Allocations since construction.
  std::size_t count() const;
};

/// Allocations of the calling thread since it began; always counted.
std::size_t allocations_of_this_thread();

}  // namespace hidwa_local_planner::test
