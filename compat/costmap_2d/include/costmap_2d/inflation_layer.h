// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <costmap_2d/inflator.h>
#include <costmap_2d/layer.h>

namespace costmap_2d {

/// Costs round what the layers before it marked as lethal.
class InflationLayer : public Layer {
 public:
  void updateBounds(double robot_x, double robot_y, double robot_yaw, double* min_x, double* min_y,
                    double* max_x, double* max_y) override;
  void updateCosts(Costmap2D& master_grid, int min_i, int min_j, int max_i, int max_j) override;
  void matchSize() override;
  void onFootprintChanged() override;

  unsigned char computeCost(double distance) const { return inflator_.costAt(distance); }

  /// `inflation_radius` [m], `cost_scaling_factor` [1/m].
  void setInflationParameters(double inflation_radius, double cost_scaling_factor);

 protected:
  void onInitialize() override;

 private:
  void configure();

  Inflator::Settings settings_;
  Inflator inflator_;
};

}  // namespace costmap_2d
