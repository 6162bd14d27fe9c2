// SPDX-License-Identifier: BSD-3-Clause
#include <costmap_2d/inflation_layer.h>
#include <costmap_2d/layered_costmap.h>
#include <ros/node_handle.h>

#include <limits>

namespace costmap_2d {

void InflationLayer::onInitialize() {
  const ros::NodeHandle nh("~/" + name_);
  enabled_ = nh.param("enabled", true);
  settings_.inflate_unknown = nh.param("inflate_unknown", false);
  setInflationParameters(nh.param("inflation_radius", 0.55), nh.param("cost_scaling_factor", 10.0));
}

void InflationLayer::setInflationParameters(double inflation_radius, double cost_scaling_factor) {
  settings_.inflation_radius = inflation_radius;
  settings_.cost_scaling_factor = cost_scaling_factor;
  configure();
}

void InflationLayer::matchSize() { configure(); }

void InflationLayer::onFootprintChanged() { configure(); }

void InflationLayer::configure() {
  const double resolution = layered_costmap_->getCostmap()->getResolution();
  if (!(resolution > 0.0)) return;  // matchSize() follows
  settings_.resolution = resolution;
  settings_.inscribed_radius = layered_costmap_->getInscribedRadius();
  inflator_.configure(settings_);
}

void InflationLayer::updateBounds(double /*robot_x*/, double /*robot_y*/, double /*robot_yaw*/, double* min_x,
                                  double* min_y, double* max_x, double* max_y) {
  if (*min_x > *max_x || *min_y > *max_y) return;  // nothing changed
  const double reach = (inflator_.radiusInCells() + 1) * settings_.resolution;
  *min_x -= reach;
  *min_y -= reach;
  *max_x += reach;
  *max_y += reach;
}

void InflationLayer::updateCosts(Costmap2D& master_grid, int min_i, int min_j, int max_i, int max_j) {
  inflator_.inflate(master_grid, min_i, min_j, max_i, max_j);
}

}  // namespace costmap_2d
