// SPDX-License-Identifier: BSD-3-Clause
#include "hidwa_local_planner/core/command_history.hpp"

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "hidwa_local_planner/core/archive.hpp"
#include "support/naive_reference.hpp"
#include "support/random.hpp"

namespace hidwa_local_planner {
namespace {

using test::NaiveCycle;
using test::NaiveReference;

constexpr double kPeriod = 0.05;  // [s]

// The defaults, said here since expectations count on them.
Parameters parameters() {
  Parameters p;
  p.acc_lim_x = 2.5;
  p.acc_lim_theta = 3.2;
  p.control_latency = 0.1;
  p.velocity_reference_tolerance_x = 0.2;
  p.velocity_reference_tolerance_theta = 0.5;
  return p;
}

// Cycles at 20 Hz.
class Cycles {
 public:
  explicit Cycles(const Parameters& p = parameters()) : p_(p) {}
  void observe(const Twist2& command) { observe_at(time_ + kPeriod, command); }
  void observe_at(double time, const Twist2& command) {
    time_ = time;
    history_.observe(time, kPeriod, p_.control_latency, command, VelocityLimits::from(p_));
  }
  void ramp(double from, double to, double step) {
    const int steps = static_cast<int>(std::lround((to - from) / step));
    for (int k = 0; k <= steps; ++k) observe({from + k * step, 0.0});
  }
  // Whether odometry that shows this agrees with the last command.
  bool agrees(const Twist2& measured) const {
    const Twist2 reference = velocity_reference(p_, measured, history_);
    EXPECT_TRUE(reference == history_.last() || reference == measured);
    return reference == history_.last();
  }
  bool agrees(double v) const { return agrees(Twist2{v, history_.last().omega}); }
  double time() const { return time_; }
  CommandHistory& history() { return history_; }

 private:
  Parameters p_;
  CommandHistory history_;
  double time_ = 100.0;  // [s]
};

TEST(VelocityReferenceRule, TheOnlyCommandWhileOdometryAgrees) {
  Parameters p = parameters();
  const Twist2 last{0.4, 0.3};
  CommandHistory only;
  only.observe(0.0, kPeriod, p.control_latency, last, VelocityLimits::from(p));
  EXPECT_TRUE(velocity_reference(p, {0.21, 0.3}, only) == last);                 // 0.19 off
  EXPECT_TRUE(velocity_reference(p, {0.19, 0.3}, only) == (Twist2{0.19, 0.3}));  // 0.21 off
  EXPECT_TRUE(velocity_reference(p, {0.4, -0.19}, only) == last);                // 0.49 off
  EXPECT_TRUE(velocity_reference(p, {0.4, -0.21}, only) == (Twist2{0.4, -0.21}));
  p.velocity_reference = VelocityReference::odometry;
  EXPECT_TRUE(velocity_reference(p, {0.39, 0.3}, only) == (Twist2{0.39, 0.3}));
}

TEST(VelocityReferenceRule, AStandingRobotInItsDeadBandAgrees) {
  Parameters p = parameters();
  p.velocity_reference_tolerance_theta = 0.1;
  p.min_in_place_vel_theta = 0.4;
  // Inside the dead band the motors stand: 0 agrees with 0.3. Beyond it the tolerance of 0.1 alone counts.
  for (const double omega : {0.3, 0.5}) {
    Cycles cycles(p);
    cycles.observe({0.0, omega});
    EXPECT_EQ(cycles.agrees({0.0, 0.0}), omega < 0.4);
  }
  p.min_in_place_vel_theta = 0.0;
  Cycles cycles(p);
  cycles.observe({0.0, 0.3});
  EXPECT_FALSE(cycles.agrees({0.0, 0.0}));
}

TEST(VelocityReferenceRule, LatencyExplainsWhatWasCommandedAMomentAgo) {
  Cycles cycles;
  cycles.ramp(0.0, 0.5, 0.125);  // 2.5 * 0.05 a cycle
  // The last command, 0.5, was sent 0.05 s ago; 0.25 was sent 0.15 s ago, a latency and a period: it is in force then.
  EXPECT_TRUE(cycles.agrees(0.25));
  EXPECT_TRUE(cycles.agrees(0.06));   // 0.19 below it
  EXPECT_FALSE(cycles.agrees(0.04));  // 0.21 below it
  EXPECT_TRUE(cycles.agrees(0.69));   // nothing explains that it is faster
  EXPECT_FALSE(cycles.agrees(0.71));
  // Two cycles later 0.5 was in force all the time.
  cycles.observe({0.5, 0.0});
  EXPECT_TRUE(cycles.agrees(0.18));  // 0.375 - 0.195
  cycles.observe({0.5, 0.0});
  EXPECT_FALSE(cycles.agrees(0.29));
  EXPECT_TRUE(cycles.agrees(0.31));
  EXPECT_EQ(cycles.history().size(), 3u);  // sent 0.15, 0.1 and 0.05 s ago
}

TEST(VelocityReferenceRule, BrakingAndTurnsThroughZero) {
  Cycles braking;
  braking.ramp(0.5, 0.0, -0.125);
  EXPECT_TRUE(braking.agrees(0.25));
  EXPECT_TRUE(braking.agrees(0.44));
  EXPECT_FALSE(braking.agrees(0.46));
  EXPECT_FALSE(braking.agrees(-0.21));
  Cycles turning;
  for (const double omega : {0.32, 0.16, 0.0, -0.16}) turning.observe({0.3, omega});  // 3.2 * 0.05 a cycle
  EXPECT_TRUE(turning.agrees({0.3, 0.65}));   // 0.16 + 0.49
  EXPECT_FALSE(turning.agrees({0.3, 0.67}));
  EXPECT_TRUE(turning.agrees({0.3, -0.65}));  // -0.16 - 0.49
  EXPECT_FALSE(turning.agrees({0.3, -0.67}));
}

TEST(VelocityReferenceRule, AJumpThatNoLimitAllowedIsNoLag) {
  Cycles stopped;  // the host set zero
  for (const double v : {0.5, 0.5, 0.0}) stopped.observe({v, 0.0});
  EXPECT_FALSE(stopped.agrees(0.5));
  EXPECT_FALSE(stopped.agrees(0.21));
  EXPECT_TRUE(stopped.agrees(0.19));
  Cycles turned;
  for (const double omega : {1.0, 1.0, 0.0}) turned.observe({0.3, omega});
  EXPECT_FALSE(turned.agrees({0.3, 0.51}));
  // What comes after it can lag again.
  for (const double v : {0.125, 0.25, 0.375}) stopped.observe({v, 0.0});
  EXPECT_TRUE(stopped.agrees(0.0));
}

TEST(VelocityReferenceRule, BrakesMayBeStrongerThanTheMotorThatSpeedsUp) {
  Parameters p = parameters();
  p.decel_lim_x = -5.0;
  Cycles cycles(p);
  for (const double v : {0.5, 0.25, 0.0}) cycles.observe({v, 0.0});  // 5 * 0.05 a cycle
  EXPECT_TRUE(cycles.agrees(0.5));
  p.decel_lim_x = -2.5;
  Cycles weak(p);
  for (const double v : {0.5, 0.25, 0.0}) weak.observe({v, 0.0});
  EXPECT_FALSE(weak.agrees(0.5));
}

TEST(VelocityReferenceRule, AfterAPauseOnlyTheLastCommandCounts) {
  Cycles cycles;
  cycles.ramp(0.0, 0.5, 0.125);
  cycles.observe_at(cycles.time() + 0.2, {0.5, 0.0});  // sent in the cycle before it, all the time in force
  EXPECT_FALSE(cycles.agrees(0.29));
  EXPECT_EQ(cycles.history().size(), 1u);
}

TEST(VelocityReferenceRule, TimeThatGoesBackForgets) {
  Cycles cycles;
  cycles.ramp(0.0, 0.5, 0.125);
  cycles.observe_at(10.0, {0.5, 0.0});
  EXPECT_EQ(cycles.history().size(), 1u);
  EXPECT_FALSE(cycles.agrees(0.29));
}

TEST(VelocityReferenceRule, ASecondCycleOfTheSameTimeTakesThePlaceOfTheFirst) {
  Cycles cycles;
  for (const double v : {0.25, 0.375, 0.5}) cycles.observe({v, 0.0});
  const std::size_t size = cycles.history().size();
  cycles.observe_at(cycles.time(), {0.5, 0.0});
  EXPECT_EQ(cycles.history().size(), size);
  EXPECT_TRUE(cycles.agrees(0.06));  // 0.25 - 0.19
  cycles.observe_at(cycles.time(), {0.375, 0.0});
  EXPECT_FALSE(cycles.agrees(0.6));  // 0.375 + 0.225: 0.5 was never sent
  // A time that stands still: each is the first.
  Cycles still;
  for (const double v : {0.0, 0.125, 0.25, 0.375}) still.observe_at(1.0, {v, 0.0});
  EXPECT_EQ(still.history().size(), 1u);
  EXPECT_FALSE(still.agrees(0.17));
}

TEST(VelocityReferenceRule, TimesThatAreNoNumbersLeaveTheLastCommandOnly) {
  Cycles cycles;
  cycles.ramp(0.0, 0.5, 0.125);
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
                           -std::numeric_limits<double>::infinity()}) {
    Cycles after = cycles;
    after.observe_at(bad, {0.5, 0.0});
    EXPECT_EQ(after.history().size(), 1u) << bad;
    EXPECT_FALSE(after.agrees(0.29)) << bad;
    after.observe_at(cycles.time() + kPeriod, {0.5, 0.0});
    EXPECT_EQ(after.history().size(), 1u) << bad;
    EXPECT_TRUE(after.history().last() == (Twist2{0.5, 0.0})) << bad;
    for (const double v : {0.375, 0.25, 0.125}) after.observe({v, 0.0});
    EXPECT_TRUE(after.agrees(0.5)) << bad;
  }
}

TEST(CommandHistory, KeepsNoMoreThanItHasRoomFor) {
  Cycles cycles;
  CommandHistory& history = cycles.history();
  const VelocityLimits limits = VelocityLimits::from(parameters());
  for (int k = 0; k < 1000; ++k) history.observe(0.001 * k, 0.001, 2.0, {1e-4 * k, 0.0}, limits);
  EXPECT_EQ(history.size(), 256u);
  EXPECT_NEAR(history.range(&Twist2::v).lo, 1e-4 * (1000 - 256), 1e-12);
  EXPECT_NEAR(history.range(&Twist2::v).hi, 1e-4 * 999, 1e-12);
}

// From the last of these commands at 20 Hz on.
UnderWay played(const std::vector<double>& commands, double latency) {
  Parameters p = parameters();
  p.control_latency = latency;
  Cycles cycles(p);
  for (const double v : commands) cycles.observe({v, 0.0});
  UnderWay under_way;
  cycles.history().play(VelocityLimits::from(p), kPeriod, latency, under_way);
  return under_way;
}

void expect_legs(const UnderWay& under_way, double begin, const std::vector<std::pair<double, double>>& legs) {
  EXPECT_NEAR(under_way.begin().v, begin, 1e-9);
  ASSERT_EQ(under_way.legs().size(), legs.size());
  for (std::size_t i = 0; i < legs.size(); ++i) {
    EXPECT_NEAR(under_way.legs()[i].duration, legs[i].first, 1e-9) << i;
    EXPECT_NEAR(under_way.legs()[i].end.v, legs[i].second, 1e-9) << i;
  }
}

TEST(Play, OneCommandForLongIsOneLegOfTheLatency) {
  const UnderWay steady = played({0.3, 0.3, 0.3, 0.3, 0.3, 0.3}, 0.1);
  ASSERT_EQ(steady.legs().size(), 1u);
  EXPECT_EQ(steady.begin().v, 0.3);
  EXPECT_EQ(steady.legs()[0].end.v, 0.3);
  EXPECT_EQ(steady.legs()[0].duration, 0.1);
  EXPECT_EQ(played({0.3}, 0.1).legs()[0].duration, 0.1);
}

TEST(Play, EachCommandTakesEffectALatencyAfterItWasSent) {
  // The last but one takes effect now, the last one period later.
  expect_legs(played({0.5, 0.5, 0.5, 0.375, 0.25}, 0.1), 0.5, {{0.05, 0.375}, {0.05, 0.25}});
  // Back at the start there are those that have been reached: 0.5 was sent three cycles ago.
  expect_legs(played({0.125, 0.25, 0.375, 0.5, 0.375, 0.25}, 0.1), 0.5, {{0.05, 0.375}, {0.05, 0.25}});
  expect_legs(played({0.5, 0.5, 0.375, 0.375}, 0.1), 0.5, {{0.05, 0.375}, {0.05, 0.375}});
  expect_legs(played({0.5, 0.5, 0.5, 0.375}, 0.0), 0.375, {});
}

TEST(Play, ALatencyBetweenTwoCycles) {
  // The command of three cycles ago took effect 0.15 - 0.12 = 0.03 s ago: 3/5 of the way from 0.5 to 0.375.
  expect_legs(played({0.5, 0.5, 0.375, 0.25, 0.125}, 0.12), 0.425, {{0.02, 0.375}, {0.05, 0.25}, {0.05, 0.125}});
}

TEST(Play, SpeedingUpTakesAsLongAsTheLimitSays) {
  // 0.05 m/s at 2.5 m/s^2 take 0.02 s.
  expect_legs(played({0.3, 0.3, 0.3, 0.35, 0.35}, 0.1), 0.3, {{0.02, 0.35}, {0.08, 0.35}});
}

TEST(Play, ACycleThatComesEarlyLeavesItsCommandLessTime) {
  Cycles cycles;
  for (int k = 0; k < 5; ++k) cycles.observe({0.5, 0.0});
  cycles.observe({0.375, 0.0});                          // sent 0.08 s before the end
  cycles.observe_at(cycles.time() + 0.03, {0.25, 0.0});  // sent 0.03 s before
  UnderWay under_way;
  cycles.history().play(VelocityLimits::from(parameters()), kPeriod, 0.1, under_way);
  expect_legs(under_way, 0.5, {{0.02, 0.5}, {0.05, 0.375}, {0.03, 0.25}});
}

TEST(Play, NothingIsSaidOfNothing) {
  UnderWay under_way({1.0, 1.0}, 1.0);
  CommandHistory().play(VelocityLimits::from(parameters()), kPeriod, 0.1, under_way);
  expect_legs(under_way, 0.0, {{0.1, 0.0}});
}

TEST(Play, AsManyLegsAsThereMayBeHaveRoom) {
  const VelocityLimits limits = VelocityLimits::from(parameters());
  CommandHistory history;
  UnderWay under_way;
  const UnderWay::Leg* const memory = under_way.legs().data();
  // Each command's two axes are reached at times of their own.
  for (int k = 0; k < 600; ++k) {
    history.observe(0.005 * k, 0.005, 2.0, {k % 2 > 0 ? 1e-3 : -1e-3, k % 2 > 0 ? 2e-3 : -2e-3}, limits);
    history.play(limits, 0.005, 2.0, under_way);
  }
  EXPECT_GT(under_way.legs().size(), 750u);
  EXPECT_LE(under_way.legs().size(), UnderWay::kMostLegs);
  EXPECT_EQ(under_way.legs().data(), memory);
}

Twist2 velocity_at(const UnderWay& under_way, double t) {
  Twist2 from = under_way.begin();
  for (const UnderWay::Leg& leg : under_way.legs()) {
    if (t <= leg.duration) {
      const double part = t / leg.duration;
      return {from.v + part * (leg.end.v - from.v), from.omega + part * (leg.end.omega - from.omega)};
    }
    t -= leg.duration;
    from = leg.end;
  }
  return from;
}

void compare_play(const CommandHistory& history, const NaiveReference& twin, const Parameters& p, double period,
                  test::Random& random) {
  UnderWay under_way;
  history.play(VelocityLimits::from(p), period, p.control_latency, under_way);
  // By the time the next command takes effect, the last one is reached.
  const test::NaiveEffects effects = test::NaiveEffects(p, period, twin.effects()).then(p.control_latency, {});
  for (int m = 0; m < 5; ++m) {
    const double t = random.uniform(0.0, p.control_latency);
    ASSERT_NEAR(velocity_at(under_way, t).v, effects.velocity(t).v, 1e-4) << t;
    ASSERT_NEAR(velocity_at(under_way, t).omega, effects.velocity(t).omega, 1e-4) << t;
  }
  ASSERT_TRUE(under_way.end() == history.last());
}

struct Checked {
  int agreed = 0, lagged = 0, refused = 0, broken = 0;
};

// Commands that mostly keep the limits and sometimes jump, cycles that are early, late, repeated or back in time, and
// odometry that shows anything between a former command and nonsense.
void compare_with_twin(std::uint64_t seed, Checked& checked) {
  test::Random random(seed);
  Parameters p = parameters();
  p.acc_lim_x = random.uniform(0.5, 10.0);
  p.decel_lim_x = random.chance(0.5) ? 0.0 : random.uniform(0.5, 10.0);
  p.acc_lim_theta = random.uniform(0.5, 20.0);
  p.control_latency = random.chance(0.2) ? 0.0 : random.uniform(0.0, 0.3);
  p.min_vel_theta = random.chance(0.5) ? 0.0 : random.uniform(0.0, 0.4);
  const VelocityLimits limits = VelocityLimits::from(p);
  const double period = random.pick({0.04, 0.05, 0.1});
  CommandHistory history;
  std::vector<NaiveCycle> cycles{{random.uniform(0.0, 1e9), period, {}}};
  for (int k = 0; k < 80; ++k) {
    NaiveCycle cycle = cycles.back();
    if (k > 0) {
      cycle.time += random.chance(0.8) ? period : random.pick({0.0, 0.5 * period, 1.7 * period, 6.0 * period});
      if (random.chance(0.02)) cycle.time -= random.uniform(0.0, 5.0);
      cycle.last_command = limits.step(cycle.last_command, {random.uniform(-2.0, 2.0), random.uniform(-4.0, 4.0)}, period);
      if (random.chance(0.05)) cycle.last_command = {random.uniform(-1.0, 1.0), random.uniform(-2.0, 2.0)};
      cycles.push_back(cycle);
    }
    history.observe(cycle.time, period, p.control_latency, cycle.last_command, limits);
    const NaiveReference twin(p, cycles);
    ASSERT_EQ(history.size(), twin.shown().size()) << k;
    checked.broken += k > 0 && history.size() == 1;
    compare_play(history, twin, p, period, random);
    for (int m = 0; m < 5; ++m) {
      Twist2 measured = cycles[cycles.size() - 1 - static_cast<std::size_t>(random.integer(0, std::min(k, 6)))].last_command;
      measured.v += random.uniform(-0.3, 0.3);
      measured.omega += random.uniform(-0.6, 0.6);
      const Twist2 reference = velocity_reference(p, measured, history);
      ASSERT_TRUE(reference == twin.of(measured)) << k;
      const bool agreed = reference == cycle.last_command;
      checked.agreed += agreed;
      checked.refused += !agreed;
      checked.lagged += agreed && std::abs(measured.v - reference.v) > p.velocity_reference_tolerance_x;
    }
  }
}

TEST(CommandHistory, IsAsTheTwinThatSearchesAllThereEverWas) {
  Checked checked;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE(seed);
    compare_with_twin(seed, checked);
    if (testing::Test::HasFatalFailure()) return;
  }
  EXPECT_GT(checked.agreed, 10000);
  EXPECT_GT(checked.lagged, 5000);
  EXPECT_GT(checked.refused, 10000);
  EXPECT_GT(checked.broken, 1000);
}

TEST(CommandHistory, SavedAndLoadedItGoesOnToTheSameBits) {
  Cycles cycles;
  cycles.ramp(0.0, 0.375, 0.125);
  Bytes bytes;
  ArchiveWriter write(bytes);
  write(cycles.history());
  CommandHistory loaded;
  loaded.observe(1e9, kPeriod, 0.1, {0.3, 1.0}, VelocityLimits::from(parameters()));  // gone once it is loaded
  ArchiveReader read(bytes);
  read(loaded);
  EXPECT_TRUE(read.complete());
  EXPECT_EQ(loaded.size(), cycles.history().size());
  cycles.observe({0.5, 0.0});
  loaded.observe(cycles.time(), kPeriod, 0.1, {0.5, 0.0}, VelocityLimits::from(parameters()));
  Bytes one, two;
  ArchiveWriter write_one(one), write_two(two);
  write_one(cycles.history());
  write_two(loaded);
  EXPECT_EQ(one, two);
  EXPECT_EQ(loaded.range(&Twist2::v).lo, 0.25);
  EXPECT_EQ(loaded.range(&Twist2::v).hi, 0.5);
}

}  // namespace
}  // namespace hidwa_local_planner
