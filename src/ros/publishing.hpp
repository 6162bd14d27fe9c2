// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <nav_msgs/Path.h>
#include <ros/node_handle.h>
#include <ros/publisher.h>

#include "control/prediction.hpp"
#include "hidwa_local_planner/Cycle.h"
#include "hidwa_local_planner/core/operator_intent.hpp"
#include "hidwa_local_planner/core/planner.hpp"
#include "hidwa_local_planner/core/util/archive.hpp"
#include "ros/cycle_result.hpp"

namespace hidwa_local_planner {

/// The topics below the planner's name, except those for the operator. A message is built only if it has a subscriber.
class Publishing {
 public:
  /// `frame`: the costmap's.
  Publishing(ros::NodeHandle handle, std::string frame);

  bool cycle_wanted() const { return cycle_.getNumSubscribers() > 0; }
  /// A topic that shows all candidates has a subscriber.
  bool candidates_wanted() const {
    return cycle_wanted() || evaluation_.getNumSubscribers() > 0 || trajectories_.getNumSubscribers() > 0;
  }
  bool prediction_wanted() const { return predicted_path_.getNumSubscribers() > 0; }
  /// Somebody subscribed to the cycles since the last call.
  bool new_cycle_subscriber();
  /// `record`: of the cycle; null where none was made. `duration` [s].
  void publish_cycle(const ros::Time& stamp, const CycleResult& result, OperatorStateId state, double duration,
                     const Bytes* record);
  void publish_paths(const ros::Time& stamp, const std::vector<Pose2>& window, const std::vector<Pose2>& trajectory);
  /// Each pose's stamp is when the robot is predicted to be there.
  void publish_prediction(const ros::Time& stamp, const std::vector<control::TimedPose>& poses);
  void publish_evaluation(const ros::Time& stamp, const Planner& planner);

 private:
  void publish_path(const ros::Publisher& publisher, const ros::Time& stamp, const std::vector<Pose2>& poses);

  std::string frame_;
  ros::Publisher global_plan_, local_plan_, predicted_path_, cycle_, evaluation_, trajectories_;
  // Kept from cycle to cycle for their memory.
  Cycle cycle_message_;
  std::uint32_t cycle_subscribers_ = 0;  // as of the last look
};

}  // namespace hidwa_local_planner
