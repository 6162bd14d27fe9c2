// SPDX-License-Identifier: BSD-3-Clause
#include "ros/operator_feedback.hpp"

#include <algorithm>
#include <utility>

#include <visualization_msgs/MarkerArray.h>

#include "ros/conversions.hpp"
#include "ros/operator_markers.hpp"

namespace hidwa_local_planner {
namespace {

// Closer to the operator command than this is agreement: samples lie a little apart.
constexpr double kAgrees = 0.97;

}  // namespace

OperatorFeedback::OperatorFeedback(ros::NodeHandle planner, ros::NodeHandle host, std::string frame,
                                   std::string base_frame)
    : host_(std::move(host)), frame_(std::move(frame)), base_frame_(std::move(base_frame)) {
  state_ = planner.advertise<OperatorState>("operator_state", 10);
  mode_ = planner.advertise<std_msgs::String>("mode", 1, true);
  markers_ = planner.advertise<visualization_msgs::MarkerArray>("operator_markers", 1);
  rumble_message_.array.resize(1);
  rumble_message_.array[0].type = sensor_msgs::JoyFeedback::TYPE_RUMBLE;
}

void OperatorFeedback::publish(const ros::Time& stamp, const Parameters& parameters, const CycleResult& result,
                               const control::Prediction* prediction, const OperatorInput::Status& status) {
  if (parameters.rumble_topic != rumble_topic_) {
    if (rumbling_ != 0.0F) send_rumble(0.0F);  // nobody else ends it there
    rumble_topic_ = parameters.rumble_topic;
    rumble_ =
        rumble_topic_.empty() ? ros::Publisher() : host_.advertise<sensor_msgs::JoyFeedbackArray>(rumble_topic_, 1);
    rumbling_ = 0.0F;
  }
  fill(stamp, result, status);
  if (prediction != nullptr) {
    fill_next(*prediction);
    if (state_wanted()) state_.publish(message_);
  }
  if (markers_.getNumSubscribers() > 0) markers_.publish(to_operator_markers(message_, base_frame_));
  if (!rumble_topic_.empty()) rumble();
}

void OperatorFeedback::show_mode(OperatorMode mode) {
  std_msgs::String message;
  message.data = name_of(mode);
  if (message.data == shown_mode_) return;
  shown_mode_ = message.data;
  mode_.publish(message);
}

void OperatorFeedback::fill(const ros::Time& stamp, const CycleResult& result, const OperatorInput::Status& status) {
  const OperatorIntent& intent = result.intent;
  OperatorState& message = message_;
  message.header.stamp = stamp;
  message.header.frame_id = frame_;
  const auto mode = static_cast<std::uint8_t>(status.mode);
  if (message.mode != mode || message.mode_name.empty()) message.mode_name = name_of(status.mode);
  message.mode = mode;
  message.state = static_cast<std::uint8_t>(intent.state);
  message.state_name = to_string(intent.state);
  message.without_goal = result.goalless;
  message.active = intent.influence != Influence::none;
  message.wanted = to_message(intent.u_h);
  message.command = to_message(result.command);
  message.agreement = result.decision ? result.decision->agreement : message.active ? 0.0 : 1.0;
  if (result.decision) {  // no common value of the three: a copy would be memory anew in every cycle
    message.refused_by = result.decision->operator_rejected_by;
  } else if (message.active) {
    message.refused_by = result.fault;
  } else {
    message.refused_by.clear();
  }
  message.input_age = status.age;
  message.dropped = status.dropped;
}

void OperatorFeedback::fill_next(const control::Prediction& prediction) {
  message_.next = static_cast<std::uint8_t>(prediction.next());
  message_.next_name = control::to_string(prediction.next());
  message_.next_reason = prediction.reason();
}

// Sent while it rumbles, since motors stop by themselves, and once when it ends.
void OperatorFeedback::rumble() {
  const bool stopped = message_.state == OperatorState::STOPPED || message_.state == OperatorState::LOST;
  const float intensity = rumble_intensity(message_.active != 0 && !stopped, message_.agreement);
  if (intensity == 0.0F && rumbling_ == 0.0F) return;
  rumbling_ = intensity;
  send_rumble(intensity);
}

void OperatorFeedback::send_rumble(float intensity) {
  if (rumble_.getNumSubscribers() == 0) return;
  rumble_message_.array[0].intensity = intensity;
  rumble_.publish(rumble_message_);
}

std::string name_of(OperatorMode mode) {
  Parameters p;
  p.mode = mode;
  return std::get<std::string>(get_parameter(p, "mode"));
}

float rumble_intensity(bool active, double agreement) {
  if (!active || agreement >= kAgrees) return 0.0F;
  return static_cast<float>(std::clamp(1.0 - agreement, 0.0, 1.0));
}

}  // namespace hidwa_local_planner
