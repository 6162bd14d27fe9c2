// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include <Eigen/Core>

#include "hidwa_local_planner/core/parameters.hpp"
#include "hidwa_local_planner/input/wish.hpp"

namespace hidwa_local_planner::input {

/// One pose of a tracked hand, in whatever frame the tracking has.
struct HandMessage {
  Eigen::Vector3d position{0.0, 0.0, 0.0};          // [m]
  Eigen::Vector4d orientation{0.0, 0.0, 0.0, 0.0};  // quaternion x, y, z, w; only its being one matters
  double stamp = 0.0;                               // header stamp [s]; 0 where the sender leaves it empty
  double received = 0.0;                            // when it arrived [s]
  std::string sender = {};                          // who sent it, where known
};

/// A hand with a clutch (Kalliokoski 2022, section IV-A, SG): pressing the clutch makes the hand's position
/// the origin; from there its displacement along gesture_axis, divided by gesture_range, deflects as a stick
/// does.
///
/// Tracking is lost by a pose that is none (all-zero quaternion, everything zero, not a number) and by one
/// that lies farther than gesture_jump from the one before it while the clutch is held. Then, and at the
/// start, the clutch must be let go and pressed anew.
class GestureSource {
 public:
  /// The clutch, as last heard.
  void set_clutch(bool held);
  /// Takes a pose. Returns why tracking is lost, in words; empty where it is not.
  std::string take(const HandMessage& message, const Parameters& parameters);
  /// The origin is no longer to be trusted: the clutch must be pressed anew.
  void lose();
  void reset() { *this = GestureSource(); }

  bool clutch() const { return clutch_; }
  /// The clutch is held and the hand steers.
  bool engaged() const { return clutch_ && has_origin_; }
  /// The clutch is held, but was not let go since the start or a loss.
  bool waits_for_release() const { return clutch_ && waits_; }
  /// What the hand asks for; inactive unless engaged.
  Wish wish(const Parameters& parameters) const;

  template <typename Self, typename Archive>
  static void archive(Self& self, Archive& io) {
    io(self.clutch_, self.waits_, self.has_origin_, self.origin_, self.position_);
  }

 private:
  bool clutch_ = false;
  bool waits_ = true;  // until the clutch is seen released
  bool has_origin_ = false;
  Eigen::Vector3d origin_{0.0, 0.0, 0.0};    // [m]
  Eigen::Vector3d position_{0.0, 0.0, 0.0};  // newest [m], while the clutch is held
};

}  // namespace hidwa_local_planner::input
