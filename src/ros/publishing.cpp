// SPDX-License-Identifier: BSD-3-Clause
#include "ros/publishing.hpp"

#include <utility>

#include <visualization_msgs/MarkerArray.h>

#include "ros/conversions.hpp"
#include "ros/evaluation_message.hpp"

namespace hidwa_local_planner {

Publishing::Publishing(ros::NodeHandle handle, std::string frame) : frame_(std::move(frame)) {
  global_plan_ = handle.advertise<nav_msgs::Path>("global_plan", 1);
  local_plan_ = handle.advertise<nav_msgs::Path>("local_plan", 1);
  predicted_path_ = handle.advertise<nav_msgs::Path>("predicted_path", 1);
  cycle_ = handle.advertise<Cycle>("cycle", 50);
  evaluation_ = handle.advertise<Evaluation>("evaluation", 1);
  trajectories_ = handle.advertise<visualization_msgs::MarkerArray>("trajectories", 1);
}

bool Publishing::new_cycle_subscriber() {
  const std::uint32_t count = cycle_.getNumSubscribers();
  const bool more = count > cycle_subscribers_;
  cycle_subscribers_ = count;
  return more;
}

void Publishing::publish_cycle(const ros::Time& stamp, const CycleResult& result, OperatorStateId state,
                               double duration, const Bytes* record) {
  if (cycle_.getNumSubscribers() == 0) return;
  Cycle& message = cycle_message_;
  message.header.stamp = stamp;
  message.header.frame_id = frame_;
  message.outcome = static_cast<std::uint8_t>(result.outcome);
  message.outcome_name = to_string(result.outcome);
  message.command = to_message(result.command);
  message.duration = duration;
  message.state = static_cast<std::uint8_t>(state);
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

void Publishing::publish_paths(const ros::Time& stamp, const std::vector<Pose2>& window,
                               const std::vector<Pose2>& trajectory) {
  publish_path(global_plan_, stamp, window);
  publish_path(local_plan_, stamp, trajectory);
}

void Publishing::publish_path(const ros::Publisher& publisher, const ros::Time& stamp,
                              const std::vector<Pose2>& poses) {
  if (publisher.getNumSubscribers() == 0) return;
  nav_msgs::Path path;
  path.header.stamp = stamp;
  path.header.frame_id = frame_;
  path.poses.resize(poses.size());
  for (std::size_t i = 0; i < poses.size(); ++i) {
    path.poses[i].header = path.header;
    path.poses[i].pose = to_message(poses[i]);
  }
  publisher.publish(path);
}

void Publishing::publish_prediction(const ros::Time& stamp, const std::vector<control::TimedPose>& poses) {
  if (!prediction_wanted()) return;
  nav_msgs::Path path;
  path.header.stamp = stamp;
  path.header.frame_id = frame_;
  path.poses.resize(poses.size());
  for (std::size_t i = 0; i < poses.size(); ++i) {
    path.poses[i].header.frame_id = frame_;
    path.poses[i].header.stamp = stamp + ros::Duration(poses[i].time);
    path.poses[i].pose = to_message(poses[i].pose);
  }
  predicted_path_.publish(path);
}

void Publishing::publish_evaluation(const ros::Time& stamp, const Planner& planner) {
  const bool scores = evaluation_.getNumSubscribers() > 0;
  const bool lines = trajectories_.getNumSubscribers() > 0;
  if (!scores && !lines) return;
  const std::vector<CandidateReport> candidates = planner.candidates();
  if (scores) evaluation_.publish(to_evaluation(candidates, planner.marked(), frame_, stamp));
  if (lines) trajectories_.publish(to_markers(candidates, planner.marked(), frame_, stamp));
}

}  // namespace hidwa_local_planner
