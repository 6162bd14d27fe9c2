// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>

#include <ros/subscriber.h>
#include <topic_tools/shape_shifter.h>

#include "ros/callback_thread.hpp"

namespace hidwa_local_planner {

/// Hears what is asked of move_base while it is busy: another goal, or to cancel. It looks at these itself only after
/// the recovery that it runs.
class HostRequests {
 public:
  HostRequests();
  ~HostRequests();
  /// True where something was asked since the last call of clear().
  bool any() const { return asked_; }
  void clear() { asked_ = false; }

 private:
  std::atomic<bool> asked_{false};
  CallbackThread thread_;  // outlives the subscribers
  ros::Subscriber goal_, cancel_;
};

}  // namespace hidwa_local_planner
