// SPDX-License-Identifier: BSD-3-Clause
#include "ros/outputs.hpp"

#include <string_view>

#include <nav_msgs/Path.h>
#include <ros/console.h>
#include <visualization_msgs/MarkerArray.h>

#include "ros/conversions.hpp"
#include "ros/evaluation_message.hpp"

namespace hidwa_local_planner {
namespace {

const control::TimedPose& timed(const control::TimedPose& pose) { return pose; }
control::TimedPose timed(const Pose2& pose) { return {pose, 0.0}; }

}  // namespace

Outputs::Outputs(const Names& names, ros::NodeHandle handle, const ros::NodeHandle& diagnostics,
                 const OperatorInput& person, const MovingObstacleInput& moving_obstacles)
    : name_(names.planner),
      frame_(names.frame),
      feedback_(handle, ros::NodeHandle(), names.frame, names.base_frame),
      diagnostics_(diagnostics, name_, person, moving_obstacles) {
  global_plan_ = handle.advertise<nav_msgs::Path>("global_plan", 1);
  local_plan_ = handle.advertise<nav_msgs::Path>("local_plan", 1);
  predicted_path_ = handle.advertise<nav_msgs::Path>("predicted_path", 1);
  cycle_ = handle.advertise<Cycle>("cycle", 50);
  evaluation_ = handle.advertise<Evaluation>("evaluation", 1);
  trajectories_ = handle.advertise<visualization_msgs::MarkerArray>("trajectories", 1);
}

bool Outputs::new_cycle_subscriber() {
  const std::uint32_t count = cycle_.getNumSubscribers();
  const bool more = count > cycle_subscribers_;
  cycle_subscribers_ = count;
  return more;
}

void Outputs::predict(const control::ControlLoop& loop, const control::Observation& observation,
                      const control::Result& result) {
  predicted_ = predicted_path_.getNumSubscribers() > 0 || feedback_.state_wanted();
  if (predicted_) prediction_.update(loop, observation, result);
}

void Outputs::tell(const LoopTime& now, const control::ControlLoop& loop, const CycleResult& result,
                   const OperatorInput::Status& status) {
  explain(now.seconds, result);
  feedback_.publish(now.stamp, loop.parameters(), result, predicted_ ? &prediction_ : nullptr, status);
  if (predicted_) publish_path(predicted_path_, now.stamp, prediction_.poses());
  if (result.decision == nullptr) return;
  publish_path(global_plan_, now.stamp, loop.situation().plan);
  publish_path(local_plan_, now.stamp, result.decision->trajectory);
  if (result.sampling.report != Report::chosen) publish_evaluation(now.stamp, loop.planner());
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

void Outputs::publish_cycle(const ros::Time& stamp, const CycleResult& result, double duration, const Bytes* record) {
  if (!cycle_wanted()) return;
  Cycle& message = cycle_message_;
  message.header.stamp = stamp;
  message.header.frame_id = frame_;
  message.outcome = static_cast<std::uint8_t>(result.outcome);
  message.outcome_name = to_string(result.outcome);
  message.command = to_message(result.command);
  message.duration = duration;
  message.state = static_cast<std::uint8_t>(result.intent.state);
  message.vx_samples = static_cast<std::uint32_t>(result.sampling.vx_samples);
  message.vth_samples = static_cast<std::uint32_t>(result.sampling.vth_samples);
  const Decision* decision = result.decision;
  message.fault = decision ? decision->problem : result.fault;
  message.reference = to_message(decision ? decision->reference : Twist2{});
  message.candidates = decision ? static_cast<std::uint32_t>(decision->candidates) : 0;
  message.legal = decision ? static_cast<std::uint32_t>(decision->legal) : 0;
  const std::size_t count = decision ? decision->rejections.size() : 0;
  message.rejection_names.resize(count);
  message.rejection_counts.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    message.rejection_names[i] = decision->rejections[i].name;
    message.rejection_counts[i] = static_cast<std::uint32_t>(decision->rejections[i].count);
  }
  message.record.clear();
  if (record != nullptr) message.record = *record;
  cycle_.publish(message);
}

// A pose's stamp is when the robot is predicted to be there, and `stamp` where nothing predicts it.
template <typename Pose>
void Outputs::publish_path(const ros::Publisher& publisher, const ros::Time& stamp, const std::vector<Pose>& poses) {
  if (publisher.getNumSubscribers() == 0) return;
  nav_msgs::Path path;
  path.header.stamp = stamp;
  path.header.frame_id = frame_;
  path.poses.resize(poses.size());
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const control::TimedPose& pose = timed(poses[i]);
    path.poses[i].header.frame_id = frame_;
    path.poses[i].header.stamp = stamp + ros::Duration(pose.time);
    path.poses[i].pose = to_message(pose.pose);
  }
  publisher.publish(path);
}

void Outputs::publish_evaluation(const ros::Time& stamp, const Planner& planner) {
  const bool scores = evaluation_.getNumSubscribers() > 0;
  const bool lines = trajectories_.getNumSubscribers() > 0;
  if (!scores && !lines) return;
  const std::vector<CandidateReport> candidates = planner.candidates();
  if (scores) evaluation_.publish(to_evaluation(candidates, planner.marked(), frame_, stamp));
  if (lines) trajectories_.publish(to_markers(candidates, planner.marked(), frame_, stamp));
}

}  // namespace hidwa_local_planner
