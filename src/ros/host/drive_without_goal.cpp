// SPDX-License-Identifier: BSD-3-Clause
#include "ros/host/drive_without_goal.hpp"

#include <memory>
#include <mutex>
#include <set>
#include <utility>

#include <geometry_msgs/Twist.h>
#include <ros/ros.h>

#include "control/pause.hpp"
#include "ros/conversions.hpp"
#include "ros/guarded.hpp"

namespace hidwa_local_planner {
namespace {

// The topics that a planner of this process drives on now: of two planners for one robot one drives.
class DrivenTopics {
 public:
  static DrivenTopics& of_process() {
    static DrivenTopics topics;
    return topics;
  }
  bool take(const std::string& topic) {
    const std::lock_guard<std::mutex> lock(mutex_);
    return topics_.insert(topic).second;
  }
  void give(const std::string& topic) {
    const std::lock_guard<std::mutex> lock(mutex_);
    topics_.erase(topic);
  }

 private:
  std::mutex mutex_;
  std::set<std::string> topics_;
};

}  // namespace

DriveWithoutGoal::DriveWithoutGoal(PlannerNode& planner, const std::string& name)
    : planner_(planner), name_(name), period_(planner.period()) {
  timer_ = ros::NodeHandle().createTimer(ros::Duration(period_), [this](const ros::TimerEvent&) {
    guarded(name_.c_str(), "drive_without_goal", false, [this] {
      tick();
      return true;
    });
  });
}

DriveWithoutGoal::~DriveWithoutGoal() {
  timer_.stop();
  end();
}

bool DriveWithoutGoal::host_is_busy() const {
  const double now = ros::SteadyTime::now().toSec();
  return actions_.any_goal(now) || !is_pause(now - planner_.host_called(), period_);
}

void DriveWithoutGoal::tick() {
  const std::shared_ptr<const ParameterSet> newest = planner_.newest_parameters();
  const Parameters& wanted = newest->parameters;
  if (!ros::ok()) return;
  const bool goalless = (wanted.drive_without_goal || driving_) && !host_is_busy();
  planner_.set_goalless(goalless);
  if (!goalless) return end();
  planner_.take_parameters();
  if (!driving_ && !planner_.operator_status().steers) return;
  if (!driving_ && (!costmap_runs() || !begin(wanted.drive_topic))) return;
  drive(!wanted.drive_without_goal);
}

bool DriveWithoutGoal::costmap_runs() {
  bool stops = false;
  ros::NodeHandle("~").getParamCached("shutdown_costmaps", stops);
  if (stops) {
    ROS_WARN_ONCE(
        "%s: drive_without_goal drives nothing: with shutdown_costmaps the host has no local costmap while "
        "it has no goal",
        name_.c_str());
  }
  return !stops;
}

bool DriveWithoutGoal::begin(const std::string& topic) {
  ros::NodeHandle node;
  const std::string resolved = node.resolveName(topic);
  if (resolved != topic_) {
    commands_ = node.advertise<geometry_msgs::Twist>(topic, 1);
    topic_ = resolved;
  }
  const double period = planner_.period();
  if (period != period_) timer_.setPeriod(ros::Duration(period));
  period_ = period;
  return driving_ = DrivenTopics::of_process().take(topic_);
}

void DriveWithoutGoal::end() {
  if (std::exchange(driving_, false)) DrivenTopics::of_process().give(topic_);
}

void DriveWithoutGoal::drive(bool stop) {
  const CycleResult result = planner_.cycle_without_goal(stop);
  if (host_is_busy()) return end();
  const bool steered = !stop && result.intent.state == OperatorStateId::manual;
  commands_.publish(to_message(result.command));
  if (!steered && result.command == Twist2{}) end();
}

}  // namespace hidwa_local_planner
