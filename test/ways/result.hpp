// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

#include "ways/finding.hpp"

namespace hidwa_ways {

/// What became of one scene. Times from the start [s]; negative: never.
struct Result {
  std::string kind, body, repeat;  // `repeat`: the arguments that repeat it alone
  std::uint64_t seed = 0;
  bool reverse = false;
  double resolution = 0.0;  // [m]
  Class answer = Class::open;
  double way_length = 0.0, way_time = 0.0;  // of the way that was found [m], [s]
  bool verified = false;                    // the slow check agrees with that way

  double nearer_at = -1.0, nearer_limit = 0.0;
  double through_at = -1.0, through_limit = 0.0;
  double failed_at = -1.0;   // the first outcome FAIL that says why
  bool failed_late = false;  // no such outcome in time
  std::string problem;       // what it said
  bool touched = false;
  double depth = 0.0;  // of the deepest touch [m]
  int cycles = 0;
  double worst_cycle = 0.0;  // of the processor's time [s]
  std::uint64_t print = 0;   // of all commands and poses: two runs can be compared

  bool nearer() const { return nearer_at >= 0.0 && nearer_at <= nearer_limit; }
  bool through() const { return through_at >= 0.0 && through_at <= through_limit; }
  /// What is asked of its class.
  bool good() const {
    if (touched) return false;
    if (answer == Class::sure) return verified && nearer() && through();
    return answer == Class::open || (!failed_late && through_at < 0.0);
  }
};

}  // namespace hidwa_ways
