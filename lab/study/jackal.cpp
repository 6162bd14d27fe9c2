// SPDX-License-Identifier: BSD-3-Clause
#include "study/jackal.hpp"

#include <algorithm>

#include "drive/outline.hpp"

namespace hidwa_local_planner {
namespace study {
namespace {

// A Jackal: jackal_navigation's footprint; jackal_control's velocity limits, and the accelerations that
// launch/params /jackal.yaml states; its front laser, of 270 degrees.
const sim::Polygon kFootprint{{0.21, 0.165}, {-0.21, 0.165}, {-0.21, -0.165}, {0.21, -0.165}};  // [m]
constexpr double kLaserForward = 0.12;                                                          // [m]
constexpr double kLaserView = 4.7124;                                                           // [rad]
constexpr int kBeams = 720;
constexpr double kLaserNoise = 0.01;  // [m]
constexpr double kSlip = 0.01;        // of the odometry
constexpr double kLatency = 0.05;     // [s], one cycle

sim::DriveLimits jackal_limits() {
  sim::DriveLimits limits;
  limits.max_vel_x = 2.0;
  limits.max_vel_theta = 4.0;
  limits.acc_lim_x = limits.decel_lim_x = 10.0;
  limits.acc_lim_theta = limits.decel_lim_theta = 20.0;
  limits.latency = kLatency;
  return limits;
}

// A local costmap must hold what is rolled out, or its edge limits the speed.
drive::CostmapSettings wide_enough(drive::CostmapSettings costmap, const Parameters& parameters) {
  const double reach = parameters.max_vel_x * parameters.sim_time + sim::circumscribed_radius(kFootprint);
  costmap.width = std::max(costmap.width, 2.0 * reach + 0.5);
  costmap.obstacle_range = std::max(costmap.obstacle_range, 0.75 * costmap.width);  // to its corners
  costmap.raytrace_range = costmap.obstacle_range + 0.5;
  return costmap;
}

}  // namespace

drive::DriveSetup jackal(const BarnSubject& subject) {
  drive::DriveSetup setup;
  setup.plan_radius = subject.plan_radius;
  setup.footprint = kFootprint;
  setup.outline = drive::padded_outline(kFootprint, subject.padding);
  setup.limits = jackal_limits();
  setup.odometry_noise.slip_x = setup.odometry_noise.slip_theta = kSlip;
  setup.laser.beams = kBeams;
  setup.laser.field_of_view = kLaserView;
  setup.laser.noise = setup.tracker.range_noise = kLaserNoise;
  setup.laser_pose = {kLaserForward, 0.0, 0.0};
  setup.parameters = subject.subject.parameters;
  setup.costmap = wide_enough(subject.costmap, setup.parameters);
  setup.link_delay = subject.subject.link_delay;
  return setup;
}

}  // namespace study
}  // namespace hidwa_local_planner
