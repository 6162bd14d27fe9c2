// SPDX-License-Identifier: BSD-3-Clause
// How soon the person's messages count, and for how long after the link was cut.
#include <cmath>

#include "person.hpp"

namespace hidwa_plugin_tests {
namespace {

constexpr double kTimeout = 0.5;  // input_timeout's default [s]

using Timeliness = Operated;

TEST_F(Timeliness, AfterACutLinkTurningEndsWithinTheTimeout) {
  set("delta", 5.0);
  start();
  drive();
  person().left = 1.0f;
  ASSERT_TRUE(cycle_until([](const Host::Cycle& c) { return c.command.angular.z > 0.95; }));
  person().sends = false;
  all_cycles([](const Host::Cycle&) { return true; }, 0.1);  // one that was under way
  const ros::Time cut = ros::Time::now();
  person().send();
  bool turning = true;
  ASSERT_TRUE(cycle_until([&](const Host::Cycle& c) {  // it has come
    return turning = c.command.angular.z > 0.0, (state().header.stamp - cut).toSec() >= state().input_age;
  }));
  person().vanish();
  int cycles = 0;  // since it was lost
  cycle_until([&](const Host::Cycle& c) {
    turning = c.command.angular.z > 0.0;
    if (state().state_name == "LOST") ++cycles;
    return !turning;
  });
  EXPECT_EQ(state().state_name, "LOST");
  EXPECT_FALSE(turning);
  EXPECT_LE(cycles, 7);  // 1 rad/s at 3.2 rad/s^2
  double last = 0.0;
  for (const OperatorState& state : person().states()) {
    if (state.wanted.angular.z != 0.0) last = (state.header.stamp - cut).toSec();
  }
  EXPECT_LE(last, kTimeout + kPeriod);
  EXPECT_GE(last, kTimeout - kPeriod);  // not earlier either: a late message is none that is lost
  EXPECT_TRUE(all_cycles([this](const Host::Cycle&) { return state().wanted.angular.z == 0.0; }, 1.0));
}

TEST_F(Timeliness, AMessageCountsInTheNextCycle) {
  start();
  drive();
  person().sends = false;
  for (int i = 0; i < 20; ++i) {
    person().left = 0.4f + 0.02f * static_cast<float>(i);
    person().send();
    host().cycle();
    EXPECT_NEAR(state().wanted.angular.z, std::pow(static_cast<double>(person().left), 2), 1e-9) << i;
    for (int cycle = 0; cycle < 2; ++cycle) host().cycle();
  }
}

}  // namespace
}  // namespace hidwa_plugin_tests

int main(int argc, char** argv) {
  ros::init(argc, argv, "timeliness_test");
  ros::NodeHandle node;
  ::testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
