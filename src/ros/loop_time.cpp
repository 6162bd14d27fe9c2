// SPDX-License-Identifier: BSD-3-Clause
#include "hidwa_local_planner/ros/loop_time.hpp"

namespace hidwa_local_planner {

LoopTime LoopTime::now() {
  const ros::Time stamp = ros::Time::now();
  if (ros::Time::isSimTime()) return {stamp.toSec(), stamp};
  const double steady = ros::SteadyTime::now().toSec();
  static const double ahead = stamp.toSec() - steady;
  return {steady + ahead, stamp};
}

}  // namespace hidwa_local_planner
