// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <ros/node_handle.h>
#include <ros/publisher.h>

#include "control/control_loop.hpp"
#include "control/prediction.hpp"
#include "hidwa_local_planner/Cycle.h"
#include "ros/cycle_result.hpp"
#include "ros/diagnostics.hpp"
#include "ros/loop_time.hpp"
#include "ros/operator_feedback.hpp"
#include "ros/operator_input.hpp"

namespace hidwa_local_planner {

/// What a planner tells of its cycles: the topics below its name, the log, diagnostics. From the host's control thread.
/// A message is built only if it has a subscriber.
class Outputs {
 public:
  struct Names {
    std::string planner;
    std::string frame, base_frame;  // of the costmap, of the robot
  };
  /// `handle`: the planner's namespace; `diagnostics`: a handle whose callback queue serves the diagnostics. The last
  /// two must outlive it.
  Outputs(const Names& names, ros::NodeHandle handle, const ros::NodeHandle& diagnostics, const OperatorInput& person,
          const MovingObstacleInput& moving_obstacles);

  bool cycle_wanted() const { return cycle_.getNumSubscribers() > 0; }
  /// A topic that shows all candidates has a subscriber.
  bool candidates_wanted() const {
    return cycle_wanted() || evaluation_.getNumSubscribers() > 0 || trajectories_.getNumSubscribers() > 0;
  }
  /// Somebody subscribed to the cycles since the last call.
  bool new_cycle_subscriber();
  /// Shows the mode, from whatever thread changes it.
  OperatorFeedback& feedback() { return feedback_; }
  Diagnostics& diagnostics() { return diagnostics_; }

  /// Predicts the next seconds of the cycle just run, where somebody watches; its costmap must still be valid.
  void predict(const control::ControlLoop& loop, const control::Observation& observation,
               const control::Result& result);
  /// Tells of the cycle just run: its topics and, in the log, why the robot does not just drive.
  void tell(const LoopTime& now, const control::ControlLoop& loop, const CycleResult& result,
            const OperatorInput::Status& status);
  /// Publishes the cycle, which took `duration` [s]. `record`: of the cycle; null where none was made.
  void publish_cycle(const ros::Time& stamp, const CycleResult& result, double duration, const Bytes* record);
  /// Time jumped back.
  void forget() { said_.clear(); }

 private:
  void explain(double now, const CycleResult& result);
  template <typename Pose>
  void publish_path(const ros::Publisher& publisher, const ros::Time& stamp, const std::vector<Pose>& poses);
  void publish_evaluation(const ros::Time& stamp, const Planner& planner);

  const std::string name_;
  const std::string frame_;
  ros::Publisher global_plan_, local_plan_, predicted_path_, cycle_, evaluation_, trajectories_;
  OperatorFeedback feedback_;
  Diagnostics diagnostics_;
  Cycle cycle_message_;                  // kept from cycle to cycle for its memory
  std::uint32_t cycle_subscribers_ = 0;  // as of the last look
  std::string said_;      // what explain() said last, up to its first digit; empty once the robot drives again
  double said_at_ = 0.0;  // [s]
  control::Prediction prediction_;  // of the last cycle, where somebody watched
  bool predicted_ = false;
};

}  // namespace hidwa_local_planner
