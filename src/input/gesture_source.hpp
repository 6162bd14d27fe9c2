// SPDX-License-Identifier: BSD-3-Clause
// A hand with a clutch (Kalliokoski 2022, section IV-A, SG), in steps:
// 1. pressing the clutch, a button of the stick, makes the hand's position the origin;
// 2. the displacement from there along gesture_axis, divided by gesture_range, deflects as a stick does;
// 3. releasing the clutch ends the input at once, not with the next pose.
//
// Tracking is lost by an invalid pose (all-zero quaternion, everything zero, not a number), by one that lies farther
// than 0.3 m from the one before it while the clutch is held, and by the silence of the hand or of the clutch.
// Then, and at the start, the clutch must be let go and pressed anew: the origin may have moved meanwhile, and a hand
// that comes back elsewhere must not steer.
#pragma once

#include <string>

#include <Eigen/Core>

#include "input/operator_source.hpp"
#include "input/silence_timer.hpp"

namespace hidwa_local_planner::input {

/// One pose of a tracked hand, in whatever frame the tracking has.
struct HandMessage : OperatorMessage {
  Eigen::Vector3d position{0.0, 0.0, 0.0};          // [m]
  Eigen::Vector4d orientation{0.0, 0.0, 0.0, 0.0};  // quaternion x, y, z, w; only its being one matters
};

struct HandState {
  bool clutch = false;            // held
  bool waits_for_release = true;  // until the clutch is seen released
  bool has_origin = false;
  Eigen::Vector3d origin{0.0, 0.0, 0.0};    // [m]
  Eigen::Vector3d position{0.0, 0.0, 0.0};  // newest [m]
  SilenceTimer hand, clutch_device;

  template <typename Self, typename Archive>
  static void archive(Self& self, Archive& io) {
    io(self.clutch, self.waits_for_release, self.has_origin, self.origin, self.position, self.hand, self.clutch_device);
  }
};

class GestureSource : public SourceOf<HandMessage, HandState> {
 public:
  SourceKind kind() const override { return {"hand", false, true}; }
  SourceTopic topic(const Parameters& parameters) const override;
  bool can_steer(const Parameters& p) const override { return p.mode == OperatorMode::gesture; }
  bool same_device(const Parameters& a, const Parameters& b) const override;
  bool same_mapping(const Parameters& a, const Parameters& b) const override;
  std::optional<OperatorCommand> take_buttons(const Buttons& buttons, double now) override;
  /// Inactive unless engaged.
  OperatorCommand command() const override;
  /// Poses may go on without the device whose button is the clutch; and where poses fell silent, the origin is old.
  bool gone(double now) const override;
  void lose() override;
  void exclude_pause(double pause) override;
  std::string advice() const override;

  /// The clutch is held and the hand steers.
  bool engaged() const { return state_.clutch && state_.has_origin; }

 protected:
  SourceReading taken(const HandMessage& message, double now) override;

 private:
  /// The clutch is held, but was not let go since the start or a loss.
  bool waits_for_release() const { return state_.clutch && state_.waits_for_release; }
};

}  // namespace hidwa_local_planner::input
