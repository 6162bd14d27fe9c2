// SPDX-License-Identifier: BSD-3-Clause
#include "ros/horizon_check.hpp"

#include <algorithm>

#include "core/motion/velocity_limits.hpp"
#include "core/util/words.hpp"

namespace hidwa_local_planner {
std::vector<std::string> horizon_complaints(const Parameters& p, const AxisLimits& x, double map_width,
                                            double map_height, double circumscribed_radius) {
  std::vector<std::string> complaints;
  const double stopping_time = x.time_to_rest(x.fastest()) + p.control_latency;  // [s]
  if (p.sim_time < stopping_time) {
    complaints.push_back(
        format("sim_time = %.2f s is shorter than the robot needs to stop (max_vel_x / deceleration + "
               "control_latency = %.2f s): raise sim_time to %.2f s or lower max_vel_x",
               p.sim_time, stopping_time, stopping_time));
  }
  const double reach = x.fastest() * p.sim_time + circumscribed_radius;  // [m]
  const double half = 0.5 * std::min(map_width, map_height);             // [m]
  if (half < reach) {
    complaints.push_back(
        format("the local costmap reaches %.2f m from the robot, but a candidate may reach %.2f m "
               "(max_vel_x sim_time + circumscribed radius): set its width and height to %.1f m, or "
               "lower sim_time or max_vel_x",
               half, reach, 2.0 * reach + 0.05));
  }
  return complaints;
}

}  // namespace hidwa_local_planner
