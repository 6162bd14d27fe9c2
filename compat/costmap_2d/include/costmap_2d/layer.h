// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <costmap_2d/costmap_2d.h>
#include <geometry_msgs/Point.h>
#include <tf2_ros/buffer.h>

#include <atomic>
#include <string>
#include <vector>

namespace costmap_2d {

class LayeredCostmap;

/// One source of costs. Each update asks every layer, in order, which area changed, then to write its costs
/// there. Both calls are made with the master grid's mutex held.
class Layer {
 public:
  virtual ~Layer() = default;

  void initialize(LayeredCostmap* parent, std::string name, tf2_ros::Buffer* tf);

  /// Widens [min_x, max_x] x [min_y, max_y] [m, global frame] to the area that this layer wants rewritten.
  virtual void updateBounds(double robot_x, double robot_y, double robot_yaw, double* min_x, double* min_y,
                            double* max_x, double* max_y);
  /// Writes the layer's costs into cells min_i <= x < max_i, min_j <= y < max_j of the master grid.
  virtual void updateCosts(Costmap2D& master_grid, int min_i, int min_j, int max_i, int max_j);

  virtual void activate() {}
  virtual void deactivate() {}
  virtual void reset() {}
  /// The master grid changed its size, resolution or origin.
  virtual void matchSize() {}
  virtual void onFootprintChanged() {}

  /// False while the layer's sources are older than they should be.
  bool isCurrent() const { return current_; }
  bool isEnabled() const noexcept { return enabled_; }
  const std::string& getName() const noexcept { return name_; }
  const std::vector<geometry_msgs::Point>& getFootprint() const;

 protected:
  /// Reads parameters and subscribes; layered_costmap_, name_ and tf_ are set.
  virtual void onInitialize() {}

  LayeredCostmap* layered_costmap_ = nullptr;
  std::atomic<bool> current_{true};
  std::atomic<bool> enabled_{true};
  std::string name_;
  tf2_ros::Buffer* tf_ = nullptr;
};

}  // namespace costmap_2d
