// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <hidwa_local_planner/OperatorState.h>
#include <ros/ros.h>
#include <sensor_msgs/Joy.h>

#include "stage.hpp"

namespace hidwa_plugin_tests {

using hidwa_local_planner::OperatorState;

/// A stick with two axes and two buttons on the topic `joy` that repeats itself once a period, and what the
/// planner tells its holder.
class Person {
 public:
  explicit Person(const Host& host);

  float left = 0.0f, ahead = 0.0f;             // axes 0 and 1
  bool button = false, second_button = false;  // buttons 0 and 1
  bool sends = true;
  /// Waits until the planner listens to the stick.
  bool heard() const;
  /// Sends once, now.
  void send();
  /// The stick's node ends.
  void vanish();

  /// The newest.
  OperatorState state() const { return states_.newest(); }
  /// All since the start.
  std::vector<OperatorState> states() const { return states_.all(); }

 private:
  ros::NodeHandle node_;
  ros::Publisher publisher_;
  Messages<OperatorState> states_;
  Ticking ticking_;
};

/// A test with a planner, named as the test, in a room without obstacles, and its person. Parameters first,
/// then start().
class Operated : public ::testing::Test {
 protected:
  Operated();
  ~Operated() override;

  /// A name in the planner's namespace.
  std::string in_namespace(const std::string& name) const { return ns(name_) + name; }
  template <typename Value>
  void set(const std::string& parameter, const Value& value) {
    ros::param::set(in_namespace(parameter), value);
  }
  void start();
  /// The same where the planner does not listen to the topic `joy`, as in mode off.
  void start_unheard();
  /// On a straight plan of 8 m at full speed, with nobody steering.
  void drive();

  using Done = std::function<bool(const Host::Cycle&)>;
  bool cycle_until(const Done& done, double seconds = kPatience) { return host().cycle_until(done, seconds); }
  /// Cycles until the state has this name.
  bool reaches(const std::string& state, double seconds = kPatience);
  /// Runs cycles for a simulated time [s]; whether all of them were so.
  bool all_cycles(const Done& so, double seconds);
  /// Runs cycles for a simulated time [s].
  void pass_cycles(double seconds) {
    all_cycles([](const Host::Cycle&) { return true; }, seconds);
  }
  /// Whether in none of these cycles [s] the person's input counts.
  bool nobody_steers(double seconds) {
    return all_cycles([this](const Host::Cycle&) { return !state().active; }, seconds);
  }
  /// A press of the button and its release, by a stick that the planner has heard for a while; with cycles, as
  /// while driving.
  void press();
  /// Says it once, on a topic in the planner's namespace; false where nobody listens.
  template <typename Message, typename Value>
  bool say(const std::string& topic, const Value& value) {
    said_.push_back(node_.advertise<Message>(in_namespace(topic), 1));
    const ros::Publisher& publisher = said_.back();
    if (!wait_for([&] { return publisher.getNumSubscribers() > 0; })) return false;
    Message message;
    message.data = value;
    deliver(publisher, message);
    return true;
  }
  /// The commands so far kept the acceleration limits of the default profile.
  void expect_within_limits() const;

  Host& host() { return *host_; }
  Person& person() { return *person_; }
  OperatorState state() const { return person_->state(); }

 private:
  std::string name_;
  ros::NodeHandle node_;
  std::vector<ros::Publisher> said_;  // what is published goes out later
  std::unique_ptr<Host> host_;
  std::unique_ptr<Person> person_;
};

bool at_rest(const Host::Cycle& cycle);

}  // namespace hidwa_plugin_tests
