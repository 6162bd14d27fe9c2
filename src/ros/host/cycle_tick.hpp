// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "control/pause.hpp"

namespace hidwa_local_planner {

/// A call of the host, as seen from the one before.
struct CycleTick {
  bool jumped_back = false;  // time went backwards
  bool paused = false;       // the host was in control since the last call, or this is the first one
  double interval = 0.0;     // since the last call [s]; 0 where there is none
};

/// A call at `now` [s] with the nominal `period` [s]; `last`: when the cycle before was [s], see ControlLoop.
inline CycleTick cycle_tick(double now, double period, const std::optional<double>& last) {
  const double interval = last ? now - *last : 0.0;
  const bool jumped_back = interval < 0.0;
  return {jumped_back, !last || jumped_back || is_pause(interval, period), interval};
}

/// Whether others may have driven since the last call. Without a pause they have not. Simulated time that jumps back,
/// as in a bag that begins anew, looks like a pause: then `silence` [s], measured on the wall, tells.
inline bool host_was_away(const CycleTick& tick, double period, double silence) {
  return tick.jumped_back ? is_pause(silence, period) : tick.paused;
}

}  // namespace hidwa_local_planner
