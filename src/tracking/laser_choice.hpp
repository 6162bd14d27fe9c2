// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace hidwa_local_planner {
namespace tracking {

/// One laser is tracked. Where several send on one topic, the way from one to the other would count as driven: the one
/// that is heard counts, the others are refused until it falls silent.
class LaserChoice {
 public:
  /// Falls silent after so long [s].
  static constexpr double kSilent = 1.0;

  /// Why a scan in `frame` that comes at `now` [s] is not to be used; empty: it is.
  std::string fault(const std::string& frame, double now);

 private:
  std::string frame_;   // that of the laser that counts
  double heard_ = 0.0;  // [s]
};

/// Why scans with an angle of `increment` [rad] from beam to beam show too little, in words; empty: they show enough.
std::string coarse(double increment);

}  // namespace tracking
}  // namespace hidwa_local_planner
