// SPDX-License-Identifier: BSD-3-Clause
#include <costmap_2d/footprint.h>
#include <costmap_2d/layered_costmap.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace costmap_2d {

typedef boost::unique_lock<Costmap2D::mutex_t> Lock;

LayeredCostmap::LayeredCostmap(std::string global_frame, bool rolling_window, bool track_unknown)
    : global_frame_(std::move(global_frame)), rolling_window_(rolling_window) {
  costmap_.setDefaultValue(track_unknown ? NO_INFORMATION : FREE_SPACE);
}

void LayeredCostmap::resizeMap(unsigned int size_x, unsigned int size_y, double resolution, double origin_x,
                               double origin_y, bool size_locked) {
  const Lock lock(*costmap_.getMutex());
  size_locked_ = size_locked;
  costmap_.resizeMap(size_x, size_y, resolution, origin_x, origin_y);
  rewrite_all_ = true;
  for (const auto& layer : plugins_) layer->matchSize();
}

bool LayeredCostmap::followRobot(double robot_x, double robot_y) {
  const double old_x = costmap_.getOriginX();
  const double old_y = costmap_.getOriginY();
  costmap_.updateOrigin(robot_x - costmap_.getSizeInMetersX() / 2, robot_y - costmap_.getSizeInMetersY() / 2);
  return costmap_.getOriginX() != old_x || costmap_.getOriginY() != old_y;
}

void LayeredCostmap::updateMap(double robot_x, double robot_y, double robot_yaw) {
  const Lock lock(*costmap_.getMutex());
  if (rolling_window_ && followRobot(robot_x, robot_y)) rewrite_all_ = true;

  constexpr double kFar = std::numeric_limits<double>::max();
  WorldBounds world{kFar, kFar, -kFar, -kFar};
  for (const auto& layer : plugins_) {
    if (layer->isEnabled()) {
      layer->updateBounds(robot_x, robot_y, robot_yaw, &world.min_x, &world.min_y, &world.max_x, &world.max_y);
    }
  }
  const unsigned int size_x = costmap_.getSizeInCellsX();
  const unsigned int size_y = costmap_.getSizeInCellsY();
  if (rewrite_all_) {
    world = {costmap_.getOriginX(), costmap_.getOriginY(), costmap_.getOriginX() + costmap_.getSizeInMetersX(),
             costmap_.getOriginY() + costmap_.getSizeInMetersY()};
  }
  if (world.min_x > world.max_x || world.min_y > world.max_y) return;

  int x0, y0, xn, yn;
  costmap_.worldToMapEnforceBounds(world.min_x, world.min_y, x0, y0);
  costmap_.worldToMapEnforceBounds(world.max_x, world.max_y, xn, yn);
  xn = std::min(static_cast<int>(size_x), xn + 1);
  yn = std::min(static_cast<int>(size_y), yn + 1);
  cells_ = {static_cast<unsigned int>(x0), static_cast<unsigned int>(xn), static_cast<unsigned int>(y0),
            static_cast<unsigned int>(yn)};
  world_ = world;

  costmap_.resetMap(cells_.x0, cells_.y0, cells_.xn, cells_.yn);
  for (const auto& layer : plugins_) {
    if (layer->isEnabled()) layer->updateCosts(costmap_, x0, y0, xn, yn);
  }
  rewrite_all_ = false;
  initialized_ = true;
}

void LayeredCostmap::getUpdatedBounds(double& min_x, double& min_y, double& max_x, double& max_y) const {
  const Lock lock(*costmap_.getMutex());
  min_x = world_.min_x;
  min_y = world_.min_y;
  max_x = world_.max_x;
  max_y = world_.max_y;
}

void LayeredCostmap::getBounds(unsigned int* x0, unsigned int* xn, unsigned int* y0, unsigned int* yn) const {
  const Lock lock(*costmap_.getMutex());
  *x0 = cells_.x0;
  *xn = cells_.xn;
  *y0 = cells_.y0;
  *yn = cells_.yn;
}

bool LayeredCostmap::isCurrent() const {
  return std::all_of(plugins_.begin(), plugins_.end(),
                     [](const auto& layer) { return !layer->isEnabled() || layer->isCurrent(); });
}

void LayeredCostmap::setFootprint(const std::vector<geometry_msgs::Point>& footprint_spec) {
  const Lock lock(*costmap_.getMutex());
  footprint_ = footprint_spec;
  double inscribed, circumscribed;
  calculateMinAndMaxDistances(footprint_spec, inscribed, circumscribed);
  inscribed_radius_ = inscribed;
  circumscribed_radius_ = circumscribed;
  rewrite_all_ = true;
  for (const auto& layer : plugins_) layer->onFootprintChanged();
}

}  // namespace costmap_2d
