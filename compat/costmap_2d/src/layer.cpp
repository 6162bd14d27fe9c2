// SPDX-License-Identifier: BSD-3-Clause
#include <costmap_2d/layer.h>
#include <costmap_2d/layered_costmap.h>

#include <utility>

namespace costmap_2d {

void Layer::initialize(LayeredCostmap* parent, std::string name, tf2_ros::Buffer* tf) {
  layered_costmap_ = parent;
  name_ = std::move(name);
  tf_ = tf;
  onInitialize();
}

void Layer::updateBounds(double /*robot_x*/, double /*robot_y*/, double /*robot_yaw*/, double* /*min_x*/,
                         double* /*min_y*/, double* /*max_x*/, double* /*max_y*/) {}

void Layer::updateCosts(Costmap2D& /*master_grid*/, int /*min_i*/, int /*min_j*/, int /*max_i*/, int /*max_j*/) {}

const std::vector<geometry_msgs::Point>& Layer::getFootprint() const { return layered_costmap_->getFootprint(); }

}  // namespace costmap_2d
