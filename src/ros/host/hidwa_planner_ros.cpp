// SPDX-License-Identifier: BSD-3-Clause
#include "ros/host/hidwa_planner_ros.hpp"

#include <pluginlib/class_list_macros.hpp>

#include "input/yielding.hpp"
#include "ros/conversions.hpp"
#include "ros/guarded.hpp"
#include "ros/host/drive_without_goal.hpp"
#include "ros/planner_node.hpp"

namespace hidwa_local_planner {
namespace {

template <typename Call>
bool succeeds(const char* what, Call call) {
  return guarded("HIDWAPlannerROS", what, false, call);
}

FramedGoal to_goal(const geometry_msgs::PoseStamped& pose) {
  return {plain_frame(pose.header.frame_id), to_planned_pose(pose.pose)};
}

}  // namespace

HIDWAPlannerROS::HIDWAPlannerROS() = default;
HIDWAPlannerROS::~HIDWAPlannerROS() {
  if (thread_) thread_->stop();
}

void HIDWAPlannerROS::initialize(std::string name, tf2_ros::Buffer* tf, costmap_2d::Costmap2DROS* costmap_ros) {
  succeeds("initialize", [&] {
    start_planner(planner_, name, tf, costmap_ros);
    if (!planner_ || entry_) return true;
    if (!thread_) hear_goals();
    drive_ = std::make_unique<DriveWithoutGoal>(*planner_, name);
    entry_ = std::make_unique<RobotKeepers::Entry>(RobotKeepers::of_process(), [this] { return keep(); });
    return true;
  });
}

// Other hosts may follow a plan to another goal than the last one planned for, as the clients of Move Base Flex: only
// move_base is listened to.
void HIDWAPlannerROS::hear_goals() {
  constexpr unsigned kQueue = 10;  // goals that may come between two looks
  ros::NodeHandle host("~");
  if (host.hasParam("controllers")) return;  // Move Base Flex
  thread_ = std::make_unique<CallbackThread>();
  goal_ = thread_->serve(host).subscribe("current_goal", kQueue, &HIDWAPlannerROS::hear, this);
  thread_->start();
}

void HIDWAPlannerROS::hear(const geometry_msgs::PoseStamped& goal) {
  goals_.take(to_goal(goal), ros::Time::now().toSec());
}

bool HIDWAPlannerROS::setPlan(const std::vector<geometry_msgs::PoseStamped>& plan) {
  return succeeds("setPlan", [&] {
    if (!plan.empty()) end_ = to_goal(plan.back());
    if (planner_) planner_->set_plan(plan);
    return planner_ != nullptr;
  });
}

bool HIDWAPlannerROS::computeVelocityCommands(geometry_msgs::Twist& cmd_vel) {
  cmd_vel = geometry_msgs::Twist();
  return succeeds("computeVelocityCommands", [&] {
    if (!planner_) {
      ROS_ERROR_THROTTLE(1.0, "HIDWAPlannerROS was not initialized: the robot does not drive");
      return false;
    }
    return cycle(cmd_vel);
  });
}

// A plan to a goal that the host no longer pursues is not followed, unless it leads near to the present one; at rest
// the cycle fails, so that it plans anew. A plan may also come before the topic brings its goal: that takes
// milliseconds.
bool HIDWAPlannerROS::cycle(geometry_msgs::Twist& command) {
  constexpr int kLate = 2;  // cycles in which a goal is still on its way
  const bool outdated = plan_is_outdated() && !goals_.leads_on(end_, ros::Time::now().toSec());
  cycles_outdated_ = outdated ? cycles_outdated_ + 1 : 0;
  const bool over = cycles_outdated_ > kLate;
  const CycleResult result = planner_->cycle(over);
  command = to_message(result.command);
  if (!over) return result.outcome != Outcome::fail;
  ROS_WARN_THROTTLE(1.0,
                    "the plan leads to an earlier goal, (%.2f, %.2f) in %s; no plan to the present goal has come yet",
                    end_.pose.x, end_.pose.y, end_.frame.c_str());
  return !(result.command == Twist2{});
}

bool HIDWAPlannerROS::plan_is_outdated() const { return goals_.leads_to_earlier_goal(end_); }

RestCommand HIDWAPlannerROS::keep() {
  const CycleResult result = planner_->cycle(true);
  const OperatorInput::Status status = planner_->operator_status();
  return {result.command, planner_->stands(), input::attends(status.state, status.manual), planner_->period()};
}

bool HIDWAPlannerROS::isGoalReached() {
  return succeeds("isGoalReached", [&] { return planner_ && !plan_is_outdated() && planner_->goal_reached(); });
}

}  // namespace hidwa_local_planner

PLUGINLIB_EXPORT_CLASS(hidwa_local_planner::HIDWAPlannerROS, nav_core::BaseLocalPlanner)
