// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstdlib>
#include <functional>
#include <limits>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include <costmap_2d/costmap_2d_ros.h>
#include <diagnostic_msgs/DiagnosticArray.h>
#include <geometry_msgs/PoseStamped.h>
#include <geometry_msgs/Twist.h>
#include <hidwa_local_planner/Cycle.h>
#include <nav_core/base_local_planner.h>
#include <ros/ros.h>
#include <rosgraph_msgs/Log.h>
#include <tf2_ros/buffer.h>
#include <boost/make_shared.hpp>
#include <pluginlib/class_loader.hpp>

namespace hidwa_plugin_tests {

constexpr double kPeriod = 0.05;  // of the control cycle, as in the launch files [s]
// Whatever is waited for comes long before, also on a slow machine: wall time for what other threads and processes do,
// simulated time for what the robot and the planner do [s].
constexpr double kPatience = 60.0;

struct Pose {
  double x = 0.0, y = 0.0, theta = 0.0;  // [m, rad]
};

/// Waits until `done`, while simulated time stands still; false after kPatience.
bool wait_for(const std::function<bool()>& done);

/// Publishes, and waits until everybody in this process has taken the message: each callback has run, or a newer
/// message has taken its place.
template <typename Message>
void deliver(const ros::Publisher& publisher, Message message) {
  auto shared = boost::make_shared<Message>(std::move(message));
  const boost::weak_ptr<Message> sent = shared;
  publisher.publish(shared);
  shared.reset();
  wait_for([&sent] { return sent.expired(); });
}

/// The namespace of a planner of this process, with a slash at its end.
std::string ns(const std::string& name);

/// What came on a topic since it was made.
template <typename Message>
class Messages {
 public:
  explicit Messages(const std::string& topic) {
    subscriber_ = ros::NodeHandle().subscribe<Message>(topic, 1000, [this](const typename Message::ConstPtr& message) {
      const std::lock_guard<std::mutex> lock(mutex_);
      all_.push_back(*message);
    });
  }
  /// Waits until somebody publishes there.
  bool connected() const {
    return wait_for([this] { return subscriber_.getNumPublishers() > 0; });
  }
  std::vector<Message> all() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return all_;
  }
  bool any() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return !all_.empty();
  }
  /// An empty one where none came.
  Message newest() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return all_.empty() ? Message() : all_.back();
  }
  void forget() {
    const std::lock_guard<std::mutex> lock(mutex_);
    all_.clear();
  }

 private:
  mutable std::mutex mutex_;
  std::vector<Message> all_;
  ros::Subscriber subscriber_;
};

/// A robot without inertia that does at once what it is told, with odometry, laser and transforms that can be
/// silenced one by one.
class Robot {
 public:
  explicit Robot(tf2_ros::Buffer& tf);
  void command(const geometry_msgs::Twist& twist);
  Pose pose() const;
  /// Somebody carries it there.
  void put(const Pose& pose);
  /// A wall that only the laser sees, `ahead` [m] of the robot's centre and across its way; without end, and
  /// the robot drives through it.
  void wall_ahead(double ahead);
  void no_wall();
  /// The smallest distance of the robot's centre from that wall so far [m]; infinite where there was none.
  double room() const;
  /// It moves for `dt` [s] and sends what it measures then.
  void step(double dt);

  /// It sends all that it measures.
  void mend() { odometry = laser = base_transform = map_transform = true; }
  std::atomic<bool> odometry{true}, laser{true}, base_transform{true}, map_transform{true};
  std::atomic<double> transforms_ahead{0.0};  // of the clock that stamps the transforms [s]

 private:
  double range(const Pose& from, double angle) const;  // [m], to the wall; needs mutex_
  void send_transform(const std::string& parent, const std::string& child, const Pose& pose);

  tf2_ros::Buffer& tf_;
  ros::Publisher odometry_publisher_, laser_publisher_;
  mutable std::mutex mutex_;
  Pose pose_;
  geometry_msgs::Twist command_;
  bool wall_ = false;
  double wall_heading_ = 0.0, wall_distance_ = 0.0;  // its normal, and its distance from the origin of odom
  double room_ = std::numeric_limits<double>::infinity();
};

/// Robot, costmap, tf and clock, shared by the tests of one process.
///
/// Time is simulated, and only the test's thread moves it on: pass(). What was sent in a step is taken before the next
/// step, so a busy machine makes a test longer and changes nothing else.
class Stage {
 public:
  static Stage& get();
  /// Lets simulated time pass [s]: the robot moves, what ticks() names is called, the costmap is brought up to date.
  void pass(double seconds);
  /// The clock alone moves on [s], as if the process had been suspended.
  void skip(double seconds);
  /// Lets time pass until `done`; false once the simulated time [s] is over.
  bool pass_until(const std::function<bool()>& done, double seconds = kPatience);
  /// No obstacles, neither there nor remembered.
  void clear();
  tf2_ros::Buffer tf;
  Robot robot;
  std::unique_ptr<costmap_2d::Costmap2DROS> costmap;
  bool costmap_follows = true;  // the robot

 private:
  friend class Ticking;
  Stage();
  void step();
  ros::AsyncSpinner spinner_;
  std::vector<const std::function<void()>*> ticking_;
  unsigned long steps_ = 0;
  ros::WallTime due_;  // the next step, not earlier
};

/// Calls a function once a control period of simulated time, while it exists.
class Ticking {
 public:
  explicit Ticking(std::function<void()> tick);
  ~Ticking();
  Ticking(const Ticking&) = delete;
  Ticking& operator=(const Ticking&) = delete;

 private:
  std::function<void()> tick_;
};

/// Straight from the robot's pose, `ahead` [m] along its heading (behind it when negative), in `frame`; `left` [rad] of
/// that heading.
std::vector<geometry_msgs::PoseStamped> straight_plan(double ahead, const std::string& frame = "odom",
                                                      double left = 0.0);

/// A planner loaded as a host does it, in a namespace of its own, and the control loop round it.
class Host {
 public:
  enum class Listens { yes, no };
  /// Parameters belong on the server before. A host that does not listen gets no report().
  explicit Host(const std::string& name, Listens listens = Listens::yes);
  ~Host();

  nav_core::BaseLocalPlanner& planner() { return *planner_; }
  const std::string& name() const { return name_; }

  /// Gives it a straight_plan().
  bool plan_ahead(double ahead, const std::string& frame = "odom");

  struct Cycle {
    bool success = false;
    geometry_msgs::Twist command;
    /// The time since the cycle before, in periods, one at least. A late cycle may brake by as much as could have been
    /// braked since the one before.
    double late = 1.0;
  };
  /// One control cycle: computes, drives (stops on failure, as move_base does), and a period passes. What the planner
  /// published has come when it returns.
  Cycle cycle();
  /// Runs cycles until `done` is true of one; false once the simulated time [s] is over.
  bool cycle_until(const std::function<bool(const Cycle&)>& done, double seconds = kPatience);
  /// Cycles until one drives faster ahead than this [m/s].
  bool drives(double speed = 0.2) {
    return cycle_until([speed](const Cycle& c) { return c.success && c.command.linear.x > speed; });
  }
  /// Whether the robot rests for 20 cycles, the last of which fails.
  bool refuses_to_drive();
  /// The largest change between two successful commands that follow each other [m/s, rad/s]. After a late cycle the
  /// change counts per control period.
  geometry_msgs::Twist largest_change() const { return largest_change_; }
  /// The newest message about a cycle.
  hidwa_local_planner::Cycle report() const { return reports_->newest(); }
  /// Brings the robot to rest.
  void stop();

 private:
  std::string name_;
  boost::shared_ptr<nav_core::BaseLocalPlanner> planner_;
  std::unique_ptr<Messages<hidwa_local_planner::Cycle>> reports_;
  Cycle last_;
  geometry_msgs::Twist largest_change_;
  ros::Time begun_;  // the last cycle
};

/// What the process logs, while it exists.
class LogListener {
 public:
  bool said(const std::string& part) const { return times(part) > 0; }
  int times(const std::string& part) const;

 private:
  Messages<rosgraph_msgs::Log> lines_{"/rosout"};
};

/// What /diagnostics says, once a second, of a planner, or of a part of it: "Planner operator".
class Diagnosis {
 public:
  explicit Diagnosis(const std::string& part) : name_(ros::this_node::getName().substr(1) + ": " + part) {}
  diagnostic_msgs::DiagnosticStatus status() const;
  int level() const { return status().level; }
  std::string message() const { return status().message; }
  bool says(const std::string& words) const { return message().find(words) != std::string::npos; }
  std::string value(const std::string& key) const;
  double number(const std::string& key) const { return std::atof(value(key).c_str()); }

 private:
  std::string name_;
  Messages<diagnostic_msgs::DiagnosticArray> heard_{"/diagnostics"};
};

}  // namespace hidwa_plugin_tests
