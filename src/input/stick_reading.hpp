// SPDX-License-Identifier: BSD-3-Clause
// From a stick's message to what it says, in steps:
// 1. what the mode reads of it is checked: the axes that steer, the buttons that are configured (read_stick);
// 2. axes and buttons are brought into the planner's directions (StickReading);
// 3. deflections become the operator command by the paper's map (command_of).
// What it says about stopping is read apart, since a stop counts from a faulty message too (stop_reading_of).
#pragma once

#include <string>
#include <vector>

#include "hidwa_local_planner/core/parameters.hpp"
#include "input/operator_command.hpp"
#include "input/operator_message.hpp"
#include "input/stop_reading.hpp"

namespace hidwa_local_planner::input {

/// One message of a stick.
struct StickMessage : OperatorMessage {
  DeviceShape shape() const override { return {axes.size(), buttons.size()}; }

  std::vector<float> axes;   // in [-1, 1]
  std::vector<int> buttons;  // 0 or 1
};

/// Where a stick stands, in the planner's directions, and which of its buttons are held. A button that is not
/// configured is not held.
struct StickReading {
  float angular = 0.0F;  // left positive, about [-1, 1]
  float linear = 0.0F;   // from its rest, forward positive, about [-1, 1]; 0 where the device does not have the axis
  bool enabled = false;  // enable_button
  bool toggle = false;   // toggle_button
  bool clutch = false;   // clutch_button, or clutch_axis beyond its threshold

  template <typename Self, typename Archive>
  static void archive(Self& self, Archive& io) {
    io(self.angular, self.linear, self.enabled, self.toggle, self.clutch);
  }
};

/// What a stick's messages mean: the parameters, and whether the stick gives the operator command. Where another device
/// does, only its buttons and its stop count.
struct StickUse {
  const Parameters& parameters;
  bool steers = true;
  /// The speed axis has not moved since the device was first seen. Its 0 then means axis_linear_rest: the driver has
  /// not heard of the axis yet.
  bool linear_untouched = false;
};

/// Judges how a device's speed axis begins. Drivers send 0 for a trigger or a pedal until it is touched, and from then
/// on its resting value, which is an end: for a stick that is full speed or a pull. An axis whose first movement leads
/// to an end (0.99 or more) is doubted, and counts as centred, until it has stood in its centre for 1 s. Axes 0 and 1
/// are never doubted, since they are a stick wherever there is one; nor is one whose axis_linear_rest is not 0.
class AxisStart {
 public:
  /// Another device, axis or rest begins anew. `now` [s].
  void observe(const StickMessage& message, const Parameters& parameters, double now);
  /// Whether the axis has not moved since the device of a message, which is still to be observed, was first seen.
  bool untouched(const StickMessage& message, const Parameters& parameters) const;
  /// Whether the axis of the device of a message is doubted.
  bool doubts(const StickMessage& message, const Parameters& parameters) const;
  bool doubted() const { return doubted_; }
  float end() const { return end_; }  // 1 or -1: where the doubted axis went

 private:
  struct Of {
    std::string sender;
    std::size_t axes = 0;
    int index = 0;
    double rest = 0.0;
    bool is(const StickMessage& message, const Parameters& parameters) const;
  };
  Of of_;
  bool moved_ = false;
  bool doubted_ = false;
  bool centred_ = false;
  double centred_since_ = 0.0;  // [s]
  float end_ = 0.0F;
};

/// Reads a message by the parameters axis_*, *_button and clutch_*. Returns the fault in words, naming the
/// remedy, and leaves `reading` alone when the message cannot be used: it lacks an axis or button that the mode
/// needs, or has there what is no number or out of range. What nobody reads may hold anything. The linear axis is
/// needed with `linear: axis` and in mode `switching`; where pulling it back stops, it may be missing,
/// but not out of range. Where another device steers, no axis of the stick is needed, but its buttons are.
std::string read_stick(const StickMessage& message, const StickUse& use, StickReading& reading);

/// Whether the speed axis is read by these parameters: for the speed, or because pulling it back stops.
bool reads_linear_axis(const StickUse& use);

/// What a message says about stopping. Pulling the stick back stops in mode `joystick` where the stick steers, unless
/// it asks for reverse, and in mode `gesture`.
StopReading stop_reading_of(const StickMessage& message, const StickUse& use);

/// One axis: 0 where |deflection| <= dead_zone, else |deflection|^exponent with its sign, times maximum.
/// Kalliokoski 2022, the maps of (p_x, p_y) to (v_h, omega_h) in section IV-A. Deflections beyond [-1, 1] are
/// clipped.
double map_axis(double deflection, double dead_zone, double exponent, double maximum);

/// What a reading asks for (Kalliokoski 2022, section IV-A): in SJ u_h = (max_vel_x, map(angular)), or with
/// `linear: axis`, as in SW, (map(linear), map(angular)). Active while the mapped command is not zero; where
/// there is an enable button, while that is held: a centred stick then means straight on.
OperatorCommand command_of(const StickReading& reading, const Parameters& parameters);

/// The same map for any two deflections, left and forward positive, beyond [-1, 1] clipped. With
/// `linear: current` the v of u_h is left at 0, for that of the robot.
OperatorCommand command_of_deflection(float angular, float linear, const Parameters& parameters);

}  // namespace hidwa_local_planner::input
