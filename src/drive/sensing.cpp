// SPDX-License-Identifier: BSD-3-Clause
#include "sensing.hpp"

namespace hidwa_local_planner {
namespace drive {

Sensing::Sensing(const DriveSetup& setup)
    : setup_(setup), costmap_(setup.costmap, setup.outline), noise_(setup.laser_seed) {}

void Sensing::scan(const sim::World& world) {
  true_pose_ = world.pose();
  odometry_pose_ = world.odometry().pose();
  is_new_ = true;
}

void Sensing::update_costmap(const sim::World& world) {
  if (is_new_) {
    const sim::Pose sensor = sim::compose(true_pose_, setup_.laser_pose);
    sim::scan(setup_.ground->caster(), setup_.laser, sensor, noise_, ranges_);
    project(ranges_, setup_.laser, sim::compose(odometry_pose_, setup_.laser_pose), beams_);
    is_new_ = false;
  }
  costmap_.update(world.odometry().pose(), beams_);
}

}  // namespace drive
}  // namespace hidwa_local_planner
