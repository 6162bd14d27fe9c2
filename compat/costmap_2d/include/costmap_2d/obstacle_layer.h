// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <costmap_2d/costmap_layer.h>
#include <costmap_2d/scan_source.h>

#include <memory>
#include <vector>

namespace costmap_2d {

/// Obstacles seen by lasers: marks where beams end, clears where they pass, and under the robot itself.
class ObstacleLayer : public CostmapLayer {
 public:
  void updateBounds(double robot_x, double robot_y, double robot_yaw, double* min_x, double* min_y,
                    double* max_x, double* max_y) override;
  void updateCosts(Costmap2D& master_grid, int min_i, int min_j, int max_i, int max_j) override;
  void activate() override;
  void deactivate() override;
  void reset() override;

 protected:
  /// Throws std::runtime_error when the parameters ask for what is not supported.
  void onInitialize() override;

 private:
  std::vector<std::unique_ptr<ScanSource>> sources_;
  std::vector<geometry_msgs::Point> footprint_now_;  // [m] global frame
  double max_obstacle_height_ = 2.0;                 // [m]
  bool footprint_clearing_ = true;
  bool overwrite_ = false;
};

}  // namespace costmap_2d
