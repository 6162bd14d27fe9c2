// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

#include "hidwa_local_planner/core/types.hpp"

namespace hidwa_local_planner {

/// What a check of first commands has found: many samples share one. A command whose slot another one takes is checked
/// again.
class CommandResults {
 public:
  CommandResults() : results_(kSize) {}

  /// New candidates, or a new cycle: nothing is known.
  void forget() { ++generation_; }

  /// Whether the command [m/s, rad/s] is free, as `check()` says.
  template <typename Check>
  bool free(const Twist2& command, Check&& check) {
    Result& known = results_[hash_of(command) % kSize];
    if (known.generation != generation_ || !(known.command == command)) known = {command, generation_, check()};
    return known.free;
  }

 private:
  static constexpr std::size_t kSize = 1024;
  struct Result {
    Twist2 command;
    std::uint64_t generation = 0;
    bool free = false;
  };
  static std::size_t hash_of(const Twist2& command) {
    std::uint64_t v = 0, omega = 0;
    std::memcpy(&v, &command.v, sizeof(v));
    std::memcpy(&omega, &command.omega, sizeof(omega));
    const std::uint64_t mixed = (v * 0x9E3779B97F4A7C15ULL) ^ ((omega + 0x632BE59BD9B4E019ULL) * 0xC2B2AE3D27D4EB4FULL);
    return static_cast<std::size_t>(mixed >> 40U);
  }

  std::vector<Result> results_;  // by a hash of the command
  std::uint64_t generation_ = 1;
};

}  // namespace hidwa_local_planner
