// SPDX-License-Identifier: BSD-3-Clause
#include "stage.hpp"

#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <future>
#include <limits>

#include <costmap_2d/cost_values.h>
#include <nav_msgs/Odometry.h>
#include <ros/callback_queue.h>
#include <ros/poll_manager.h>
#include <sensor_msgs/LaserScan.h>

namespace hidwa_plugin_tests {
namespace {

constexpr double kStep = 0.5 * kPeriod;  // [s]
constexpr double kOnTheWay = 0.005;      // how old a message is when it comes [s]
constexpr unsigned long kMapSteps = 4;   // the costmap is brought up to date every 0.1 s
// Simulated seconds a second, at most: what comes once a second of wall time, as diagnostics, comes while it drives.
constexpr double kFastest = 5.0;

/// Waits until what this process has published is in the queues of those who listen within it. roscpp's poll thread
/// puts it there in each of its turns: one is under way perhaps, the next one has all.
void hand_over() {
  static std::atomic<unsigned long> turns{0};
  static const boost::signals2::connection connection =
      ros::PollManager::instance()->addPollThreadListener([] { ++turns; });
  const unsigned long before = turns;
  wait_for([&] {
    ros::PollManager::instance()->getPollSet().signal();  // else a turn waits for the next message, up to 0.1 s
    return turns >= before + 2;
  });
}

/// Waits until the callbacks that are due now have run.
void run_callbacks() {
  struct Mark : ros::CallbackInterface {
    CallResult call() override {
      reached.set_value();
      return Success;
    }
    std::promise<void> reached;
  };
  const auto mark = boost::make_shared<Mark>();
  const std::future<void> reached = mark->reached.get_future();
  ros::getGlobalCallbackQueue()->addCallback(mark);
  reached.wait_for(std::chrono::duration<double>(kPatience));
}

geometry_msgs::Quaternion heading(double theta) {
  geometry_msgs::Quaternion q;
  q.z = std::sin(0.5 * theta);
  q.w = std::cos(0.5 * theta);
  return q;
}

/// The map lies away from odom: a plan in it needs the transform.
const Pose kOdomInMap{3.0, -2.0, 0.5};

// Never destroyed: what it would use at the end of the process is gone by then.
pluginlib::ClassLoader<nav_core::BaseLocalPlanner>& loader() {
  static auto* instance =
      new pluginlib::ClassLoader<nav_core::BaseLocalPlanner>("nav_core", "nav_core::BaseLocalPlanner");
  return *instance;
}

}  // namespace

Robot::Robot(tf2_ros::Buffer& tf) : tf_(tf) {
  ros::NodeHandle node;
  odometry_publisher_ = node.advertise<nav_msgs::Odometry>("odom", 1);
  laser_publisher_ = node.advertise<sensor_msgs::LaserScan>("scan", 1);
}

void Robot::command(const geometry_msgs::Twist& twist) {
  const std::lock_guard<std::mutex> lock(mutex_);
  command_ = twist;
}

Pose Robot::pose() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return pose_;
}

void Robot::put(const Pose& pose) {
  const std::lock_guard<std::mutex> lock(mutex_);
  pose_ = pose;
}

void Robot::wall_ahead(double ahead) {
  const std::lock_guard<std::mutex> lock(mutex_);
  wall_ = true;
  wall_heading_ = pose_.theta;
  wall_distance_ = pose_.x * std::cos(wall_heading_) + pose_.y * std::sin(wall_heading_) + ahead;
  room_ = ahead;
}

void Robot::no_wall() {
  const std::lock_guard<std::mutex> lock(mutex_);
  wall_ = false;
  room_ = std::numeric_limits<double>::infinity();
}

double Robot::room() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return room_;
}

double Robot::range(const Pose& from, double angle) const {
  const double towards = std::cos(from.theta + angle - wall_heading_);
  const double to_wall = wall_distance_ - from.x * std::cos(wall_heading_) - from.y * std::sin(wall_heading_);
  return wall_ && towards > 1e-6 ? to_wall / towards : std::numeric_limits<double>::infinity();
}

void Robot::step(double dt) {
  nav_msgs::Odometry message;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    const double middle = pose_.theta + 0.5 * command_.angular.z * dt;
    pose_.x += command_.linear.x * std::cos(middle) * dt;
    pose_.y += command_.linear.x * std::sin(middle) * dt;
    pose_.theta = std::remainder(pose_.theta + command_.angular.z * dt, 2.0 * M_PI);
    message.twist.twist = command_;
    if (wall_) room_ = std::min(room_, range(pose_, wall_heading_ - pose_.theta));
  }
  const Pose now = pose();
  if (base_transform) send_transform("odom", "base_link", now);
  if (map_transform) send_transform("map", "odom", kOdomInMap);
  if (odometry) {
    message.header.stamp = ros::Time::now();
    message.header.frame_id = "odom";
    message.child_frame_id = "base_link";
    deliver(odometry_publisher_, message);
  }
  if (laser) {
    sensor_msgs::LaserScan scan;
    scan.header.stamp = ros::Time::now();
    scan.header.frame_id = "base_link";
    scan.angle_min = -3.0f;
    scan.angle_max = 3.0f;
    scan.angle_increment = 0.02f;
    scan.range_min = 0.05f;
    scan.range_max = 10.0f;
    const std::lock_guard<std::mutex> lock(mutex_);
    for (int i = 0; i <= 300; ++i) {
      const auto distance = static_cast<float>(range(now, -3.0 + 0.02 * i));
      scan.ranges.push_back(distance < scan.range_max ? distance : std::numeric_limits<float>::infinity());
    }
    laser_publisher_.publish(scan);
  }
}

void Robot::send_transform(const std::string& parent, const std::string& child, const Pose& pose) {
  geometry_msgs::TransformStamped transform;
  transform.header.stamp = ros::Time::now() + ros::Duration(transforms_ahead);
  transform.header.frame_id = parent;
  transform.child_frame_id = child;
  transform.transform.translation.x = pose.x;
  transform.transform.translation.y = pose.y;
  transform.transform.rotation = heading(pose.theta);
  tf_.setTransform(transform, "stage", false);
}

Stage& Stage::get() {
  static Stage stage;
  return stage;
}

Stage::Stage() : robot(tf), spinner_(1) {
  // Tests beside this one that keep to the world's time need the processor sooner.
  if (nice(10) == -1) ROS_WARN("the priority stays as it is");
  ros::Time::setNow(ros::Time(1000.0));
  tf.setUsingDedicatedThread(true);
  spinner_.start();
  step();  // the costmap wants to know where the robot is
  costmap = std::make_unique<costmap_2d::Costmap2DROS>("local_costmap", tf);
  pass_until([this] { return costmap->isCurrent(); });
}

void Stage::step() {
  due_ = std::max(due_ + ros::WallDuration(kStep / kFastest), ros::WallTime::now());
  ros::WallTime::sleepUntil(due_);
  skip(kStep - kOnTheWay);
  robot.step(kStep);
  if (steps_++ % 2 == 0) {
    for (const std::function<void()>* tick : ticking_) (*tick)();
  }
  skip(kOnTheWay);
  hand_over();
  run_callbacks();  // of what came
  run_callbacks();  // and of what those have made due, as a scan whose transform is there
  if (costmap && costmap_follows && steps_ % kMapSteps == 0) costmap->updateMap();
}

void Stage::pass(double seconds) {
  for (long i = std::lround(seconds / kStep); i > 0; --i) step();
}

void Stage::skip(double seconds) { ros::Time::setNow(ros::Time::now() + ros::Duration(seconds)); }

bool Stage::pass_until(const std::function<bool()>& done, double seconds) {
  for (long i = std::lround(seconds / kStep); !done(); --i) {
    if (i == 0) return false;
    step();
  }
  return true;
}

void Stage::clear() {
  robot.no_wall();
  costmap->resetLayers();
  pass(2.0 * kStep * kMapSteps);  // the costmap is made anew of scans that see nothing
}

Ticking::Ticking(std::function<void()> tick) : tick_(std::move(tick)) { Stage::get().ticking_.push_back(&tick_); }

Ticking::~Ticking() {
  std::vector<const std::function<void()>*>& all = Stage::get().ticking_;
  all.erase(std::find(all.begin(), all.end(), &tick_));
}

std::vector<geometry_msgs::PoseStamped> straight_plan(double ahead, const std::string& frame, double left) {
  Pose start = Stage::get().robot.pose();
  start.theta += left;
  std::vector<geometry_msgs::PoseStamped> plan;
  const int steps = static_cast<int>(std::lround(std::abs(ahead) / 0.05));
  for (int i = 0; i <= steps; ++i) {
    const double along = ahead * i / steps;
    Pose pose{start.x + along * std::cos(start.theta), start.y + along * std::sin(start.theta), start.theta};
    if (frame == "map") {
      const double c = std::cos(kOdomInMap.theta);
      const double s = std::sin(kOdomInMap.theta);
      pose = {kOdomInMap.x + c * pose.x - s * pose.y, kOdomInMap.y + s * pose.x + c * pose.y,
              pose.theta + kOdomInMap.theta};
    }
    geometry_msgs::PoseStamped stamped;
    stamped.header.frame_id = frame;
    stamped.pose.position.x = pose.x;
    stamped.pose.position.y = pose.y;
    stamped.pose.orientation = heading(pose.theta);
    plan.push_back(stamped);
  }
  return plan;
}

Host::Host(const std::string& name, Listens listens) : name_(name) {
  Stage& stage = Stage::get();
  planner_ = loader().createInstance("hidwa_local_planner/HIDWAPlannerROS");
  planner_->initialize(name, &stage.tf, stage.costmap.get());
  if (listens == Listens::no) return;
  reports_ = std::make_unique<Messages<hidwa_local_planner::Cycle>>(ns(name) + "cycle");
  reports_->connected();
}

Host::~Host() { stop(); }

bool Host::plan_ahead(double ahead, const std::string& frame) { return planner_->setPlan(straight_plan(ahead, frame)); }

Host::Cycle Host::cycle() {
  Stage& stage = Stage::get();
  Cycle cycle;
  {
    const boost::unique_lock<costmap_2d::Costmap2D::mutex_t> lock(*stage.costmap->getCostmap()->getMutex());
    cycle.success = planner_->computeVelocityCommands(cycle.command);
  }
  stage.robot.command(cycle.success ? cycle.command : geometry_msgs::Twist());
  const ros::Time now = ros::Time::now();
  cycle.late = std::max(1.0, (now - begun_).toSec() / kPeriod);
  if (cycle.success && last_.success) {
    const auto larger = [&cycle](double& largest, double a, double b) {
      largest = std::max(largest, std::abs(a - b) / cycle.late);
    };
    larger(largest_change_.linear.x, cycle.command.linear.x, last_.command.linear.x);
    larger(largest_change_.angular.z, cycle.command.angular.z, last_.command.angular.z);
  }
  last_ = cycle;
  begun_ = now;
  stage.pass(kPeriod);
  return cycle;
}

bool Host::cycle_until(const std::function<bool(const Cycle&)>& done, double seconds) {
  const ros::Time end = ros::Time::now() + ros::Duration(seconds);
  while (ros::Time::now() < end) {
    if (done(cycle())) return true;
  }
  return false;
}

bool Host::refuses_to_drive() {
  bool rests = true;
  Cycle last;
  for (int i = 0; i < 20; ++i) {
    last = cycle();
    rests = rests && last.command.linear.x == 0.0;
  }
  return rests && !last.success;
}

void Host::stop() { Stage::get().robot.command(geometry_msgs::Twist()); }

bool wait_for(const std::function<bool()>& done) {
  const ros::WallTime end = ros::WallTime::now() + ros::WallDuration(kPatience);
  while (!done()) {
    if (ros::WallTime::now() > end) return false;
    ros::WallDuration(0.0002).sleep();
  }
  return true;
}

std::string ns(const std::string& name) { return ros::this_node::getName() + "/" + name + "/"; }

int LogListener::times(const std::string& part) const {
  const std::vector<rosgraph_msgs::Log> lines = lines_.all();
  return static_cast<int>(std::count_if(lines.begin(), lines.end(), [&part](const rosgraph_msgs::Log& line) {
    return line.msg.find(part) != std::string::npos;
  }));
}

diagnostic_msgs::DiagnosticStatus Diagnosis::status() const {
  diagnostic_msgs::DiagnosticStatus newest;
  for (const diagnostic_msgs::DiagnosticArray& array : heard_.all()) {
    for (const diagnostic_msgs::DiagnosticStatus& status : array.status) {
      if (status.name == name_) newest = status;
    }
  }
  return newest;
}

std::string Diagnosis::value(const std::string& key) const {
  const diagnostic_msgs::DiagnosticStatus newest = status();
  for (const diagnostic_msgs::KeyValue& pair : newest.values) {
    if (pair.key == key) return pair.value;
  }
  return "there is no " + key;
}

}  // namespace hidwa_plugin_tests
