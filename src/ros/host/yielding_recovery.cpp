// SPDX-License-Identifier: BSD-3-Clause
#include "ros/host/yielding_recovery.hpp"

#include <geometry_msgs/Twist.h>
#include <ros/ros.h>
#include <topic_tools/shape_shifter.h>
#include <pluginlib/class_list_macros.hpp>

#include "core/util/words.hpp"
#include "ros/conversions.hpp"
#include "ros/guarded.hpp"
#include "ros/host/costmap_clearing.hpp"
#include "ros/host/robot_keepers.hpp"
#include "ros/loop_time.hpp"

namespace hidwa_local_planner {
namespace {

using Phase = input::Yielding::Phase;

// The parameter's value; the default, with the reason logged, where it is none from 0 to `most`.
void read(const ros::NodeHandle& handle, const char* key, double most, double& value) {
  const double wanted = handle.param(key, value);
  if (wanted >= 0.0 && wanted <= most) {
    value = wanted;
  } else {
    ROS_ERROR("%s/%s is %g: give a value from 0 to %g; %g is used", handle.getNamespace().c_str(), key, wanted, most,
              value);
  }
}

}  // namespace

void YieldingRecovery::initialize(std::string name, tf2_ros::Buffer* /*tf*/, costmap_2d::Costmap2DROS* global_costmap,
                                  costmap_2d::Costmap2DROS* local_costmap) {
  guarded("YieldingRecovery", "initialize", false, [&] {
    if (global_costmap_ != nullptr) {
      ROS_WARN("%s is initialized already; the second call is ignored", name.c_str());
    } else if (global_costmap == nullptr || local_costmap == nullptr) {
      ROS_ERROR("%s needs both costmaps", name.c_str());
    } else {
      start(name);
      global_costmap_ = global_costmap;
      local_costmap_ = local_costmap;
    }
    return true;
  });
}

void YieldingRecovery::start(const std::string& name) {
  name_ = name;
  const ros::NodeHandle handle("~/" + name);
  read(handle, "quiet_time", 10.0, settings_.yielding.quiet_time);
  read(handle, "patience", 600.0, settings_.yielding.patience);
  read(handle, "reset_distance", 1000.0, settings_.reset_distance);
  handle.getParam("layer_names", settings_.layer_names);
  velocity_ = ros::NodeHandle().advertise<geometry_msgs::Twist>("cmd_vel", 1);
  hear_requests();
}

// What is asked of move_base while it is busy: another goal, or to cancel. It looks at these itself only after the
// recovery that it runs.
void YieldingRecovery::hear_requests() {
  using Message = const topic_tools::ShapeShifter::ConstPtr&;
  const boost::function<void(Message)> ask = [this](Message) { asked_ = true; };
  ros::NodeHandle action = thread_.serve(ros::NodeHandle("move_base"));
  goal_ = action.subscribe<topic_tools::ShapeShifter>("goal", 1, ask);
  cancel_ = action.subscribe<topic_tools::ShapeShifter>("cancel", 1, ask);
  thread_.start();
}

void YieldingRecovery::runBehavior() {
  guarded("YieldingRecovery", "runBehavior", false, [&] {
    if (global_costmap_ != nullptr) {
      run();
    } else {
      ROS_ERROR("YieldingRecovery was not initialized: it clears nothing");
    }
    return true;
  });
  // However it ended, the host goes on with a robot at rest.
  if (global_costmap_ != nullptr) velocity_.publish(geometry_msgs::Twist());
}

void YieldingRecovery::run() {
  if (!yield()) return;
  clear(*global_costmap_);
  clear(*local_costmap_);
}

// False where the host was asked for something else meanwhile.
bool YieldingRecovery::yield() {
  asked_ = false;
  told_ = Phase::quiet;
  input::Yielding yielding(settings_.yielding);
  while (ros::ok()) {
    const std::optional<RestCommand> kept = RobotKeepers::of_process().keep();
    velocity_.publish(kept ? to_message(kept->command) : geometry_msgs::Twist());
    if (!kept) return true;
    const Phase phase = yielding.step(LoopTime::now().seconds, kept->stands, kept->attended);
    tell(phase);
    if (phase == Phase::quiet || phase == Phase::out_of_patience) return true;
    if (kept->stands && asked_) {
      ROS_INFO("%s: a new goal or a cancel came: nothing is cleared", name_.c_str());
      return false;
    }
    ros::Duration(kept->period).sleep();
  }
  return false;
}

void YieldingRecovery::tell(Phase phase) {
  if (phase == told_) return;
  told_ = phase;
  if (phase == Phase::yielding) {
    ROS_WARN("%s: the operator stops or steers the robot: waiting for at most %g s", name_.c_str(),
             settings_.yielding.patience);
  } else if (phase == Phase::out_of_patience) {
    ROS_WARN("%s: waited for %g s (patience): clearing now", name_.c_str(), settings_.yielding.patience);
  }
}

void YieldingRecovery::clear(costmap_2d::Costmap2DROS& costmap) const {
  std::string fault;
  const std::vector<std::string> cleared =
      clear_far_from_robot(costmap, settings_.reset_distance, settings_.layer_names, fault);
  if (cleared.empty()) {
    ROS_WARN("%s: nothing is cleared in %s: %s", name_.c_str(), costmap.getName().c_str(), fault.c_str());
  } else {
    ROS_WARN("%s: cleared %s in %s outside a square of %.2f m around the robot", name_.c_str(), joined(cleared).c_str(),
             costmap.getName().c_str(), settings_.reset_distance);
  }
}

}  // namespace hidwa_local_planner

PLUGINLIB_EXPORT_CLASS(hidwa_local_planner::YieldingRecovery, nav_core::RecoveryBehavior)
