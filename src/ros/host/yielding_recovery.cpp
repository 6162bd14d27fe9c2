// SPDX-License-Identifier: BSD-3-Clause
#include "ros/host/yielding_recovery.hpp"

#include <algorithm>

#include <costmap_2d/costmap_layer.h>
#include <costmap_2d/obstacle_layer.h>
#include <geometry_msgs/Twist.h>
#include <ros/ros.h>
#include <topic_tools/shape_shifter.h>
#include <pluginlib/class_list_macros.hpp>

#include "core/util/words.hpp"
#include "ros/conversions.hpp"
#include "ros/guarded.hpp"
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

// A layer's name is that of its costmap, a slash and its own.
std::string own_name(const costmap_2d::Layer& layer) {
  const std::string name = layer.getName();
  return name.substr(name.rfind('/') + 1);
}

// The layer where it is meant and can be cleared.
costmap_2d::CostmapLayer* meant(costmap_2d::Layer& layer, const std::vector<std::string>& names) {
  if (names.empty()) return dynamic_cast<costmap_2d::ObstacleLayer*>(&layer);
  const bool named = std::find(names.begin(), names.end(), own_name(layer)) != names.end();
  return named ? dynamic_cast<costmap_2d::CostmapLayer*>(&layer) : nullptr;
}

void clear_outside(costmap_2d::CostmapLayer& layer, const geometry_msgs::Point& centre, double side) {
  int left = 0, bottom = 0, right = 0, top = 0;
  layer.worldToMapNoBounds(centre.x - 0.5 * side, centre.y - 0.5 * side, left, bottom);
  layer.worldToMapNoBounds(centre.x + 0.5 * side, centre.y + 0.5 * side, right, top);
  layer.clearArea(left, bottom, right, top);
  layer.addExtraBounds(layer.getOriginX(), layer.getOriginY(), layer.getOriginX() + layer.getSizeInMetersX(),
                       layer.getOriginY() + layer.getSizeInMetersY());
}

// Forgets what layers marked outside the square; what sensors still see comes back with their next messages. Returns
// the names of those cleared.
std::vector<std::string> clear_layers(costmap_2d::LayeredCostmap& costmap, const std::vector<std::string>& names,
                                      const geometry_msgs::Point& centre, double side) {
  std::vector<std::string> cleared;
  // Layers are updated with this mutex held.
  const boost::unique_lock<costmap_2d::Costmap2D::mutex_t> lock(*costmap.getCostmap()->getMutex());
  for (const auto& layer : *costmap.getPlugins()) {
    costmap_2d::CostmapLayer* wanted = meant(*layer, names);
    if (wanted == nullptr) continue;
    clear_outside(*wanted, centre, side);
    cleared.push_back(own_name(*layer));
  }
  return cleared;
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
  const std::string where = costmap.getName();
  geometry_msgs::PoseStamped robot;
  if (!costmap.getRobotPose(robot)) {
    ROS_WARN("%s: nothing is cleared in %s: there is no pose of the robot in %s: check tf", name_.c_str(),
             where.c_str(), costmap.getGlobalFrameID().c_str());
    return;
  }
  const std::vector<std::string>& names = settings_.layer_names;
  const std::vector<std::string> cleared =
      clear_layers(*costmap.getLayeredCostmap(), names, robot.pose.position, settings_.reset_distance);
  if (cleared.empty()) {
    const std::string wanted = names.empty() ? "obstacle layer" : "layer " + joined(names) + " that can be cleared";
    ROS_WARN("%s: nothing is cleared in %s: it has no %s", name_.c_str(), where.c_str(), wanted.c_str());
  } else {
    ROS_WARN("%s: cleared %s in %s outside a square of %.2f m around the robot", name_.c_str(), joined(cleared).c_str(),
             where.c_str(), settings_.reset_distance);
  }
}

}  // namespace hidwa_local_planner

PLUGINLIB_EXPORT_CLASS(hidwa_local_planner::YieldingRecovery, nav_core::RecoveryBehavior)
