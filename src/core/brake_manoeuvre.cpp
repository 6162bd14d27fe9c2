// SPDX-License-Identifier: BSD-3-Clause
#include "hidwa_local_planner/core/brake_manoeuvre.hpp"

namespace hidwa_local_planner {

void roll_out(const BrakeManoeuvre& manoeuvre, const VelocityLimits& limits, double radius, double spacing,
              std::vector<Pose2>& poses) {
  poses.clear();
  const Pose2& start = manoeuvre.start;
  ManoeuvreRoller roller(limits, radius, spacing, {start, {std::cos(start.theta), std::sin(start.theta)}});
  roller.roll(manoeuvre, [&poses](const TurnedPose& at) {
    poses.push_back(at.pose);
    return true;
  });
}

}  // namespace hidwa_local_planner
