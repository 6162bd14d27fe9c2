// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <costmap_2d/costmap_2d_ros.h>
#include <tf2_ros/buffer.h>

#include <string>

namespace nav_core {

/// What move_base asks of a recovery behaviour.
class RecoveryBehavior {
 public:
  virtual ~RecoveryBehavior() = default;

  virtual void initialize(std::string name, tf2_ros::Buffer* tf, costmap_2d::Costmap2DROS* global_costmap,
                          costmap_2d::Costmap2DROS* local_costmap) = 0;

  virtual void runBehavior() = 0;

 protected:
  RecoveryBehavior() = default;
};

}  // namespace nav_core
