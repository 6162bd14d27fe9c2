// SPDX-License-Identifier: BSD-3-Clause
#include "ros/host/costmap_clearing.hpp"

#include <algorithm>

#include <costmap_2d/costmap_layer.h>
#include <costmap_2d/obstacle_layer.h>

#include "core/util/words.hpp"

namespace hidwa_local_planner {
namespace {

// A layer's name is that of its costmap, a slash and its own.
std::string own_name(const costmap_2d::Layer& layer) {
  const std::string name = layer.getName();
  return name.substr(name.rfind('/') + 1);
}

// The layer where it is meant and can be cleared.
costmap_2d::CostmapLayer* meant(costmap_2d::Layer& layer, const std::vector<std::string>& names) {
  if (names.empty()) return dynamic_cast<costmap_2d::ObstacleLayer*>(&layer);
  const bool named = std::find(names.begin(), names.end(), own_name(layer)) != names.end();
  return named ? dynamic_cast<costmap_2d::CostmapLayer*>(&layer) : nullptr;
}

void clear_outside(costmap_2d::CostmapLayer& layer, const geometry_msgs::Point& centre, double side) {
  int left = 0, bottom = 0, right = 0, top = 0;
  layer.worldToMapNoBounds(centre.x - 0.5 * side, centre.y - 0.5 * side, left, bottom);
  layer.worldToMapNoBounds(centre.x + 0.5 * side, centre.y + 0.5 * side, right, top);
  layer.clearArea(left, bottom, right, top);
  layer.addExtraBounds(layer.getOriginX(), layer.getOriginY(), layer.getOriginX() + layer.getSizeInMetersX(),
                       layer.getOriginY() + layer.getSizeInMetersY());
}

}  // namespace

std::vector<std::string> clear_far_from_robot(costmap_2d::Costmap2DROS& costmap, double side,
                                              const std::vector<std::string>& layers, std::string& fault) {
  std::vector<std::string> cleared;
  geometry_msgs::PoseStamped robot;
  if (!costmap.getRobotPose(robot)) {
    fault = "there is no pose of the robot in " + costmap.getGlobalFrameID() + ": check tf";
    return cleared;
  }
  costmap_2d::LayeredCostmap& layered = *costmap.getLayeredCostmap();
  // Layers are updated with this mutex held.
  const boost::unique_lock<costmap_2d::Costmap2D::mutex_t> lock(*layered.getCostmap()->getMutex());
  for (const auto& layer : *layered.getPlugins()) {
    costmap_2d::CostmapLayer* wanted = meant(*layer, layers);
    if (wanted == nullptr) continue;
    clear_outside(*wanted, robot.pose.position, side);
    cleared.push_back(own_name(*layer));
  }
  if (cleared.empty()) {
    fault = layers.empty() ? "it has no obstacle layer" : "it has no layer " + joined(layers) + " that can be cleared";
  }
  return cleared;
}

}  // namespace hidwa_local_planner
