// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "hidwa_local_planner/core/types.hpp"

namespace hidwa_local_planner {

/// Who is in control. The values are those of OperatorState.msg.
enum class OperatorStateId { autonomy = 0, shared, hold, manual, stopped, lost, blocked };

/// The name of a state as it is published: "AUTONOMY", "SHARED", ...
const char* to_string(OperatorStateId state);

/// How the planner takes u_h into account.
enum class Influence {
  none,    // autonomy alone: gamma = 0
  shared,  // the deviation from u_h is a cost: gamma = 1, Kalliokoski 2022, section III
  direct,  // u_h itself, or the legal control nearest to it
  stop     // brake to rest and hold
};

/// The operator command of one cycle, and how it counts, as plain values.
struct OperatorIntent {
  OperatorStateId state = OperatorStateId::autonomy;
  Influence influence = Influence::none;
  Twist2 u_h;           // wanted velocity, unclipped [m/s, rad/s]
  bool guarded = true;  // direct only: the legal control nearest to u_h, instead of u_h itself

  template <typename Self, typename Archive>
  static void archive(Self& self, Archive& io) {
    io(self.state, self.influence, self.u_h, self.guarded);
  }
};

}  // namespace hidwa_local_planner
