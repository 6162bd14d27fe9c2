// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <costmap_2d/cost_values.h>
#include <costmap_2d/costmap_2d.h>
#include <costmap_2d/layer.h>
#include <geometry_msgs/Point.h>

#include <atomic>
#include <boost/shared_ptr.hpp>
#include <string>
#include <vector>

namespace costmap_2d {

/// The master grid and the layers that write it.
class LayeredCostmap {
 public:
  LayeredCostmap(std::string global_frame, bool rolling_window, bool track_unknown);

  /// One update around the robot's pose [m, m, rad] in the global frame; rewrites only what the layers say
  /// has changed, or the whole window when a rolling one has moved. Holds the master grid's mutex.
  void updateMap(double robot_x, double robot_y, double robot_yaw);

  const std::string& getGlobalFrameID() const noexcept { return global_frame_; }
  void resizeMap(unsigned int size_x, unsigned int size_y, double resolution, double origin_x,
                 double origin_y, bool size_locked = false);

  /// The last update's area [m].
  void getUpdatedBounds(double& min_x, double& min_y, double& max_x, double& max_y) const;
  /// The last update's area: cells x0 <= x < xn, y0 <= y < yn.
  void getBounds(unsigned int* x0, unsigned int* xn, unsigned int* y0, unsigned int* yn) const;

  /// True when every enabled layer is current.
  bool isCurrent() const;
  Costmap2D* getCostmap() { return &costmap_; }
  bool isRolling() const { return rolling_window_; }
  bool isTrackingUnknown() const { return costmap_.getDefaultValue() == NO_INFORMATION; }
  bool isSizeLocked() const { return size_locked_; }
  /// True after the first update.
  bool isInitialized() const { return initialized_; }

  std::vector<boost::shared_ptr<Layer>>* getPlugins() { return &plugins_; }
  void addPlugin(boost::shared_ptr<Layer> plugin) { plugins_.push_back(plugin); }

  /// The padded footprint; layers are told.
  void setFootprint(const std::vector<geometry_msgs::Point>& footprint_spec);
  const std::vector<geometry_msgs::Point>& getFootprint() const { return footprint_; }
  double getCircumscribedRadius() const { return circumscribed_radius_; }  // [m]
  double getInscribedRadius() const { return inscribed_radius_; }          // [m]

 private:
  bool followRobot(double robot_x, double robot_y);

  struct CellBounds {
    unsigned int x0 = 0, xn = 0, y0 = 0, yn = 0;
  };
  struct WorldBounds {
    double min_x = 0.0, min_y = 0.0, max_x = 0.0, max_y = 0.0;  // [m]
  };

  Costmap2D costmap_;
  const std::string global_frame_;
  const bool rolling_window_;
  std::atomic<bool> size_locked_{false};
  std::atomic<bool> initialized_{false};
  bool rewrite_all_ = true;
  CellBounds cells_;
  WorldBounds world_;
  std::vector<boost::shared_ptr<Layer>> plugins_;
  std::vector<geometry_msgs::Point> footprint_;
  std::atomic<double> circumscribed_radius_{0.0};  // [m]
  std::atomic<double> inscribed_radius_{0.0};      // [m]
};

}  // namespace costmap_2d
