// SPDX-License-Identifier: BSD-3-Clause
// A local planner that reports each call of its host on ~/<name>/event and answers as ~/<name>/answer tells
// it, and a recovery behaviour that reports its calls there too.
#include <costmap_2d/costmap_2d_ros.h>
#include <nav_core/base_local_planner.h>
#include <nav_core/recovery_behavior.h>
#include <pthread.h>
#include <ros/ros.h>
#include <std_msgs/String.h>
#include <sys/syscall.h>
#include <unistd.h>
#include <pluginlib/class_list_macros.hpp>

#include <boost/thread/recursive_mutex.hpp>
#include <mutex>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

namespace hidwa_probe_planner {

class ProbePlannerROS;
ProbePlannerROS* the_planner = nullptr;  // of this process: the host loads the library once

class ProbePlannerROS : public nav_core::BaseLocalPlanner {
 public:
  ~ProbePlannerROS() override { the_planner = nullptr; }

  void initialize(std::string name, tf2_ros::Buffer* /*tf*/, costmap_2d::Costmap2DROS* costmap_ros) override {
    the_planner = this;
    costmap_ros_ = costmap_ros;
    main_thread_ = std::this_thread::get_id();
    ros::NodeHandle nh("~/" + name);
    event_publisher_ = nh.advertise<std_msgs::String>("event", 0, true);
    answer_subscriber_ = nh.subscribe("answer", 0, &ProbePlannerROS::onAnswer, this);
    report("initialize", "name " + name);
  }

  bool setPlan(const std::vector<geometry_msgs::PoseStamped>& plan) override {
    const bool accept = answer() != "refuse_plan";
    std::ostringstream goal;
    if (plan.empty()) {
      goal << "empty";
    } else {
      const geometry_msgs::Point& end = plan.back().pose.position;
      goal << "to (" << end.x << ", " << end.y << ") in " << plan.back().header.frame_id;
    }
    report("setPlan", goal.str() + (accept ? " -> true" : " -> false"));
    return accept;
  }

  bool computeVelocityCommands(geometry_msgs::Twist& command) override {
    const std::string how = answer();
    command = geometry_msgs::Twist();
    if (how == "fail" || how == "fail_once") {
      if (how == "fail_once") setAnswer("drive");
      report("computeVelocityCommands", "-> false");
      return false;
    }
    command.linear.x = how == "hold" ? 0.0 : 0.1;  // [m/s]
    report("computeVelocityCommands", how == "hold" ? "-> true, zero" : "-> true, moving");
    return true;
  }

  bool isGoalReached() override {
    const bool reached = answer() == "reached";
    report("isGoalReached", reached ? "-> true" : "-> false");
    return reached;
  }

  void report(const std::string& call, const std::string& detail) {
    publish(call + " [" + threadName() + " thread, costmap mutex " + (callerHoldsMutex() ? "held" : "not held") + "] " +
            detail);
  }

 private:
  void onAnswer(const std_msgs::String& message) {
    setAnswer(message.data);
    publish("callback [" + threadName() + " thread]");
  }

  std::string answer() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return answer_;
  }

  void setAnswer(const std::string& how) {
    const std::lock_guard<std::mutex> lock(mutex_);
    answer_ = how;
  }

  // Threads are named by what they were first seen doing.
  std::string threadName() {
    const auto self = std::this_thread::get_id();
    const std::lock_guard<std::mutex> lock(mutex_);
    if (self == main_thread_) return "main";
    if (control_thread_ == std::thread::id()) control_thread_ = self;
    return self == control_thread_ ? "control" : "another";
  }

  // Whether this thread, in which the host calls, owns the local costmap's mutex. That another thread cannot
  // lock it would not tell: the costmap's own update holds it now and then. glibc keeps the owner's thread id
  // in the mutex.
  bool callerHoldsMutex() const {
    const pthread_mutex_t* mutex = costmap_ros_->getCostmap()->getMutex()->native_handle();
    return mutex->__data.__owner == static_cast<int>(syscall(SYS_gettid));
  }

  void publish(const std::string& text) {
    std_msgs::String event;
    event.data = text;
    event_publisher_.publish(event);
  }

  costmap_2d::Costmap2DROS* costmap_ros_ = nullptr;
  ros::Publisher event_publisher_;
  ros::Subscriber answer_subscriber_;
  mutable std::mutex mutex_;
  std::string answer_ = "drive";
  std::thread::id main_thread_;
  std::thread::id control_thread_;
};

class ProbeRecovery : public nav_core::RecoveryBehavior {
 public:
  void initialize(std::string name, tf2_ros::Buffer* /*tf*/, costmap_2d::Costmap2DROS* global_costmap,
                  costmap_2d::Costmap2DROS* local_costmap) override {
    name_ = name;
    report("initialize",
           "recovery " + name + " with " + global_costmap->getName() + " and " + local_costmap->getName());
  }
  void runBehavior() override { report("runBehavior", "of " + name_); }

 private:
  static void report(const std::string& call, const std::string& detail) {
    if (the_planner != nullptr) the_planner->report(call, detail);
  }
  std::string name_;
};

}  // namespace hidwa_probe_planner

PLUGINLIB_EXPORT_CLASS(hidwa_probe_planner::ProbeRecovery, nav_core::RecoveryBehavior)
PLUGINLIB_EXPORT_CLASS(hidwa_probe_planner::ProbePlannerROS, nav_core::BaseLocalPlanner)
