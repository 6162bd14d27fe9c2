// SPDX-License-Identifier: BSD-3-Clause
#include "person.hpp"

namespace hidwa_plugin_tests {

Person::Person(const Host& host)
    : ticking_([this] {
        if (sends) send();
      }) {
  publisher_ = node_.advertise<sensor_msgs::Joy>("joy", 1);
  ros::NodeHandle topics("~/" + host.name());
  subscriber_ = topics.subscribe<OperatorState>("operator_state", 100, [this](const OperatorState::ConstPtr& m) {
    const std::lock_guard<std::mutex> lock(mutex_);
    states_.push_back(*m);
  });
  wait_for([this] { return subscriber_.getNumPublishers() > 0; });
}

bool Person::heard() const {
  return wait_for([this] { return publisher_.getNumSubscribers() > 0; });
}

Person::~Person() { subscriber_.shutdown(); }

void Person::send() {
  sensor_msgs::Joy message;
  message.header.stamp = ros::Time::now();
  message.axes = {left, ahead, trigger};
  message.buttons = {button ? 1 : 0, second_button ? 1 : 0};
  deliver(publisher_, message);
}

void Person::vanish() {
  sends = false;
  publisher_.shutdown();
}

OperatorState Person::state() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return states_.empty() ? OperatorState() : states_.back();
}

std::vector<OperatorState> Person::states() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return states_;
}

Operated::Operated() : name_(::testing::UnitTest::GetInstance()->current_test_info()->name()) { Stage::get().clear(); }

Operated::~Operated() {
  person_.reset();
  host_.reset();
}

std::string Operated::in_namespace(const std::string& name) const {
  return ros::this_node::getName() + "/" + name_ + "/" + name;
}

void Operated::start() {
  start_unheard();
  ASSERT_TRUE(person_->heard());
}

void Operated::start_unheard() {
  host_ = std::make_unique<Host>(name_);
  person_ = std::make_unique<Person>(*host_);
}

void Operated::drive() {
  ASSERT_TRUE(host().plan_ahead(8.0));
  ASSERT_TRUE(cycle_until([](const Host::Cycle& c) { return c.command.linear.x > 0.499; })) << host().report().fault;
}

bool Operated::reaches(const std::string& name, double seconds) {
  return cycle_until([&](const Host::Cycle&) { return state().state_name == name; }, seconds);
}

bool Operated::all_cycles(const Done& so, double seconds) {
  return !cycle_until([&](const Host::Cycle& c) { return !so(c); }, seconds);
}

void Operated::press() {
  const auto some_cycles = [this] { all_cycles([](const Host::Cycle&) { return true; }, 0.2); };
  ASSERT_TRUE(cycle_until([this](const Host::Cycle&) { return state().input_age >= 0.0; }));
  some_cycles();  // what follows a silence at once could be an old press
  some_cycles();
  person().button = true;
  some_cycles();
  person().button = false;
  some_cycles();
}

void Operated::expect_within_limits() const {
  EXPECT_LE(host_->largest_change().linear.x, 2.5 * kPeriod + 1e-9);
  EXPECT_LE(host_->largest_change().angular.z, 3.2 * kPeriod + 1e-9);
}

bool at_rest(const Host::Cycle& cycle) {
  return cycle.success && cycle.command.linear.x == 0.0 && cycle.command.angular.z == 0.0;
}

}  // namespace hidwa_plugin_tests
