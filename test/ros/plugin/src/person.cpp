// SPDX-License-Identifier: BSD-3-Clause
#include "person.hpp"

namespace hidwa_plugin_tests {

Person::Person(const Host& host)
    : states_(ns(host.name()) + "operator_state"), ticking_([this] {
        if (sends) send();
      }) {
  publisher_ = node_.advertise<sensor_msgs::Joy>("joy", 1);
  states_.connected();
}

bool Person::heard() const {
  return wait_for([this] { return publisher_.getNumSubscribers() > 0; });
}

void Person::send() {
  sensor_msgs::Joy message;
  message.header.stamp = ros::Time::now();
  message.axes = {left, ahead};
  message.buttons = {button ? 1 : 0, second_button ? 1 : 0};
  deliver(publisher_, message);
}

void Person::vanish() {
  sends = false;
  publisher_.shutdown();
}

Operated::Operated() : name_(::testing::UnitTest::GetInstance()->current_test_info()->name()) { Stage::get().clear(); }

Operated::~Operated() {
  person_.reset();
  host_.reset();
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
  ASSERT_TRUE(host().drives(0.499)) << host().report().fault;
}

bool Operated::reaches(const std::string& name, double seconds) {
  return cycle_until([&](const Host::Cycle&) { return state().state_name == name; }, seconds);
}

bool Operated::all_cycles(const Done& so, double seconds) {
  return !cycle_until([&](const Host::Cycle& c) { return !so(c); }, seconds);
}

void Operated::press() {
  ASSERT_TRUE(cycle_until([this](const Host::Cycle&) { return state().input_age >= 0.0; }));
  pass_cycles(0.4);  // what follows a silence at once could be an old press
  person().button = true;
  pass_cycles(0.2);
  person().button = false;
  pass_cycles(0.2);
}

void Operated::expect_within_limits() const {
  EXPECT_LE(host_->largest_change().linear.x, 2.5 * kPeriod + 1e-9);
  EXPECT_LE(host_->largest_change().angular.z, 3.2 * kPeriod + 1e-9);
}

bool at_rest(const Host::Cycle& cycle) {
  return cycle.success && cycle.command.linear.x == 0.0 && cycle.command.angular.z == 0.0;
}

}  // namespace hidwa_plugin_tests
