// SPDX-License-Identifier: BSD-3-Clause
#include "hidwa_local_planner/input/gesture_source.hpp"

#include <cmath>

#include "core/util/words.hpp"
#include "hidwa_local_planner/input/stick_source.hpp"

namespace hidwa_local_planner::input {
namespace {

constexpr double kNoQuaternion = 1e-3;  // of a shorter norm

// Trackers that have lost the hand send zeros, some with a proper identity orientation.
std::string fault_of(const HandMessage& message) {
  if (!message.position.allFinite() || !message.orientation.allFinite()) {
    return "the hand's pose is not a finite number: look at the sender";
  }
  if (message.orientation.norm() < kNoQuaternion) {
    return "the hand is not tracked (its orientation is all zero): bring it back into view";
  }
  const bool identity = message.orientation.head<3>().norm() < kNoQuaternion;
  if (identity && message.position.norm() == 0.0) {
    return "the hand is not tracked (its pose is the identity): bring it back into view";
  }
  return {};
}

float deflection(const Eigen::Vector3d& displacement, HandAxis axis, int sign, double range) {
  return static_cast<float>(sign * displacement[static_cast<int>(axis)] / range);
}

}  // namespace

void GestureSource::set_clutch(bool held) {
  if (!held) waits_ = false;
  if (!held || !clutch_) has_origin_ = false;
  clutch_ = held;
}

std::string GestureSource::take(const HandMessage& message, const Parameters& parameters) {
  std::string fault = fault_of(message);
  if (fault.empty() && engaged()) {
    const double jump = (message.position - position_).norm();
    if (jump > parameters.gesture_jump) {
      fault = "the hand jumped by " + worded(jump, 3) + " m, more than gesture_jump (" +
              worded(parameters.gesture_jump, 3) + " m): tracking is not to be trusted";
    }
  }
  if (!fault.empty()) {
    lose();
    return fault;
  }
  position_ = message.position;
  if (clutch_ && !waits_ && !has_origin_) {
    origin_ = position_;
    has_origin_ = true;
  }
  return {};
}

void GestureSource::lose() {
  if (clutch_) waits_ = true;
  has_origin_ = false;
}

Wish GestureSource::wish(const Parameters& parameters) const {
  if (!engaged()) return {};
  const Eigen::Vector3d moved = position_ - origin_;
  return wish_of_deflection(
      deflection(moved, parameters.gesture_axis, parameters.gesture_axis_sign, parameters.gesture_range),
      deflection(moved, parameters.gesture_linear_axis, parameters.gesture_linear_sign, parameters.gesture_range),
      parameters);
}

}  // namespace hidwa_local_planner::input
