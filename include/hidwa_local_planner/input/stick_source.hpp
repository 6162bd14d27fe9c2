// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "hidwa_local_planner/core/parameters.hpp"
#include "hidwa_local_planner/input/stick_message.hpp"
#include "hidwa_local_planner/input/wish.hpp"

namespace hidwa_local_planner::input {

/// Where a stick stands, in the planner's directions, and which of its buttons are held. A button that is not
/// configured is not held.
struct StickReading {
  float angular = 0.0F;  // left positive, about [-1, 1]
  float linear = 0.0F;   // forward positive, about [-1, 1]; 0 where the device does not have the axis
  bool enabled = false;  // enable_button
  bool toggle = false;   // toggle_button
  bool clutch = false;   // clutch_button, or clutch_axis beyond its threshold

  template <typename Self, typename Archive>
  static void archive(Self& self, Archive& io) {
    io(self.angular, self.linear, self.enabled, self.toggle, self.clutch);
  }
};

/// Reads a message by the parameters axis_*, *_button and clutch_*. Returns the fault in words, naming the
/// remedy, and leaves `reading` alone when the message cannot be used: it lacks an axis or button that the mode
/// needs, or has there what is no number or out of range. What nobody reads may hold anything. The linear axis is
/// needed with `linear: axis` and in mode `switching`; where pulling it back stops, it may be missing,
/// but not out of range. Where a Twist or a hand steers, no axis of the stick is needed, but its buttons are.
std::string read_stick(const StickMessage& message, const Parameters& parameters, StickReading& reading);

/// What a message says about stopping, in so far as it can be read, whatever else is wrong with it.
struct StopReading {
  bool button = false;         // stop_button is pressed
  std::optional<double> back;  // the stick is pulled back so far, about [-1, 1]; none where that means no stop
  std::uint32_t axes = 0;      // so many it has
  std::uint32_t buttons = 0;   // so many it has
};
StopReading read_stop(const StickMessage& message, const Parameters& parameters);

/// What a reading asks for (Kalliokoski 2022, section IV-A): in SJ u_h = (max_vel_x, map(angular)), or with
/// `linear: axis`, as in SW, (map(linear), map(angular)). Active while the mapped command is not zero; where
/// there is an enable button, while that is held: a centred stick then means straight on.
Wish wish_of(const StickReading& reading, const Parameters& parameters);

/// The same map for any two deflections, left and forward positive, beyond [-1, 1] clipped. With
/// `linear: current` the v of u_h is left at 0 for the robot's own.
Wish wish_of_deflection(float angular, float linear, const Parameters& parameters);

/// Whether a Twist takes the stick's place.
bool steered_by_twist(const Parameters& parameters);

/// Whether pulling the stick back stops: in SJ and SG, unless it asks for reverse.
bool pull_stops(const Parameters& parameters);

}  // namespace hidwa_local_planner::input
