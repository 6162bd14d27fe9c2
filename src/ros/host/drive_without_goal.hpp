// SPDX-License-Identifier: BSD-3-Clause
// Lets the operator drive while the host has no goal (drive_without_goal).
//
// 1. A host is idle when it has no goal (HostActions) and has not called the planner for a pause.
// 2. While it is idle and the operator steers, a timer runs a control cycle at the control rate and sends its command
//    on drive_topic. When the operator lets go, cycles brake to rest, zero is sent once, and then nothing.
// 3. From the first sign of a goal nothing is sent any more; the host's first cycle goes on from the last command.
// 4. An operator who still steers when a goal ends must be seen neutral first.
//
// The timer is served by the host's own callback thread. That ends before the host destroys its costmap: so no cycle
// runs on a costmap that is gone.
#pragma once

#include <string>

#include <ros/publisher.h>
#include <ros/timer.h>

#include "ros/host/host_actions.hpp"
#include "ros/planner_node.hpp"

namespace hidwa_local_planner {

class DriveWithoutGoal {
 public:
  /// `planner` outlives it; `name` for the log.
  DriveWithoutGoal(PlannerNode& planner, const std::string& name);
  ~DriveWithoutGoal();
  DriveWithoutGoal(const DriveWithoutGoal&) = delete;
  DriveWithoutGoal& operator=(const DriveWithoutGoal&) = delete;

 private:
  void tick();
  bool host_is_busy() const;
  bool begin(const std::string& topic);
  void end();
  void drive(bool stop);
  bool costmap_runs();

  PlannerNode& planner_;
  const std::string name_;
  HostActions actions_;
  ros::Publisher commands_;
  std::string topic_;     // of commands_, resolved
  double period_ = 0.0;   // of the timer [s]
  bool driving_ = false;  // commands are sent
  ros::Timer timer_;
};

}  // namespace hidwa_local_planner
