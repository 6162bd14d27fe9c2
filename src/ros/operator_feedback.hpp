// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <sensor_msgs/JoyFeedbackArray.h>
#include <std_msgs/String.h>

#include "control/prediction.hpp"
#include "hidwa_local_planner/OperatorState.h"
#include "hidwa_local_planner/core/parameters.hpp"
#include "ros/cycle_result.hpp"
#include "ros/operator_input.hpp"

namespace hidwa_local_planner {

/// Tells the operator who is in control and how far the robot follows the operator command: as `operator_state`, as the
/// latched `mode`, as markers for rviz (`operator_markers`) and by the stick's motor. Messages are built only
/// when somebody subscribes.
class OperatorFeedback {
 public:
  /// `planner`: the planner's namespace; `host`: that of the devices; `frame`: the costmap's; `base_frame`:
  /// the robot's.
  OperatorFeedback(ros::NodeHandle planner, ros::NodeHandle host, std::string frame, std::string base_frame);

  /// Somebody listens to operator_state.
  bool state_wanted() const { return state_.getNumSubscribers() > 0; }
  /// Once a cycle, from the control thread. `prediction`: of this cycle; null where nobody
  /// listened when it was made: then there is no operator_state.
  void publish(const ros::Time& stamp, const Parameters& parameters, const CycleResult& result,
               const control::Prediction* prediction, const OperatorInput::Status& status);
  /// The mode in force, from whatever thread changes it (one at a time), also while no cycles run; published
  /// where it changed.
  void show_mode(OperatorMode mode);

 private:
  void fill(const ros::Time& stamp, const CycleResult& result, const OperatorInput::Status& status);
  void fill_next(const control::Prediction& prediction);
  void rumble();
  void send_rumble(float intensity);

  ros::NodeHandle host_;
  std::string frame_;
  std::string base_frame_;
  ros::Publisher state_, mode_, markers_, rumble_;
  std::string rumble_topic_;
  std::string shown_mode_;
  float rumbling_ = 0.0F;  // intensity last sent
  // Kept from cycle to cycle for their memory.
  OperatorState message_;
  sensor_msgs::JoyFeedbackArray rumble_message_;
};

/// The mode as parameters and topics call it.
std::string name_of(OperatorMode mode);

/// How strongly the stick should rumble, in [0, 1]: 0 without an operator command or at full agreement; the lower the
/// agreement, the stronger.
float rumble_intensity(bool active, double agreement);

}  // namespace hidwa_local_planner
