// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include <ros/node_handle.h>

#include "control/control_loop.hpp"
#include "control/prediction.hpp"
#include "ros/diagnostics.hpp"
#include "ros/loop_time.hpp"
#include "ros/operator_feedback.hpp"
#include "ros/operator_input.hpp"
#include "ros/publishing.hpp"

namespace hidwa_local_planner {

/// What a planner tells of its cycles: topics, the log, diagnostics. From the host's control thread.
class Outputs {
 public:
  struct Names {
    std::string planner;
    std::string frame, base_frame;  // of the costmap, of the robot
  };
  /// `handle`: the planner's namespace; `diagnostics`: a handle whose callback queue serves the diagnostics. The last
  /// two must outlive it.
  Outputs(const Names& names, const ros::NodeHandle& handle, const ros::NodeHandle& diagnostics,
          const OperatorInput& person, const MovingObstacleInput& moving_obstacles);

  /// Tells whether records, candidates and predictions are wanted.
  Publishing& publishing() { return publishing_; }
  /// Shows the mode, from whatever thread changes it.
  OperatorFeedback& feedback() { return feedback_; }
  Diagnostics& diagnostics() { return diagnostics_; }

  /// Predicts the next seconds of the cycle just run, where somebody watches; its costmap must still be valid.
  void predict(const control::ControlLoop& loop, const control::Observation& observation,
               const control::Result& result);
  /// Tells of the cycle just run: its topics and, in the log, why the robot does not just drive.
  void tell(const LoopTime& now, const control::ControlLoop& loop, const CycleResult& result,
            const OperatorInput::Status& status);
  /// The cycle took `duration` of its `period` [s]. `record`: see Publishing.
  void finish(const ros::Time& stamp, const CycleResult& result, double duration, double period, const Bytes* record);
  /// Time jumped back.
  void forget() { said_.clear(); }

 private:
  void explain(double now, const CycleResult& result);

  const std::string name_;
  Publishing publishing_;
  OperatorFeedback feedback_;
  Diagnostics diagnostics_;
  std::string said_;      // what explain() said last, up to its first digit; empty once the robot drives again
  double said_at_ = 0.0;  // [s]
  control::Prediction prediction_;  // of the last cycle, where somebody watched
  bool predicted_ = false;
};

}  // namespace hidwa_local_planner
