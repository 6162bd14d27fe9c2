// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>

#include <dynamic_reconfigure/Config.h>
#include <ros/node_handle.h>
#include <ros/subscriber.h>

namespace hidwa_local_planner {

/// The rate of the host's control cycle [Hz]: its parameter controller_frequency, which can change while move_base
/// runs.
class HostFrequency {
 public:
  /// Reads the parameter of this node, or of a namespace above it.
  HostFrequency();
  /// From now on follows what the node's dynamic_reconfigure server announces; `node`: its private namespace.
  void follow(ros::NodeHandle node);
  double get() const { return frequency_; }  // > 0 [Hz]

 private:
  void take(double frequency);
  void receive(const dynamic_reconfigure::Config& config);

  std::atomic<double> frequency_;
  ros::Subscriber subscriber_;
};

}  // namespace hidwa_local_planner
