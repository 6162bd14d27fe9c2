// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <string>

#include "hidwa_local_planner/core/types.hpp"

namespace hidwa_local_planner::control {

/// Why a local costmap in the frame `costmap` of a robot whose own frame is `base` cannot be used, with the remedy;
/// empty where it can. Everything that the planner remembers of places is remembered in the costmap's frame, and so are
/// the costmap's own obstacles: it must be a frame that stands still.
inline std::string fault_of_frames(const std::string& costmap, const std::string& base) {
  const auto plain = [](const std::string& frame) { return frame.substr(frame.empty() || frame[0] != '/' ? 0 : 1); };
  if (plain(costmap) != plain(base)) return {};
  return "the local costmap's global_frame is " + costmap +
         ", the robot's own frame: its obstacles move along with the robot. Set the local costmap's global_frame to "
         "odom";
}

/// Notices a costmap frame that moves with the robot under another name, or a pose that is not renewed: the robot
/// drives, and its pose stays the same to the last bit.
class FrameWatch {
 public:
  /// One cycle, `interval` [s] after the one before: the robot's pose in the costmap's frame, and what it drives
  /// [m/s, rad/s].
  void observe(const Pose2& pose, const Twist2& velocity, double interval) {
    const bool same = pose.x == pose_.x && pose.y == pose_.y && pose.theta == pose_.theta;
    driven_ = same ? driven_ + std::abs(velocity.v) * interval : 0.0;
    turned_ = same ? turned_ + std::abs(velocity.omega) * interval : 0.0;
    pose_ = pose;
  }
  /// The robot drove for long, and its pose did not change.
  bool stands_still() const { return driven_ > kDriven || turned_ > kTurned; }

 private:
  static constexpr double kDriven = 1.0;  // [m]
  static constexpr double kTurned = 2.0;  // [rad]

  Pose2 pose_;
  double driven_ = 0.0;  // since the pose changed [m]
  double turned_ = 0.0;  // [rad]
};

}  // namespace hidwa_local_planner::control
