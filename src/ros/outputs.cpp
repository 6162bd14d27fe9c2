// SPDX-License-Identifier: BSD-3-Clause
#include "ros/outputs.hpp"

#include <string_view>

#include <ros/console.h>

namespace hidwa_local_planner {

Outputs::Outputs(const Names& names, const ros::NodeHandle& handle, const ros::NodeHandle& diagnostics,
                 const OperatorInput& person, const MovingObstacleInput& moving_obstacles)
    : name_(names.planner),
      publishing_(handle, names.frame),
      feedback_(handle, ros::NodeHandle(), names.frame, names.base_frame),
      diagnostics_(diagnostics, name_, person, moving_obstacles) {}

void Outputs::predict(const control::ControlLoop& loop, const control::Observation& observation,
                      const control::Result& result) {
  predicted_ = publishing_.prediction_wanted() || feedback_.state_wanted();
  if (predicted_) prediction_.update(loop, observation, result);
}

void Outputs::tell(const LoopTime& now, const control::ControlLoop& loop, const CycleResult& result,
                   const OperatorInput::Status& status) {
  explain(now.seconds, result);
  feedback_.publish(now.stamp, loop.parameters(), result, predicted_ ? &prediction_ : nullptr, status);
  if (predicted_) publishing_.publish_prediction(now.stamp, prediction_.poses());
  if (result.decision == nullptr) return;
  publishing_.publish_paths(now.stamp, loop.situation().plan, result.decision->trajectory);
  if (result.sampling.report != Report::chosen) publishing_.publish_evaluation(now.stamp, loop.planner());
}

void Outputs::finish(const ros::Time& stamp, const CycleResult& result, double duration, double period,
                     const Bytes* record) {
  publishing_.publish_cycle(stamp, result, result.intent.state, duration, record);
  diagnostics_.add(duration, period);
}

// What lasts for many cycles is said at once when it is new, then once a second. Figures make no difference.
void Outputs::explain(double now, const CycleResult& result) {
  const bool rejected = result.decision && (result.outcome == Outcome::brake || result.outcome == Outcome::fail);
  const bool escaping = result.decision && !rejected && result.decision->escaping;
  const std::string_view what = rejected   ? std::string_view(result.decision->problem)
                                : escaping ? kEscapes
                                           : std::string_view(result.fault);
  if (what.empty()) {
    if (!said_.empty()) ROS_INFO("%s: driving again", name_.c_str());
    said_.clear();
    return;
  }
  const std::string_view kind = what.substr(0, what.find_first_of("0123456789"));
  if (kind == said_ && now - said_at_ < 1.0) return;
  said_ = kind;
  said_at_ = now;
  const std::string message = rejected ? rejections_in_words(*result.decision) : std::string(what);
  const char* consequence = result.outcome == Outcome::fail    ? "; the robot stands, the host replans or recovers"
                            : result.outcome == Outcome::brake ? "; braking"
                                                               : "";
  ROS_WARN("%s: %s%s", name_.c_str(), message.c_str(), consequence);
}

}  // namespace hidwa_local_planner
