// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <string>
#include <vector>

#include <nav_core/recovery_behavior.h>
#include <ros/publisher.h>
#include <ros/subscriber.h>

#include "input/yielding.hpp"
#include "ros/callback_thread.hpp"

namespace hidwa_local_planner {

/// A recovery behaviour of move_base that never drives. It brakes, waits while the operator stops or steers the robot,
/// then clears the costmaps far from the robot. Where HI-DWA is not the planner of this process it clears at once.
/// It catches every exception.
class YieldingRecovery : public nav_core::RecoveryBehavior {
 public:
  ~YieldingRecovery() override { thread_.stop(); }
  /// `name`: the namespace of the parameters below the node's own.
  void initialize(std::string name, tf2_ros::Buffer* tf, costmap_2d::Costmap2DROS* global_costmap,
                  costmap_2d::Costmap2DROS* local_costmap) override;
  /// Comes back after `patience` [s] at the latest.
  void runBehavior() override;

 private:
  struct Settings {
    input::Yielding::Settings yielding;
    double reset_distance = 3.0;           // side of the square that is kept [m]
    std::vector<std::string> layer_names;  // none: every obstacle layer
  };

  void start(const std::string& name);
  void hear_requests();
  void run();
  bool yield();
  void tell(input::Yielding::Phase phase);
  void clear(costmap_2d::Costmap2DROS& costmap) const;

  std::string name_;
  costmap_2d::Costmap2DROS* global_costmap_ = nullptr;  // null until it is initialized
  costmap_2d::Costmap2DROS* local_costmap_ = nullptr;
  Settings settings_;
  ros::Publisher velocity_;
  input::Yielding::Phase told_ = input::Yielding::Phase::quiet;
  std::atomic<bool> asked_{false};  // for something else, since this recovery began
  CallbackThread thread_;           // outlives the subscribers
  ros::Subscriber goal_, cancel_;
};

}  // namespace hidwa_local_planner
