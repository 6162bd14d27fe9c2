// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <costmap_2d/layer.h>
#include <nav_msgs/OccupancyGrid.h>
#include <ros/ros.h>

#include <string>

namespace costmap_2d {

/// How map values become costs.
struct StaticMapValues {
  bool track_unknown_space = true;  // else unknown cells are free
  bool trinary = true;              // else values below the threshold become costs in proportion
  int lethal_threshold = 100;
  int unknown_value = -1;

  unsigned char cost(signed char value) const;
};

/// The map of a map server. A costmap that does not roll takes over its size, resolution and origin.
class StaticLayer : public Layer {
 public:
  void updateBounds(double robot_x, double robot_y, double robot_yaw, double* min_x, double* min_y,
                    double* max_x, double* max_y) override;
  void updateCosts(Costmap2D& master_grid, int min_i, int min_j, int max_i, int max_j) override;
  void reset() override;

 protected:
  /// Waits for the first map, serving callbacks meanwhile.
  void onInitialize() override;

 private:
  void onMap(const nav_msgs::OccupancyGrid& message);
  void copyAligned(Costmap2D& master, int min_i, int min_j, int max_i, int max_j) const;
  void copyTransformed(Costmap2D& master, int min_i, int min_j, int max_i, int max_j) const;

  Costmap2D map_;  // guarded by the master grid's mutex, as everything below
  std::string map_frame_;
  StaticMapValues values_;
  bool use_maximum_ = false;
  bool first_map_only_ = false;
  bool received_ = false;
  bool changed_ = false;
  ros::Subscriber subscriber_;
};

}  // namespace costmap_2d
