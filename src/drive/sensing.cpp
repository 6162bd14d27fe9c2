// SPDX-License-Identifier: BSD-3-Clause
#include "sensing.hpp"

namespace hidwa_local_planner {
namespace drive {

Sensing::Sensing(const DriveSetup& setup)
    : setup_(setup), costmap_(setup.costmap, setup.outline), noise_(setup.laser_seed) {
  // A beam that meets nothing ends just inside the range: such ends are none.
  constexpr double kShort = 0.1;  // [m]
  if (setup.explore) seen_.emplace(*setup.ground->map(), setup.laser.range_max - kShort);
}

void Sensing::scan(const sim::World& world) {
  true_pose_ = world.pose();
  odometry_pose_ = world.odometry().pose();
  is_new_ = true;
}

void Sensing::update_costmap(const sim::World& world) {
  if (is_new_) {
    const sim::Pose sensor = sim::compose(true_pose_, setup_.laser_pose);
    const auto range = [&](double angle) {
      return setup_.ground->range(sensor.x, sensor.y, angle, setup_.laser.range_max);
    };
    sim::scan(range, setup_.laser, sensor.theta, noise_, ranges_);
    if (seen_) {
      project(ranges_, setup_.laser, sensor, beams_);
      seen_->add(beams_);
    }
    project(ranges_, setup_.laser, sim::compose(odometry_pose_, setup_.laser_pose), beams_);
    is_new_ = false;
  }
  costmap_.update(world.odometry().pose(), beams_);
}

}  // namespace drive
}  // namespace hidwa_local_planner
