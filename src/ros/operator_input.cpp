// SPDX-License-Identifier: BSD-3-Clause
#include "hidwa_local_planner/ros/operator_input.hpp"

#include <chrono>
#include <thread>

#include <geometry_msgs/Twist.h>
#include <geometry_msgs/TwistStamped.h>

namespace hidwa_local_planner {
namespace {

// The thread that takes messages says so often that it is at work: three of these missed are a pause.
const ros::WallDuration kHeartbeat(0.05);

// After a pause messages may still be on their way from the sockets. So long the control thread waits for them.
constexpr std::chrono::microseconds kPatience(1000);
constexpr int kTries = 5;

bool by_hand(const Parameters& p) { return p.mode == OperatorMode::gesture; }

bool by_twist(const Parameters& p) { return p.mode != OperatorMode::off && input::steered_by_twist(p); }

// What steers, as a person knows it.
std::string steering_topic(const Parameters& p) {
  if (p.mode == OperatorMode::off) return {};
  if (by_twist(p)) return p.twist_topic;
  if (!by_hand(p)) return p.joy_topic;
  return p.gesture_frame.empty() ? p.gesture_topic : "tf " + p.gesture_parent_frame + " -> " + p.gesture_frame;
}

input::HandMessage to_hand(const geometry_msgs::Point& position, const geometry_msgs::Quaternion& orientation) {
  input::HandMessage hand;
  hand.position = {position.x, position.y, position.z};
  hand.orientation = {orientation.x, orientation.y, orientation.z, orientation.w};
  return hand;
}

// False where it is neither of the two types; throws where it only claims to be.
bool read(const topic_tools::ShapeShifter& message, input::TwistMessage& wanted) {
  geometry_msgs::Twist twist;
  if (message.getDataType() == "geometry_msgs/TwistStamped") {
    const auto stamped = message.instantiate<geometry_msgs::TwistStamped>();
    twist = stamped->twist;
    wanted.stamp = stamped->header.stamp.toSec();
  } else if (message.getDataType() == "geometry_msgs/Twist") {
    twist = *message.instantiate<geometry_msgs::Twist>();
  } else {
    return false;
  }
  wanted.u = {twist.linear.x, twist.angular.z};
  return true;
}

}  // namespace

OperatorInput::OperatorInput() { thread_.start(); }

OperatorInput::~OperatorInput() { thread_.stop(); }

void OperatorInput::configure(const Parameters& parameters) {
  const std::lock_guard<std::mutex> lock(mutex_);
  machine_.configure(parameters);
  mode_ = parameters.mode;
}

void OperatorInput::listen(const ros::NodeHandle& handle, const Parameters& parameters) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    const std::string topic = steering_topic(parameters);
    const std::string clutch = by_hand(parameters) ? parameters.joy_topic : "";
    if (topic != device_.topic || clutch != device_.clutch_topic) device_ = {topic, "", 0, clutch, 0};
    stick_steers_ = topic == parameters.joy_topic;
  }
  if (!heartbeat_) {
    heartbeat_ = thread_.serve(handle).createSteadyTimer(kHeartbeat, [this](const ros::SteadyTimerEvent&) {
      const ros::Time now = ros::Time::now();
      if (now.isZero()) return;
      const std::lock_guard<std::mutex> lock(mutex_);
      machine_.listens(now.toSec());
    });
  }
  const bool off = parameters.mode == OperatorMode::off;
  const bool pose = by_hand(parameters) && parameters.gesture_frame.empty();
  follow<sensor_msgs::Joy>(joy_, joy_topic_, handle, off ? "" : parameters.joy_topic, &OperatorInput::receive);
  follow<topic_tools::ShapeShifter>(twist_, twist_topic_, handle, by_twist(parameters) ? parameters.twist_topic : "",
                                    &OperatorInput::receive_twist);
  follow<geometry_msgs::PoseStamped>(hand_, hand_topic_, handle, pose ? parameters.gesture_topic : "",
                                     &OperatorInput::receive_hand);
}

template <typename Message>
void OperatorInput::follow(ros::Subscriber& subscriber, std::string& followed, const ros::NodeHandle& handle,
                           const std::string& topic, Receive<Message> taker) {
  if (topic == followed) return;
  subscriber.shutdown();
  followed.clear();
  if (topic.empty()) return;
  using Event = ros::MessageEvent<const Message>;
  const boost::function<void(const Event&)> callback = [this, taker](const Event& event) {
    const ros::Time now = ros::Time::now();
    if (now.isZero()) return;  // a simulated clock that has not begun: nothing can be said about lateness
    (this->*taker)(*event.getConstMessage(), event.getPublisherName(), now.toSec());
  };
  // Size 1 and no delay: an old deflection must never be worked off late.
  subscriber = thread_.serve(handle).subscribe<Message, const Event&>(topic, 1, callback, nullptr,
                                                                      ros::TransportHints().tcpNoDelay());
  followed = topic;
}

void OperatorInput::receive(const sensor_msgs::Joy& message, const std::string& sender, double received) {
  input::StickMessage stick;
  stick.sender = sender;
  stick.axes = message.axes;
  stick.buttons.assign(message.buttons.begin(), message.buttons.end());
  stick.stamp = message.header.stamp.toSec();
  stick.received = received;
  take(stick, "joystick", stick_steers_);
}

void OperatorInput::receive_twist(const topic_tools::ShapeShifter& message, const std::string& sender,
                                  double received) {
  input::TwistMessage wanted;
  try {
    if (!read(message, wanted)) {
      ROS_WARN_THROTTLE(5.0, "twist_topic carries %s from %s: geometry_msgs/Twist or TwistStamped is wanted",
                        message.getDataType().c_str(), sender.c_str());
      return;
    }
  } catch (const ros::Exception& error) {  // it bears the name of a Twist and is none
    ROS_WARN_THROTTLE(5.0, "twist_topic carries what cannot be read as %s, from %s: %s", message.getDataType().c_str(),
                      sender.c_str(), error.what());
    return;
  }
  wanted.sender = sender;
  wanted.received = received;
  take(wanted, "Twist", true);
}

void OperatorInput::receive_hand(const geometry_msgs::PoseStamped& message, const std::string& sender,
                                 double received) {
  input::HandMessage hand = to_hand(message.pose.position, message.pose.orientation);
  hand.sender = sender;
  hand.stamp = message.header.stamp.toSec();
  hand.received = received;
  take(hand, "hand pose", true);
}

void OperatorInput::receive(const geometry_msgs::TransformStamped& transform, double received) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (transform.header.stamp == hand_stamp_) return;
    hand_stamp_ = transform.header.stamp;
  }
  geometry_msgs::Point position;
  position.x = transform.transform.translation.x;
  position.y = transform.transform.translation.y;
  position.z = transform.transform.translation.z;
  input::HandMessage hand = to_hand(position, transform.transform.rotation);
  hand.sender = "tf";
  hand.stamp = transform.header.stamp.toSec();
  hand.received = received;
  take(hand, "hand transform", true);
}

template <typename Message>
void OperatorInput::take(const Message& message, const char* kind, bool steers) {
  std::string fault;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    fault = machine_.receive(message);
    if (fault.empty() && steers) {
      ++device_.messages;
      device_.sender = message.sender;
    } else if (fault.empty()) {
      ++device_.clutch_messages;
    }
  }
  ++taken_;
  if (!fault.empty()) ROS_WARN_THROTTLE(1.0, "%s message dropped: %s", kind, fault.c_str());
}

// The callbacks need the mutex, so it is not held here.
void OperatorInput::catch_up(double now) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!machine_.behind(now)) return;
  }
  const std::uint64_t taken = taken_;
  const auto end = std::chrono::steady_clock::now() + kTries * kPatience;
  while (taken_ == taken && std::chrono::steady_clock::now() < end) {
    thread_.catch_up(kPatience);
    std::this_thread::sleep_for(kPatience / 10);
  }
}

OperatorIntent OperatorInput::update(double now) {
  catch_up(now);
  std::unique_lock<std::mutex> lock(mutex_);
  if (before_ != nullptr) {
    before_->clear();
    ArchiveWriter write(*before_);
    machine_.save(write);
  }
  const OperatorIntent intent = machine_.update(now);
  const std::string news = machine_.take_news();
  lock.unlock();
  if (!news.empty()) ROS_WARN("%s", news.c_str());
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

bool OperatorInput::manual() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return machine_.manual();
}

void OperatorInput::take_control(bool manual) {
  const std::lock_guard<std::mutex> lock(mutex_);
  machine_.take_control(manual);
}

void OperatorInput::stop(bool stop) {
  const std::lock_guard<std::mutex> lock(mutex_);
  machine_.stop(stop);
}

OperatorInput::Status OperatorInput::status(double now) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  Status status;
  status.state = machine_.state();
  status.mode = mode_;
  status.manual = machine_.manual();
  status.age = machine_.input_age(now);
  status.dropped = machine_.dropped();
  status.own_pause = machine_.lost_by_pauses(now);
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
