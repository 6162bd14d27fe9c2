// SPDX-License-Identifier: BSD-3-Clause
#include "sim/operator_device.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace hidwa_local_planner {
namespace sim {
namespace {

constexpr double kHandSpeed = 1.0;  // [m/s], unhurried
constexpr double kPress = 0.15;     // [s], that a press of a button lasts
constexpr double kContent = 0.4;    // [s], without a wish before control is given back

}  // namespace

Controls StickDevice::update(double /*time*/, const Stick& wanted) {
  Controls controls;
  controls.stick = wanted;
  return controls;
}

Controls HandDevice::update(double time, const Stick& wanted) {
  const double passed = std::isnan(time_) ? 0.0 : time - time_;
  time_ = time;
  const bool wants = wanted.left != 0.0;
  if (wants && !held_) {
    origin_ = position_;  // pressed before it moves
  } else {
    const double target = wants ? origin_ + wanted.left * range_ : 0.0;
    const double reach = kHandSpeed * passed;
    position_ += std::clamp(target - position_, -reach, reach);
  }
  held_ = wants;
  Controls controls;
  controls.clutch = held_;
  controls.hand_left = position_;
  controls.stick.up = std::min(0.0, wanted.up);  // pulled back it stops
  return controls;
}

Controls TakeoverDevice::update(double time, const Stick& wanted) {
  const bool wants = wanted.left != 0.0;
  if (wants) content_since_ = std::numeric_limits<double>::quiet_NaN();
  if (driving_ && !wants && std::isnan(content_since_)) content_since_ = time;
  const bool content = driving_ && !std::isnan(content_since_) && time - content_since_ >= kContent;
  // A new press begins only after the one before has ended.
  const bool ready = time >= pressed_until_ + kPress;
  if (ready && (driving_ ? content : wants)) {
    driving_ = !driving_;
    pressed_until_ = time + kPress;
    content_since_ = std::numeric_limits<double>::quiet_NaN();
  }
  Controls controls;
  controls.toggle = time < pressed_until_;
  if (driving_) controls.stick = {wanted.left, 1.0};
  return controls;
}

std::unique_ptr<OperatorDevice> make_operator_device(const std::string& mode, double gesture_range) {
  if (mode == "joystick") return std::make_unique<StickDevice>();
  if (mode == "gesture") return std::make_unique<HandDevice>(gesture_range);
  if (mode == "switching") return std::make_unique<TakeoverDevice>();
  throw std::invalid_argument("mode " + mode + ": there are joystick, gesture and switching");
}

}  // namespace sim
}  // namespace hidwa_local_planner
