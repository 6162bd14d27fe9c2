// SPDX-License-Identifier: BSD-3-Clause
#include "sensing.hpp"

#include <cmath>
#include <cstddef>

namespace hidwa_local_planner {
namespace drive {

Sensing::Sensing(const DriveSetup& setup)
    : setup_(setup), costmap_(setup.costmap, setup.outline), people_(*setup.ground->map()), noise_(setup.laser_seed) {
  // A beam that meets nothing ends just inside the range: such ends are none.
  constexpr double kShort = 0.1;  // [m]
  if (setup.tracking == Tracking::laser) tracker_.emplace(setup.tracker);
  if (setup.explore) seen_.emplace(*setup.ground->map(), setup.laser.range_max - kShort);
}

void Sensing::scan(const sim::World& world) {
  true_pose_ = world.pose();
  odometry_pose_ = world.odometry().pose();
  silhouettes_ = sim::Silhouettes(world.movers());
  ids_.clear();
  for (const sim::Mover& mover : world.movers()) ids_.push_back(mover.id);
  if (tracker_) {
    cast();
    track(world.time());
  }
  is_new_ = true;
}

void Sensing::update_costmap(const sim::World& world) {
  if (is_new_) {
    if (!tracker_) cast();
    if (seen_) {
      project(ranges_, setup_.laser, sim::compose(true_pose_, setup_.laser_pose), beams_);
      seen_->add(beams_);
    }
    project(ranges_, setup_.laser, sim::compose(odometry_pose_, setup_.laser_pose), beams_);
    is_new_ = false;
  }
  costmap_.update(world.odometry().pose(), beams_);
  if (setup_.tracking == Tracking::truth) people_.keep_marked(costmap_.view());
}

// The last scan's ranges, and whom each beam meets.
void Sensing::cast() {
  const sim::Pose sensor = sim::compose(true_pose_, setup_.laser_pose);
  met_.clear();
  const auto range = [&](double angle) {
    const double to_ground = setup_.ground->range(sensor.x, sensor.y, angle, setup_.laser.range_max);
    const sim::Silhouettes::Hit hit = silhouettes_.cast(sensor.x, sensor.y, angle, setup_.laser.range_max);
    const bool somebody = hit.range < to_ground;
    met_.push_back(somebody ? ids_[hit.mover] : 0);
    return somebody ? hit.range : to_ground;
  };
  sim::scan(range, setup_.laser, sensor.theta, noise_, ranges_);
  if (setup_.tracking == Tracking::truth) remember_people(sensor);
}

void Sensing::track(double now) {
  RangeScan scan;
  scan.stamp = now;
  scan.angle_min = setup_.laser.angle_min();
  scan.angle_increment = setup_.laser.angle_increment();
  scan.range_min = setup_.laser.range_min;
  scan.range_max = setup_.laser.range_max;
  scan.ranges = ranges_;
  const sim::Pose sensor = sim::compose(odometry_pose_, setup_.laser_pose);
  scan.sensor = scan.sensor_end = {sensor.x, sensor.y, sensor.theta};
  tracker_->update(scan);
}

void Sensing::remember_people(const sim::Pose& sensor) {
  const sim::Pose in_odometry = sim::compose(odometry_pose_, setup_.laser_pose);
  const auto end = [](const sim::Pose& from, double angle, double range) {
    return Point(from.x + range * std::cos(from.theta + angle), from.y + range * std::sin(from.theta + angle));
  };
  for (std::size_t k = 0; k < met_.size(); ++k) {
    const double angle = setup_.laser.angle_min() + static_cast<double>(k) * setup_.laser.angle_increment();
    const double range = static_cast<double>(ranges_[k]);
    if (met_[k] == 0 || !std::isfinite(range)) continue;
    people_.add(met_[k], end(sensor, angle, range), end(in_odometry, angle, range));
  }
}

MovingObstacleEstimates Sensing::moving_obstacles(const sim::World& world, const sim::Pose& map_in_odometry) const {
  if (setup_.tracking == Tracking::none) return {};
  if (tracker_) {
    MovingObstacleEstimates tracks = tracker_->obstacles();
    for (MovingObstacleEstimate& track : tracks) track.age = world.time() - tracker_->stamp();
    return tracks;
  }
  return people_.truth(world.movers(), map_in_odometry);
}

SensorSectors Sensing::sensor_sectors() const {
  if (!tracker_) return {};
  SensorSectors sectors = tracker_->field_of_view();
  for (SensorSector& sector : sectors) {
    const sim::Pose pose = sim::compose(setup_.laser_pose, {sector.pose.x, sector.pose.y, sector.pose.theta});
    sector.pose = {pose.x, pose.y, pose.theta};
  }
  return sectors;
}

}  // namespace drive
}  // namespace hidwa_local_planner
