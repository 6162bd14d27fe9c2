// SPDX-License-Identifier: BSD-3-Clause
// The action server's thread: one goal from start to end.
#include <move_base/move_base.h>
#include <move_base_msgs/RecoveryStatus.h>
#include <tf2/LinearMath/Quaternion.h>
#include <tf2_geometry_msgs/tf2_geometry_msgs.h>

#include <cmath>
#include <cstdint>

namespace move_base {
namespace {

typedef Recoveries::Trigger Trigger;

// A rotation that leaves the z axis upright: finite, not of zero length.
bool isPlanarRotation(const geometry_msgs::Quaternion& q) {
  if (!std::isfinite(q.x) || !std::isfinite(q.y) || !std::isfinite(q.z) || !std::isfinite(q.w)) return false;
  tf2::Quaternion rotation(q.x, q.y, q.z, q.w);
  if (rotation.length2() < 1e-6) return false;
  rotation.normalize();
  const tf2::Vector3 up = tf2::quatRotate(rotation, tf2::Vector3(0.0, 0.0, 1.0));
  return std::abs(up.z() - 1.0) <= 1e-3;
}

std::string reason(Trigger trigger) {
  switch (trigger) {
    case Trigger::kPlanning:
      return "No global plan was found.";
    case Trigger::kControlling:
      return "The local planner found no valid command.";
    case Trigger::kOscillation:
      break;
  }
  return "The robot is oscillating.";
}

double planarDistance(const geometry_msgs::Point& a, const geometry_msgs::Point& b) {
  return std::hypot(a.x - b.x, a.y - b.y);
}

}  // namespace

void MoveBase::execute(const move_base_msgs::MoveBaseGoalConstPtr& goal) {
  if (shutdown_costmaps_) {
    global_costmap_->start();
    local_costmap_->start();
  }
  if (!adopt(goal->target_pose)) return;
  publishZero();
  ros::Rate rate(controller_frequency_);
  while (nh_.ok()) {
    if (server_->isPreemptRequested() && handlePreempt()) return;
    if (cycle()) return;
    rate.sleep();
    if (state_ == State::kControlling && rate.cycleTime() > ros::Duration(1.0 / controller_frequency_)) {
      ROS_WARN_THROTTLE(1.0, "The control cycle took %.4f s, longer than its period of %.4f s (controller_frequency).",
                        rate.cycleTime().toSec(), 1.0 / controller_frequency_);
    }
  }
  planning_->halt();
  server_->setAborted(move_base_msgs::MoveBaseResult(), "The node was shut down.");
}

// Takes a goal in hand; false, with the goal aborted, when it is malformed.
bool MoveBase::adopt(const geometry_msgs::PoseStamped& goal) {
  if (!isPlanarRotation(goal.pose.orientation)) {
    ROS_ERROR("The goal's orientation is no rotation about z; the goal is aborted.");
    server_->setAborted(move_base_msgs::MoveBaseResult(), "The goal's orientation is no rotation about z");
    return false;
  }
  goal_ = toGlobalFrame(goal);
  state_ = State::kPlanning;
  recoveries_.reset();
  last_valid_control_ = last_oscillation_reset_ = ros::Time::now();
  planning_->begin(goal_);
  current_goal_publisher_.publish(goal_);
  return true;
}

// A newer goal takes the place of the one in hand (false: go on); a cancelled one ends (true).
bool MoveBase::handlePreempt() {
  if (server_->isNewGoalAvailable()) return !adopt(server_->acceptNewGoal()->target_pose);
  rest();
  server_->setPreempted();
  return true;
}

// One control cycle; true when the goal ended.
bool MoveBase::cycle() {
  geometry_msgs::PoseStamped pose;
  if (robotPose(*global_costmap_, pose)) {
    move_base_msgs::MoveBaseFeedback feedback;
    feedback.base_position = pose;
    server_->publishFeedback(feedback);
    if (planarDistance(pose.pose.position, oscillation_position_) >= oscillation_distance_) {
      last_oscillation_reset_ = ros::Time::now();
      oscillation_position_ = pose.pose.position;
      recoveries_.helped(Trigger::kOscillation);
    }
  }
  if (!local_costmap_->isCurrent()) {
    ROS_WARN_THROTTLE(1.0, "The local costmap's sensor data is too old; the robot is held.");
    publishZero();
    return false;
  }
  if (!takeNewPlan()) return abort("The local planner refused the global plan.");
  if (state_ == State::kControlling) return control();
  if (state_ == State::kClearing) return clear();
  if (planning_->gaveUp()) {
    clearFor(Trigger::kPlanning);
    return false;
  }
  planning_->keepPlanning();
  return false;
}

// Hands a new plan to the local planner; false when it refuses.
bool MoveBase::takeNewPlan() {
  std::vector<geometry_msgs::PoseStamped> plan;
  if (!planning_->takePlan(plan)) return true;
  if (!local_planner_->setPlan(plan)) return false;
  state_ = State::kControlling;
  recoveries_.helped(Trigger::kPlanning);
  return true;
}

bool MoveBase::control() {
  if (local_planner_->isGoalReached()) {
    rest();
    server_->setSucceeded(move_base_msgs::MoveBaseResult(), "Goal reached.");
    return true;
  }
  if (oscillates()) clearFor(Trigger::kOscillation);
  geometry_msgs::Twist command;
  if (compute(command)) {
    last_valid_control_ = ros::Time::now();
    velocity_publisher_.publish(command);
    recoveries_.helped(Trigger::kControlling);
  } else if (ros::Time::now() > last_valid_control_ + ros::Duration(controller_patience_)) {
    clearFor(Trigger::kControlling);
  } else {
    state_ = State::kPlanning;
    publishZero();
    planning_->replan();
  }
  return false;
}

void MoveBase::clearFor(Trigger trigger) {
  publishZero();
  state_ = State::kClearing;
  recoveries_.askedBy(trigger);
}

// Tries the next recovery behaviour, then plans again; true, with the goal aborted, when none is left.
bool MoveBase::clear() {
  if (!recovery_behavior_enabled_ || !recoveries_.left()) return abort(reason(recoveries_.trigger()));
  move_base_msgs::RecoveryStatus status;
  robotPose(*global_costmap_, status.pose_stamped);
  status.current_recovery_number = static_cast<std::uint16_t>(recoveries_.nextNumber());
  status.total_number_of_recoveries = static_cast<std::uint16_t>(recoveries_.size());
  status.recovery_behavior_name = recoveries_.nextName();
  recovery_status_publisher_.publish(status);
  recoveries_.runNext();
  last_oscillation_reset_ = ros::Time::now();
  state_ = State::kPlanning;
  planning_->replan();
  return false;
}

bool MoveBase::compute(geometry_msgs::Twist& command) {
  const boost::unique_lock<costmap_2d::Costmap2D::mutex_t> lock(*local_costmap_->getCostmap()->getMutex());
  return local_planner_->computeVelocityCommands(command);
}

bool MoveBase::oscillates() {
  return oscillation_timeout_ > 0.0 && last_oscillation_reset_ + ros::Duration(oscillation_timeout_) < ros::Time::now();
}

bool MoveBase::abort(const std::string& reason) {
  ROS_ERROR("The goal is aborted: %s", reason.c_str());
  rest();
  server_->setAborted(move_base_msgs::MoveBaseResult(), reason);
  return true;
}

void MoveBase::rest() {
  planning_->halt();
  state_ = State::kPlanning;
  recoveries_.reset();
  publishZero();
  if (shutdown_costmaps_) {
    global_costmap_->stop();
    local_costmap_->stop();
  }
}

void MoveBase::publishZero() { velocity_publisher_.publish(geometry_msgs::Twist()); }

bool MoveBase::planFromRobot(const geometry_msgs::PoseStamped& goal, std::vector<geometry_msgs::PoseStamped>& plan) {
  const boost::unique_lock<costmap_2d::Costmap2D::mutex_t> lock(*global_costmap_->getCostmap()->getMutex());
  geometry_msgs::PoseStamped start;
  return robotPose(*global_costmap_, start) && global_planner_.makePlan(start, goal, plan) && !plan.empty();
}

bool MoveBase::robotPose(const costmap_2d::Costmap2DROS& costmap, geometry_msgs::PoseStamped& pose) const {
  return costmap.getRobotPose(pose);
}

geometry_msgs::PoseStamped MoveBase::toGlobalFrame(const geometry_msgs::PoseStamped& goal) const {
  geometry_msgs::PoseStamped latest = goal;
  latest.header.stamp = ros::Time(0);
  try {
    return tf_.transform(latest, global_costmap_->getGlobalFrameID());
  } catch (const tf2::TransformException& fault) {
    ROS_WARN("The goal's frame \"%s\" cannot be brought into \"%s\": %s", goal.header.frame_id.c_str(),
             global_costmap_->getGlobalFrameID().c_str(), fault.what());
    return goal;
  }
}

}  // namespace move_base
