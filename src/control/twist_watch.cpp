// SPDX-License-Identifier: BSD-3-Clause
#include "control/twist_watch.hpp"

#include <algorithm>
#include <cmath>

namespace hidwa_local_planner::control {
namespace {

constexpr double kLongestGap = 0.5;  // [s]; poses that are farther apart do not tell a velocity
constexpr double kAveraged = 0.5;    // [s]
constexpr double kDiffers = 1.0;     // [s] before a velocity is doubted
constexpr double kAgrees = 10.0;     // [s] before it is believed again
// Slower commands tell too little.
constexpr double kDrives = 0.1;  // [m/s]
constexpr double kTurns = 0.2;   // [rad/s]
// What the pose may differ from the commands, and the velocity from the pose. Ramps and latency differ by less.
constexpr double kMostOff = 0.5;
constexpr double kImpossible = 2.0;  // times as fast as the robot can be

Twist2 towards(const Twist2& average, const Twist2& value, double share) {
  return {average.v + share * (value.v - average.v), average.omega + share * (value.omega - average.omega)};
}

}  // namespace

void TwistWatch::observe(const Seen& seen) {
  const double time = seen.now - seen.pose_age;
  const double passed = time - time_;
  if (!known_ || passed < 0.0 || passed > kLongestGap) {
    known_ = true;
    time_ = time;
    pose_ = seen.pose;
    from_pose_ = by_pose_ = by_twist_ = by_command_ = seen.measured;
    differs_ = agrees_ = 0.0;
    return;
  }
  if (passed < 1e-3) return;  // the pose of the cycle before
  const double turn = wrap_angle(seen.pose.theta - pose_.theta);
  const double heading = pose_.theta + 0.5 * turn;
  const double ahead = (seen.pose.x - pose_.x) * std::cos(heading) + (seen.pose.y - pose_.y) * std::sin(heading);
  from_pose_ = {ahead / passed, turn / passed};
  const double share = 1.0 - std::exp(-passed / kAveraged);
  by_pose_ = towards(by_pose_, from_pose_, share);
  by_twist_ = towards(by_twist_, seen.measured, share);
  by_command_ = towards(by_command_, seen.command, share);
  time_ = time;
  pose_ = seen.pose;

  const Verdict drives = verdict(&Twist2::v, kDrives, seen.fastest.v);
  const Verdict turns = verdict(&Twist2::omega, kTurns, seen.fastest.omega);
  const bool differs = drives == Verdict::differs || turns == Verdict::differs;
  const bool agrees = !differs && (drives == Verdict::agrees || turns == Verdict::agrees);
  differs_ = differs ? differs_ + passed : 0.0;
  if (differs) agrees_ = 0.0;
  if (agrees) agrees_ += passed;
  if (differs_ >= kDiffers) doubts_ = true;
  if (agrees_ >= kAgrees) doubts_ = false;
}

TwistWatch::Verdict TwistWatch::verdict(double Twist2::*axis, double least, double most) const {
  const double commanded = by_command_.*axis, moved = by_pose_.*axis, said = by_twist_.*axis;
  if (std::abs(said) > kImpossible * most && std::abs(moved) <= most) return Verdict::differs;
  if (std::abs(commanded) < least || std::abs(moved - commanded) > kMostOff * std::abs(commanded)) return Verdict::none;
  return std::abs(said - moved) > kMostOff * std::abs(moved) ? Verdict::differs : Verdict::agrees;
}

}  // namespace hidwa_local_planner::control
