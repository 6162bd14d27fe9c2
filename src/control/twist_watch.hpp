// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "hidwa_local_planner/core/types.hpp"
#include "hidwa_local_planner/core/util/archive.hpp"

namespace hidwa_local_planner::control {

/// Whether the measured velocity can be believed. Some bases and simulators report a velocity that is always 0, or that
/// is given in another frame than the robot's, while the pose is right. Where the pose moves as it was commanded and
/// the velocity says something else, for a second, the velocity is taken from the pose until the measured one has
/// agreed with it for ten seconds of driving.
///
/// What is compared are averages of about the last half second. A base that does not move as it was commanded, since it
/// is blocked or slips, proves nothing. A velocity of more than twice what the robot can drive, in mm/s for example, is
/// no velocity however the robot moves, if the pose moves more slowly.
class TwistWatch {
 public:
  /// What a cycle at `now` [s] knows: the robot's pose in a frame that stands still, measured `pose_age` [s] ago, its
  /// measured velocity, the command that was in force since the cycle before, and how fast the robot can be.
  struct Seen {
    double now = 0.0;
    double pose_age = 0.0;
    Pose2 pose;
    Twist2 measured;
    Twist2 command;
    Twist2 fastest;  // to either side
  };
  void observe(const Seen& seen);
  /// Others drove, or the time was set: what comes next has no past.
  void interrupt() { known_ = false; }

  bool doubts() const { return doubts_; }
  const Twist2& from_pose() const { return from_pose_; }  // the velocity that the last two poses give [m/s, rad/s]

  template <typename Self, typename Archive>
  static void archive(Self& self, Archive& io) {
    io(self.known_, self.doubts_, self.time_, self.pose_, self.from_pose_, self.by_pose_, self.by_twist_,
       self.by_command_, self.differs_, self.agrees_);
  }

 private:
  enum class Verdict { none, agrees, differs };
  Verdict verdict(double Twist2::*axis, double least, double most) const;

  bool known_ = false;
  bool doubts_ = false;
  double time_ = 0.0;                       // of the last pose [s]
  Pose2 pose_;                              // the last one
  Twist2 from_pose_;                        // [m/s, rad/s]
  Twist2 by_pose_, by_twist_, by_command_;  // averages [m/s, rad/s]
  double differs_ = 0.0, agrees_ = 0.0;     // driving time without and with agreement [s]
};

}  // namespace hidwa_local_planner::control
