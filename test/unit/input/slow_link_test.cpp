// SPDX-License-Identifier: BSD-3-Clause
// A link that becomes slower and stays so.
#include <functional>
#include <string>

#include <gtest/gtest.h>

#include "person.hpp"

namespace hidwa_local_planner::input {
namespace {

using State = OperatorStateId;
constexpr double kPeriod = 0.05;  // of the cycle and of the stick [s]

/// A stick at 20 Hz whose messages take as long as the link says.
struct Remote : Person {
  using Person::Person;
  /// Sends from `sent` on for `seconds`; each message arrives `lag` [s] later, with a cycle. The last cycle's state.
  State play(double seconds, float angular, const std::function<double(double)>& lag) {
    const int count = static_cast<int>(seconds / kPeriod + 0.5);
    for (int i = 0; i < count; ++i, sent += kPeriod) {
      StickMessage message = stick_at(sent + lag(kPeriod * i), angular);
      message.stamp = sent;
      fault = machine.receive(message);
      cycle(message.received);
    }
    return machine.state();
  }
  State play(double seconds, float angular, double lag) {
    return play(seconds, angular, [lag](double) { return lag; });
  }
  double sent = 100.0;  // [s]
  std::string fault;    // of the last message
};

TEST(SlowLink, IsTakenAsItIsAfterTwoSecondsAndANeutral) {
  Remote remote;
  EXPECT_EQ(remote.play(1.0, 0.0F, 0.02), State::autonomy);
  EXPECT_EQ(remote.play(1.0, 1.0F, 0.02), State::shared);
  EXPECT_EQ(remote.play(1.9, 1.0F, 0.62), State::lost);
  EXPECT_NE(remote.fault.find("it arrived 0.6 s later than the link needs at best, more than input_timeout (0.5 s)"),
            std::string::npos)
      << remote.fault;
  EXPECT_NE(remote.fault.find("within 0.1 s for 2 s"), std::string::npos) << remote.fault;
  EXPECT_EQ(remote.play(1.0, 1.0F, 0.62), State::lost);  // 2.9 s of it: heard, but to be seen centred once
  EXPECT_EQ(remote.fault, "");
  EXPECT_NE(remote.machine.advice().find("require_neutral"), std::string::npos) << remote.machine.advice();
  EXPECT_NE(remote.machine.advice().find("What comes on joy_topic arrives 0.6 s later than at best"),
            std::string::npos);
  EXPECT_NE(remote.play(0.1, 0.0F, 0.62), State::shared);
  EXPECT_EQ(remote.play(10.0, 1.0F, 0.62), State::shared);
  EXPECT_NEAR(remote.machine.dropped(), 40, 1);  // 2 s at 20 Hz
}

TEST(SlowLink, CountsAtOnceWhereNeutralIsNotRequired) {
  Parameters p;
  p.require_neutral = false;
  Remote remote(p);
  remote.play(1.0, 1.0F, 0.02);
  EXPECT_EQ(remote.play(1.9, 1.0F, 0.62), State::lost);
  EXPECT_EQ(remote.play(0.3, 1.0F, 0.62), State::shared);
}

TEST(SlowLink, BeyondTheMostIsRefusedWithItsDelay) {
  Remote remote;
  remote.play(1.0, 0.0F, 0.02);
  EXPECT_EQ(remote.play(20.0, 1.0F, 1.22), State::autonomy);
  EXPECT_NE(remote.fault.find("it arrived 1.2 s later than the link needs at best, more than input_lag_max (1 s)"),
            std::string::npos)
      << remote.fault;
  EXPECT_NE(remote.machine.advice().find("1.2 s later"), std::string::npos);
  remote.p.input_lag_max = 1.5;
  remote.machine.configure(remote.p);
  remote.play(2.1, 0.0F, 1.22);
  EXPECT_EQ(remote.play(0.1, 1.0F, 1.22), State::shared);
}

TEST(SlowLink, WhileItStillGrowsItIsRefused) {
  Remote remote;
  remote.play(1.0, 0.0F, 0.02);
  // From 0.53 s to 0.98 s more, 0.06 s in a second: never within 0.1 s for 2 s.
  EXPECT_EQ(remote.play(7.5, 1.0F, [](double time) { return 0.55 + 0.06 * time; }), State::autonomy);
  EXPECT_NE(remote.fault, "");
}

TEST(SlowLink, MayBeForbidden) {
  Parameters p;
  p.input_lag_max = 0.0;
  Remote remote(p);
  remote.play(1.0, 0.0F, 0.02);
  EXPECT_EQ(remote.play(0.5, 1.0F, 0.42), State::shared);  // input_timeout allows so much
  EXPECT_EQ(remote.play(20.0, 1.0F, 0.62), State::lost);
  EXPECT_NE(remote.fault.find("more than input_timeout (0.5 s): the link holds messages back, or"), std::string::npos)
      << remote.fault;
}

TEST(SlowLink, ATwistsToo) {
  Parameters p;
  p.twist_topic = "operator_twist";
  Person person(p);
  std::uint32_t refused = 0;
  for (int i = 0; i < 100; ++i) {
    const double sent = 100.0 + kPeriod * i;
    TwistMessage message = twist_at(sent + (i < 20 ? 0.0 : 0.6), 0.0, 0.0);
    message.stamp = sent;
    refused += person.machine.receive(message).empty() ? 0U : 1U;
  }
  EXPECT_NEAR(refused, 40, 1);  // 2 s at 20 Hz
}

}  // namespace
}  // namespace hidwa_local_planner::input
