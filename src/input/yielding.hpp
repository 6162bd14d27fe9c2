// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <optional>

#include "hidwa_local_planner/core/operator_intent.hpp"

namespace hidwa_local_planner::input {

/// True while an operator stops the robot or steers it. `manual`: they have taken control, whatever the state.
bool attends(OperatorStateId state, bool manual);

/// A recovery waits before it clears: until the robot stands, and nobody stops or steers it. Knows no clock: time is an
/// argument [s].
class Yielding {
 public:
  struct Settings {
    double quiet_time = 0.5;  // nobody attends for this time before it goes on [s]
    double patience = 10.0;   // it goes on after so long in any case [s]
  };
  enum class Phase { braking, yielding, quiet, out_of_patience };

  explicit Yielding(const Settings& settings) : settings_(settings) {}
  /// One cycle at `now` [s]. `stands`: the robot stands; `attended`: the operator stops or steers it. Time that goes
  /// back counts as no time.
  Phase step(double now, bool stands, bool attended);

 private:
  Settings settings_;
  std::optional<double> last_;                              // [s]
  double spent_ = 0.0;                                      // since the first step [s]
  double quiet_ = std::numeric_limits<double>::infinity();  // since somebody attended last [s]
};

}  // namespace hidwa_local_planner::input
