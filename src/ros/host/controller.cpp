// SPDX-License-Identifier: BSD-3-Clause
#include "ros/host/controller.hpp"

#include <ros/time.h>

#include "ros/conversions.hpp"
#include "ros/guarded.hpp"
#include "ros/host/drive_without_goal.hpp"
#include "ros/planner_node.hpp"

namespace hidwa_local_planner {
namespace {

constexpr const char* kName = "HIDWAController";

double clock_time() { return ros::SteadyTime::now().toSec(); }

ControllerOutcome outcome_of(Missing missing) {
  switch (missing) {
    case Missing::parameters:
    case Missing::footprint:
      return ControllerOutcome::not_initialized;
    case Missing::plan:
      return ControllerOutcome::invalid_path;
    case Missing::costmap:
      return ControllerOutcome::map_error;
    case Missing::transform:
      return ControllerOutcome::tf_error;
    case Missing::odometry:
    case Missing::nothing:
      break;
  }
  return ControllerOutcome::no_valid_command;
}

ControllerOutcome outcome_of(const Decision& decision) {
  switch (decision.problem_kind) {
    case Problem::off_map:
      return ControllerOutcome::missed_path;
    case Problem::stuck:
      return ControllerOutcome::blocked_path;
    case Problem::input:
      return ControllerOutcome::internal_error;
    case Problem::rejected:
    case Problem::none:
      break;
  }
  return decision.escaping ? ControllerOutcome::collision : ControllerOutcome::no_valid_command;
}

}  // namespace

ControllerOutcome outcome_of(const CycleResult& result) {
  if (result.outcome != Outcome::fail) return ControllerOutcome::success;
  return result.decision ? outcome_of(*result.decision) : outcome_of(result.missing);
}

Controller::Controller() = default;
Controller::~Controller() = default;

void Controller::initialize(const std::string& name, const tf2_ros::Buffer* tf, costmap_2d::Costmap2DROS* costmap) {
  guarded(kName, "initialize", false, [&] {
    start_planner(planner_, name, tf, costmap);
    if (planner_ && !drive_) drive_ = std::make_unique<DriveWithoutGoal>(*planner_, name);
    return true;
  });
}

bool Controller::set_plan(const std::vector<geometry_msgs::PoseStamped>& plan) {
  return guarded(kName, "setPlan", false, [&] {
    cancel_.plan_arrives(clock_time());
    if (planner_) planner_->set_plan(plan);
    return planner_ != nullptr;
  });
}

ControllerOutcome Controller::compute(geometry_msgs::Twist& command, std::string& message) {
  command = geometry_msgs::Twist();
  message.clear();
  const ControllerOutcome outcome = guarded(kName, "computeVelocityCommands", ControllerOutcome::internal_error,
                                            [&] { return cycle(command, message); });
  if (outcome == ControllerOutcome::internal_error && message.empty()) message = "an internal error: see the log";
  return outcome;
}

ControllerOutcome Controller::cycle(geometry_msgs::Twist& command, std::string& message) {
  const bool cancelled = cancel_.pending(clock_time());
  if (!planner_) {
    message = "the controller was not initialized: the robot does not drive";
    return ControllerOutcome::not_initialized;
  }
  // The host does not send the command of `canceled`: zero was sent in the cycle before.
  const bool stood = planner_->stands();
  const CycleResult result = planner_->cycle(cancelled);
  command = to_message(result.command);
  message = in_words(result);
  if (!cancelled) return outcome_of(result);
  if (stood && result.outcome == Outcome::hold) {
    cancel_.met();
    message = "canceled: the robot stands";
    return ControllerOutcome::canceled;
  }
  if (message.empty()) message = "canceled: braking";
  return outcome_of(result);
}

bool Controller::goal_reached(double xy, double yaw) {
  return guarded(kName, "isGoalReached", false, [&] {
    if (!planner_) return false;
    planner_->set_goal_tolerances(xy, yaw);
    const bool reached = planner_->goal_reached(false);
    if (reached) cancel_.met();
    return reached;
  });
}

void Controller::cancel() { cancel_.request(clock_time()); }

}  // namespace hidwa_local_planner
