// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <memory>
#include <string>

#include "sim/operator.hpp"

namespace hidwa_local_planner {
namespace sim {

/// What a person's hands do, as a device reports it.
struct Controls {
  Stick stick;
  bool toggle = false;     // the button that takes control and gives it back (SW)
  bool clutch = false;     // the button that is held while the hand steers (SG)
  double hand_left = 0.0;  // [m], where the hand is, left positive
};

/// How a person who wants the stick to the left makes the robot do it: each mode of steering has its device.
class OperatorDevice {
 public:
  virtual ~OperatorDevice() = default;
  /// `wanted`: what the person would do with a stick in shared control. Times [s] must not fall.
  virtual Controls update(double time, const Stick& wanted) = 0;
};

/// SJ: the stick itself.
class StickDevice : public OperatorDevice {
 public:
  Controls update(double time, const Stick& wanted) override;
};

/// SG: presses the clutch wherever the hand happens to be, moves it no faster than hands move, and lets go.
class HandDevice : public OperatorDevice {
 public:
  /// `range` [m]: the displacement that counts as full deflection.
  explicit HandDevice(double range) : range_(range) {}
  Controls update(double time, const Stick& wanted) override;

 private:
  double range_;
  bool held_ = false;
  double origin_ = 0.0;    // [m]
  double position_ = 0.0;  // [m]
  double time_ = std::numeric_limits<double>::quiet_NaN();
};

/// SW: takes control by a press of the button, drives at full speed where they want to go, and gives control back
/// by another press once they have wanted nothing for a moment.
class TakeoverDevice : public OperatorDevice {
 public:
  Controls update(double time, const Stick& wanted) override;

 private:
  bool driving_ = false;
  double pressed_until_ = -std::numeric_limits<double>::infinity();  // [s]
  double content_since_ = std::numeric_limits<double>::quiet_NaN();  // [s], while driving; NaN: not
};

/// The device for a mode of the planner: joystick, gesture or switching. Throws std::invalid_argument for others.
std::unique_ptr<OperatorDevice> make_operator_device(const std::string& mode, double gesture_range);

}  // namespace sim
}  // namespace hidwa_local_planner
