// SPDX-License-Identifier: BSD-3-Clause
#include "ros/operator_input.hpp"

#include <chrono>
#include <ctime>
#include <optional>
#include <thread>

#include <ros/console.h>
#include <std_msgs/Bool.h>
#include <tf2/exceptions.h>

namespace hidwa_local_planner {
namespace {

// The thread that takes messages sends heartbeats at this interval; three missed ones are a pause.
const ros::WallDuration kHeartbeat(0.05);

// After a pause messages may still be on their way from the sockets. The control thread waits for them this long.
constexpr std::chrono::milliseconds kPatience(5);

// How far ROS's clock is ahead of one that nobody can set and that goes on while the machine sleeps [s]. None with a
// simulated clock, whose steps are no fault.
std::optional<double> clock_ahead(const ros::Time& stamp) {
  timespec time{};
  if (ros::Time::isSimTime() || clock_gettime(CLOCK_BOOTTIME, &time) != 0) return std::nullopt;
  return stamp.toSec() - static_cast<double>(time.tv_sec) - 1e-9 * static_cast<double>(time.tv_nsec);
}

// The same topic again changes nothing; an empty one: none.
void follow(OperatorDevice& device, const std::string& topic, const ros::NodeHandle& handle) {
  if (topic == device.topic) return;
  device.subscriber.shutdown();
  device.topic.clear();
  if (topic.empty()) return;
  device.subscriber = device.subscribe(handle, topic);
  device.topic = topic;
}

}  // namespace

OperatorInput::OperatorInput(const tf2_ros::Buffer& tf)
    : tf_(tf), devices_(operator_devices([this](const std::string& source, const input::OperatorMessage& message) {
        return take(source, message);
      })) {
  thread_.start();
}

OperatorInput::~OperatorInput() { thread_.stop(); }

void OperatorInput::configure(const Parameters& parameters) {
  const std::lock_guard<std::mutex> lock(mutex_);
  machine_.configure(parameters);
  mode_ = parameters.mode;
}

void OperatorInput::listen(const ros::NodeHandle& handle, const Parameters& parameters) {
  std::vector<input::ListedSource> sources;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    sources = machine_.sources(parameters);
    show_device(sources);
  }
  start_heartbeat(handle);
  for (OperatorDevice& device : devices_) {
    for (const input::ListedSource& source : sources) {
      if (source.kind.name != device.source) continue;
      follow(device, source.listened_to ? source.topic.topic : "", thread_.serve(handle));
    }
  }
}

// A stop waits for no other callback: a change of parameters may take long.
void OperatorInput::listen_to_commands(const ros::NodeHandle& handle) {
  ros::NodeHandle prompt = thread_.serve(handle);
  const auto without_delay = ros::TransportHints().tcpNoDelay();
  using Request = const std_msgs::Bool::ConstPtr&;
  const boost::function<void(Request)> take_control = [this](Request request) {
    const std::lock_guard<std::mutex> lock(mutex_);
    machine_.take_control(request->data);
  };
  const boost::function<void(Request)> stop = [this](Request request) {
    const std::lock_guard<std::mutex> lock(mutex_);
    machine_.stop(request->data);
  };
  take_control_ = prompt.subscribe<std_msgs::Bool>("take_control", 1, take_control, nullptr, without_delay);
  stop_ = prompt.subscribe<std_msgs::Bool>("stop", 1, stop, nullptr, without_delay);
}

// The counts begin anew where another device steers or has its clutch.
void OperatorInput::show_device(const std::vector<input::ListedSource>& sources) {
  Device device;
  std::string buttons_topic;
  bool needs_clutch = false;
  steering_.clear();
  for (const input::ListedSource& source : sources) {
    if (source.kind.has_buttons && source.listened_to) buttons_topic = source.topic.label;
    if (!source.steers) continue;
    steering_ = source.kind.name;
    device.topic = source.topic.label;
    needs_clutch = source.kind.needs_clutch;
  }
  if (needs_clutch) device.clutch_topic = buttons_topic;
  if (device.topic != device_.topic || device.clutch_topic != device_.clutch_topic) device_ = device;
}

void OperatorInput::start_heartbeat(const ros::NodeHandle& handle) {
  if (heartbeat_) return;
  heartbeat_ = thread_.serve(handle).createSteadyTimer(kHeartbeat, [this](const ros::SteadyTimerEvent&) {
    const LoopTime now = LoopTime::now();
    if (now.stamp.isZero()) return;
    const std::optional<double> ahead = clock_ahead(now.stamp);
    const std::lock_guard<std::mutex> lock(mutex_);
    machine_.heartbeat(now.seconds, ahead);
  });
}

std::string OperatorInput::take(const std::string& source, const input::OperatorMessage& message) {
  const std::lock_guard<std::mutex> lock(mutex_);
  std::string fault = machine_.receive(message);
  if (fault.empty() && source == steering_) {
    ++device_.messages;
    device_.sender = machine_.sender();
  } else if (fault.empty()) {
    ++device_.clutch_messages;
  }
  return fault;
}

void OperatorInput::look_for_hand(const Parameters& parameters, const LoopTime& now) {
  if (parameters.mode != OperatorMode::gesture || parameters.gesture_frame.empty()) return;
  geometry_msgs::TransformStamped transform;
  try {
    transform = tf_.lookupTransform(parameters.gesture_parent_frame, parameters.gesture_frame, ros::Time(0));
  } catch (const tf2::TransformException&) {
    return;
  }
  if (transform.header.stamp == hand_stamp_) return;
  hand_stamp_ = transform.header.stamp;
  input::HandMessage hand = to_hand(transform, now);
  hand.sender = "tf";
  hand.received = now.seconds;
  const std::string fault = take("hand", hand);
  if (!fault.empty()) ROS_WARN_THROTTLE(1.0, "hand transform message dropped: %s", fault.c_str());
}

// The callbacks need the mutex, so it is not held here.
void OperatorInput::catch_up(double now) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!machine_.paused_since_last_cycle(now)) return;
  }
  std::this_thread::sleep_for(kPatience);
}

OperatorIntent OperatorInput::update(double now, Bytes* before) {
  catch_up(now);
  std::unique_lock<std::mutex> lock(mutex_);
  if (before != nullptr) {
    before->clear();
    ArchiveWriter write(*before);
    machine_.save(write);
  }
  const OperatorIntent intent = machine_.update(now);
  const std::string warnings = machine_.take_warnings();
  lock.unlock();
  if (!warnings.empty()) ROS_WARN("%s", warnings.c_str());
  return intent;
}

void OperatorInput::debrief(double now, const input::CycleFeedback& feedback) {
  const std::lock_guard<std::mutex> lock(mutex_);
  machine_.debrief(now, feedback);
}

void OperatorInput::new_goal() {
  const std::lock_guard<std::mutex> lock(mutex_);
  machine_.new_goal();
}

void OperatorInput::set_goalless(bool goalless) {
  const std::lock_guard<std::mutex> lock(mutex_);
  machine_.set_goalless(goalless);
}

OperatorInput::Status OperatorInput::status(double now) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  Status status;
  status.state = machine_.state();
  status.mode = mode_;
  status.manual = machine_.manual();
  status.steers = machine_.steers();
  status.goalless = machine_.goalless();
  status.age = machine_.input_age(now);
  status.dropped = machine_.dropped();
  status.lost_by_pauses = machine_.lost_by_pauses(now);
  return status;
}

OperatorInput::Device OperatorInput::device() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return device_;
}

std::string OperatorInput::advice() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return machine_.advice();
}

}  // namespace hidwa_local_planner
