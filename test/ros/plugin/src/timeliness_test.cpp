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
  cycle_until(
      [&](const Host::Cycle& c) {
        turning = c.command.angular.z > 0.0;
        if (state().state_name == "LOST") ++cycles;
        return !turning;
      },
      3.0);
  EXPECT_EQ(state().state_name, "LOST");
  EXPECT_FALSE(turning);
  EXPECT_LE(cycles, 7);  // 1 rad/s at 3.2 rad/s^2
  double last = 0.0;
  for (const OperatorState& state : person().states()) {
    if (state.wanted.angular.z != 0.0) last = (state.header.stamp - cut).toSec();
  }
  EXPECT_LE(last, kTimeout + kPeriod);
  EXPECT_GE(last, kTimeout - 4.0 * kPeriod);  // not earlier either: a late message is none that is lost
  EXPECT_TRUE(all_cycles([this](const Host::Cycle&) { return state().wanted.angular.z == 0.0; }, 1.0));
}

TEST_F(Timeliness, AMessageCountsWithinOneControlPeriod) {
  start();
  drive();
  person().sends = false;
  all_cycles([](const Host::Cycle&) { return true; }, 0.1);
  struct Sent {
    ros::Time time;
    double wanted;
  };
  std::vector<Sent> sent;
  for (int i = 0; i < 20; ++i) {
    const float deflection = 0.4f + 0.02f * static_cast<float>(i);
    person().left = deflection;
    person().send();
    sent.push_back({ros::Time::now(), std::pow(static_cast<double>(deflection), 2)});
    for (int cycle = 0; cycle < 3; ++cycle) host().cycle();
  }
  // The last cycle's message is still on its way.
  ASSERT_TRUE(wait_for([&] { return std::abs(state().wanted.angular.z - sent.back().wanted) < 1e-9; }, 2.0));
  int seen = 0;
  for (const OperatorState& state : person().states()) {
    const auto later = [&](const Sent& s) { return (state.header.stamp - s.time).toSec() > kPeriod; };
    std::size_t due = sent.size();  // the newest that is older than one period
    while (due > 0 && !later(sent[due - 1])) --due;
    if (due == 0) continue;
    ++seen;
    EXPECT_GE(state.wanted.angular.z, sent[due - 1].wanted - 1e-9) << due;
  }
  EXPECT_GE(seen, 20);
}

}  // namespace
}  // namespace hidwa_plugin_tests

int main(int argc, char** argv) {
  ros::init(argc, argv, "timeliness_test");
  ros::NodeHandle node;
  ::testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
