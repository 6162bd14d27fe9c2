// SPDX-License-Identifier: BSD-3-Clause
#include <costmap_2d/cost_values.h>
#include <costmap_2d/footprint.h>
#include <costmap_2d/layered_costmap.h>
#include <costmap_2d/obstacle_layer.h>

#include <algorithm>
#include <sstream>

namespace costmap_2d {

void ObstacleLayer::onInitialize() {
  ros::NodeHandle nh("~/" + name_);
  enabled_ = nh.param("enabled", true);
  footprint_clearing_ = nh.param("footprint_clearing_enabled", true);
  max_obstacle_height_ = nh.param("max_obstacle_height", 2.0);
  overwrite_ = nh.param("combination_method", 1) == 0;
  const bool track_unknown = nh.param("track_unknown_space", layered_costmap_->isTrackingUnknown());
  setDefaultValue(track_unknown ? NO_INFORMATION : FREE_SPACE);
  matchSize();

  const double transform_tolerance = nh.param("transform_tolerance", 0.2);
  std::istringstream names(nh.param<std::string>("observation_sources", ""));
  for (std::string name; names >> name;) {
    sources_.push_back(
        std::make_unique<ScanSource>(nh, name, *tf_, layered_costmap_->getGlobalFrameID(), transform_tolerance));
  }
  if (sources_.empty()) ROS_WARN("%s: observation_sources is empty; no obstacle will be seen.", name_.c_str());
}

void ObstacleLayer::activate() {
  for (const auto& source : sources_) {
    source->subscribe();
    source->resetLastUpdate();
  }
}

void ObstacleLayer::deactivate() {
  for (const auto& source : sources_) source->unsubscribe();
}

void ObstacleLayer::reset() {
  for (const auto& source : sources_) {
    source->forget();
    source->resetLastUpdate();
  }
  matchSize();
}

void ObstacleLayer::updateBounds(double robot_x, double robot_y, double robot_yaw, double* min_x, double* min_y,
                                 double* max_x, double* max_y) {
  const Costmap2D& master = *layered_costmap_->getCostmap();
  updateOrigin(master.getOriginX(), master.getOriginY());
  useExtraBounds(min_x, min_y, max_x, max_y);
  const TouchedArea touched{min_x, min_y, max_x, max_y};

  current_ = std::all_of(sources_.begin(), sources_.end(), [](const auto& source) { return source->isCurrent(); });

  // All clearing before all marking: no beam erases what another one of this update has seen.
  for (const auto& source : sources_) {
    const auto seen = source->latest();
    if (source->clearing() && seen && !clearBeams(*this, *seen, touched)) {
      ROS_WARN_THROTTLE(1.0, "%s: the sensor at (%.2f, %.2f) lies outside the costmap; its beams clear nothing.",
                        name_.c_str(), seen->origin.x, seen->origin.y);
    }
  }
  for (const auto& source : sources_) {
    const auto seen = source->latest();
    if (source->marking() && seen) markPoints(*this, *seen, max_obstacle_height_, touched);
  }
  if (footprint_clearing_) {
    transformFootprint(robot_x, robot_y, robot_yaw, getFootprint(), footprint_now_);
    for (const geometry_msgs::Point& corner : footprint_now_) touched.add(corner.x, corner.y);
  }
}

void ObstacleLayer::updateCosts(Costmap2D& master_grid, int min_i, int min_j, int max_i, int max_j) {
  if (footprint_clearing_) setConvexPolygonCost(footprint_now_, FREE_SPACE);
  (overwrite_ ? mergeOverwrite : mergeMaximum)(master_grid, *this, min_i, min_j, max_i, max_j);
}

}  // namespace costmap_2d
