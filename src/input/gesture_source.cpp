// SPDX-License-Identifier: BSD-3-Clause
#include "input/gesture_source.hpp"

#include <cmath>

#include "core/util/words.hpp"
#include "input/stick_reading.hpp"

namespace hidwa_local_planner::input {
namespace {

constexpr double kJump = 0.3;           // farther than a hand gets between two poses [m]
constexpr double kNoQuaternion = 1e-3;  // of a shorter norm

// Trackers that have lost the hand send zeros, some with a proper identity orientation.
std::string why_not_tracked(const HandMessage& message) {
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

std::string why_jumped(double jump) {
  if (!(jump > kJump)) return {};
  return "the hand jumped by " + worded(jump, 3) + " m between two poses, more than " + worded(kJump, 3) +
         " m: its tracking is unreliable; bring it back into view";
}

float deflection(const Eigen::Vector3d& displacement, HandAxis axis, double range) {
  const int sign = axis >= HandAxis::minus_x ? -1 : 1;
  return static_cast<float>(sign * displacement[static_cast<int>(axis) % 3] / range);
}

}  // namespace

SourceTopic GestureSource::topic(const Parameters& p) const {
  if (p.gesture_frame.empty()) return {"gesture_topic", p.gesture_topic, p.gesture_topic};
  return {"gesture_topic", "", "tf " + p.gesture_parent_frame + " -> " + p.gesture_frame};
}

bool GestureSource::same_device(const Parameters& a, const Parameters& b) const {
  return a.gesture_topic == b.gesture_topic && a.gesture_frame == b.gesture_frame &&
         a.gesture_parent_frame == b.gesture_parent_frame;
}

bool GestureSource::same_mapping(const Parameters& a, const Parameters& b) const {
  return a.gesture_axis == b.gesture_axis && a.gesture_linear_axis == b.gesture_linear_axis;
}

// A release counts at once, not with the hand's next pose.
std::optional<OperatorCommand> GestureSource::take_buttons(const Buttons& buttons, double now) {
  state_.clutch_device.restart(now);
  if (!buttons.clutch) state_.waits_for_release = false;
  if (!buttons.clutch || !state_.clutch) state_.has_origin = false;
  state_.clutch = buttons.clutch;
  if (state_.clutch) return std::nullopt;
  return OperatorCommand{};
}

// A clutch that is still held after a loss says nothing: the loss lasts until it is let go.
SourceReading GestureSource::taken(const HandMessage& message, double now) {
  SourceReading reading;
  reading.fault = why_not_tracked(message);
  if (reading.fault.empty() && engaged()) {
    reading.fault = why_jumped((message.position - state_.position).norm());
  }
  if (!reading.fault.empty()) {
    lose();
    return reading;
  }
  state_.hand.restart(now);
  state_.position = message.position;
  if (waits_for_release()) return reading;
  if (state_.clutch && !state_.has_origin) {
    state_.origin = state_.position;
    state_.has_origin = true;
  }
  reading.command = command();
  return reading;
}

OperatorCommand GestureSource::command() const {
  if (!engaged()) return {};
  const Parameters& p = parameters();
  const Eigen::Vector3d moved = state_.position - state_.origin;
  return command_of_deflection(deflection(moved, p.gesture_axis, p.gesture_range),
                               deflection(moved, p.gesture_linear_axis, p.gesture_range), p);
}

bool GestureSource::gone(double now) const {
  const double timeout = parameters().input_timeout;
  if (timeout <= 0.0 || !state_.clutch) return false;
  return state_.clutch_device.silence(now) > timeout || (engaged() && state_.hand.silence(now) > timeout);
}

void GestureSource::lose() {
  if (state_.clutch) state_.waits_for_release = true;
  state_.has_origin = false;
}

void GestureSource::exclude_pause(double pause) {
  state_.hand.exclude_pause(pause);
  state_.clutch_device.exclude_pause(pause);
}

std::string GestureSource::advice() const {
  if (!waits_for_release()) return {};
  return "The hand does not steer yet: release its clutch, then press it again.";
}

}  // namespace hidwa_local_planner::input
