// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <random>

namespace hidwa_local_planner {
namespace sim {

/// Random numbers that are the same on every platform for the same seed (the distributions of <random> are
/// not).
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}

  /// Uniform in [0, 1).
  double uniform() { return static_cast<double>(engine_() >> 11) * 0x1.0p-53; }

  /// Normal with mean 0 and standard deviation 1 (Box and Muller 1958).
  double normal();

 private:
  std::mt19937_64 engine_;
};

}  // namespace sim
}  // namespace hidwa_local_planner
