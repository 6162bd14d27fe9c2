// SPDX-License-Identifier: BSD-3-Clause
#include "core/motion/command_history.hpp"

#include <cmath>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "hidwa_local_planner/core/util/archive.hpp"
#include "support/naive_reference.hpp"
#include "support/random.hpp"

namespace hidwa_local_planner {
namespace {

using test::NaiveCycle;
using test::NaiveHistory;

constexpr double kPeriod = 0.05;  // [s]

// The defaults, said here since expectations count on them.
Parameters parameters() {
  Parameters p;
  p.acc_lim_x = 2.5;
  p.acc_lim_theta = 3.2;
  p.control_latency = 0.1;
  return p;
}

// Cycles at 20 Hz.
class Cycles {
 public:
  explicit Cycles(const Parameters& p = parameters()) : p_(p) {}
  void observe(const Twist2& command) { observe_at(time_ + kPeriod, command); }
  void observe_at(double time, const Twist2& command) {
    time_ = time;
    history_.observe(time, kPeriod, p_.control_latency + kPeriod, command, limits());
  }
  void ramp(double from, double to, double step) {
    const int steps = static_cast<int>(std::lround((to - from) / step));
    for (int k = 0; k <= steps; ++k) observe({from + k * step, 0.0});
  }
  // All that odometry may show, of v [m/s].
  Interval range() const { return history_.range(&Twist2::v); }
  VelocityLimits limits() const { return VelocityLimits::from(p_); }
  double time() const { return time_; }
  CommandHistory& history() { return history_; }

 private:
  Parameters p_;
  CommandHistory history_;
  double time_ = 100.0;  // [s]
};

void expect_range(const Interval& range, double lo, double hi) {
  EXPECT_NEAR(range.lo, lo, 1e-9);
  EXPECT_NEAR(range.hi, hi, 1e-9);
}

TEST(ShownByOdometry, BeforeTheFirstCycleRest) {
  Cycles cycles;
  expect_range(cycles.range(), 0.0, 0.0);
  EXPECT_EQ(cycles.history().elapsed(), 0.0);
}

TEST(CommandHistory, TimesThatAreNoNumbersLeaveTheLastCommandOnly) {
  Cycles cycles;
  cycles.ramp(0.0, 0.5, 0.125);
  for (const double bad : {NAN, INFINITY, -INFINITY}) {
    Cycles after = cycles;
    after.observe_at(bad, {0.5, 0.0});
    EXPECT_EQ(after.history().size(), 1u) << bad;
    after.observe_at(cycles.time() + kPeriod, {0.5, 0.0});
    EXPECT_EQ(after.history().size(), 1u) << bad;
    expect_range(after.range(), 0.5, 0.5);
    for (const double v : {0.375, 0.25, 0.125}) after.observe({v, 0.0});
    expect_range(after.range(), 0.125, 0.5);
  }
}

TEST(CommandHistory, KeepsNoMoreThanItHasRoomFor) {
  Cycles cycles;
  CommandHistory& history = cycles.history();
  const VelocityLimits limits = VelocityLimits::from(parameters());
  for (int k = 0; k < 1000; ++k) history.observe(0.001 * k, 0.001, 2.001, {1e-4 * k, 0.0}, limits);
  EXPECT_EQ(history.size(), 256u);
  EXPECT_NEAR(history.range(&Twist2::v).lo, 1e-4 * (1000 - 257), 1e-12);  // the oldest that is left started from it
  EXPECT_NEAR(history.range(&Twist2::v).hi, 1e-4 * 999, 1e-12);
}

// From `age` [s] before the last of these commands at 20 Hz on.
PendingMotion played(const std::vector<double>& commands, double latency, double age = 0.0) {
  Parameters p = parameters();
  p.control_latency = latency + age;  // for so long they are remembered
  Cycles cycles(p);
  for (const double v : commands) cycles.observe({v, 0.0});
  PendingMotion pending;
  cycles.history().play(cycles.limits(), kPeriod, latency, age, pending);
  return pending;
}

void expect_legs(const PendingMotion& pending, double begin, const std::vector<std::pair<double, double>>& legs) {
  EXPECT_NEAR(pending.begin().v, begin, 1e-9);
  ASSERT_EQ(pending.legs().size(), legs.size());
  for (std::size_t i = 0; i < legs.size(); ++i) {
    EXPECT_NEAR(pending.legs()[i].duration, legs[i].first, 1e-9) << i;
    EXPECT_NEAR(pending.legs()[i].end.v, legs[i].second, 1e-9) << i;
  }
}

struct Played {
  const char* of;
  std::vector<double> commands;  // [m/s]
  double latency, age;           // [s]
  double begin;                  // [m/s]
  std::vector<std::pair<double, double>> legs;
};

// A leg is its duration [s] and its final velocity [m/s]. The limit is 2.5 * 0.05 = 0.125 m/s a cycle.
TEST(Play, EachCommandTakesEffectALatencyAfterItWasSent) {
  for (const Played& row :
       {Played{"one command for long is one leg", {0.3, 0.3, 0.3, 0.3}, 0.1, 0.0, 0.3, {{0.1, 0.3}}},
        Played{"the first command of all", {0.3}, 0.1, 0.0, 0.3, {{0.1, 0.3}}},
        Played{"without latency nothing is pending", {0.5, 0.5, 0.5, 0.375}, 0.0, 0.0, 0.375, {}},
        // The last but one takes effect now, the last one period later.
        Played{"two commands", {0.5, 0.5, 0.5, 0.375, 0.25}, 0.1, 0.0, 0.5, {{0.05, 0.375}, {0.05, 0.25}}},
        // That of three cycles ago took effect 0.15 - 0.12 = 0.03 s ago: 3/5 of the way from 0.5 to 0.375.
        Played{"a latency between two cycles",
               {0.5, 0.5, 0.375, 0.25, 0.125},
               0.12,
               0.0,
               0.425,
               {{0.02, 0.375}, {0.05, 0.25}, {0.05, 0.125}}},
        // 0.05 m/s at 2.5 m/s^2 take 0.02 s.
        Played{"faster", {0.3, 0.3, 0.3, 0.35, 0.35}, 0.1, 0.0, 0.3, {{0.02, 0.35}, {0.08, 0.35}}},
        Played{"a jump", {0.5, 0.5, 0.5, 0.0, 0.0}, 0.1, 0.0, 0.5, {{0.05, 0.375}, {0.05, 0.25}}},
        // 0.375 took effect 0.05 s ago, 0.25 takes effect now.
        Played{"from 0.1 s ago on",
               {0.5, 0.5, 0.5, 0.5, 0.375, 0.25},
               0.05,
               0.1,
               0.5,
               {{0.05, 0.5}, {0.05, 0.375}, {0.05, 0.25}}}}) {
    SCOPED_TRACE(row.of);
    expect_legs(played(row.commands, row.latency, row.age), row.begin, row.legs);
  }
}

TEST(Play, NothingIsSaidOfNothing) {
  PendingMotion pending({1.0, 1.0}, 1.0);
  CommandHistory().play(VelocityLimits::from(parameters()), kPeriod, 0.1, 0.0, pending);
  expect_legs(pending, 0.0, {{0.1, 0.0}});
}

TEST(Play, SaysHowFarApartTheWaysGet) {
  // From 0.3 to 0.35: at 2.5 m/s^2 in 0.02 s, or evenly in 0.05 s: 0.05 * (0.05 - 0.02) / 2 = 0.75 mm apart.
  const PendingMotion faster = played({0.3, 0.3, 0.3, 0.35, 0.35}, 0.1);
  EXPECT_NEAR(faster.spread().v, 0.00075, 1e-9);
  EXPECT_NEAR(faster.legs()[0].spread.v, 0.00075, 1e-9);
  EXPECT_EQ(faster.spread().omega, 0.0);
  // As fast as it can there is but one way.
  EXPECT_EQ(played({0.5, 0.5, 0.5, 0.375, 0.25}, 0.1).spread().v, 0.0);
}

TEST(Play, AsManyLegsAsThereMayBeHaveRoom) {
  const VelocityLimits limits = VelocityLimits::from(parameters());
  CommandHistory history;
  PendingMotion pending;
  const PendingMotion::Leg* const memory = pending.legs().data();
  // Each command has both axes stop and turn round at times of their own, the latest 7 ms after it takes effect, and is
  // cut short by none: 2 * 7.5e-3 / 2.5 = 6 ms, 2 * 11.2e-3 / 3.2 = 7 ms.
  for (int k = 0; k < 600; ++k) {
    const double sign = k % 2 > 0 ? 1.0 : -1.0;
    history.observe(0.0078 * k, 0.005, 2.005, {sign * 7.5e-3, sign * 11.2e-3}, limits);
    history.play(limits, 0.005, 2.0, 0.0, pending);
  }
  EXPECT_GT(pending.legs().size(), 5u * 250u);
  EXPECT_LE(pending.legs().size(), PendingMotion::kMostLegs);
  EXPECT_EQ(pending.legs().data(), memory);
}

Twist2 velocity_at(const PendingMotion& pending, double t) {
  Twist2 from = pending.begin();
  for (const PendingMotion::Leg& leg : pending.legs()) {
    if (t <= leg.duration) {
      const double part = t / leg.duration;
      return {from.v + part * (leg.end.v - from.v), from.omega + part * (leg.end.omega - from.omega)};
    }
    t -= leg.duration;
    from = leg.end;
  }
  return from;
}

// Times up to 1e4 s are rounded to 1e-12 s; the twin takes times within 1e-6 s for one.
constexpr double kRounding = 1e-5;  // [m/s, rad/s, m, rad]

void compare_play(const CommandHistory& history, const NaiveHistory& twin, const Parameters& p, double age,
                  double period, test::Random& random) {
  PendingMotion pending;
  history.play(VelocityLimits::from(p), period, p.control_latency, age, pending);
  for (int m = 0; m < 5; ++m) {
    const double t = random.uniform(-age, p.control_latency);
    ASSERT_NEAR(velocity_at(pending, t + age).v, twin.effects().velocity(t).v, 1e-4) << t;
    ASSERT_NEAR(velocity_at(pending, t + age).omega, twin.effects().velocity(t).omega, 1e-4) << t;
  }
  Twist2 spread;
  for (const test::NaiveLeg& leg : test::naive_legs(twin.effects(), -age, p.control_latency)) {
    spread.v += leg.spread.v;
    spread.omega += leg.spread.omega;
  }
  ASSERT_NEAR(pending.spread().v, spread.v, kRounding);
  ASSERT_NEAR(pending.spread().omega, spread.omega, kRounding);
}

struct Checked {
  int lagging = 0, unreached = 0, begun_anew = 0, ways = 0;
};

// Commands that mostly keep the limits and sometimes jump, cycles that are early, late, repeated or back in time.
void compare_with_twin(std::uint64_t seed, Checked& checked) {
  test::Random random(seed);
  Parameters p = parameters();
  p.acc_lim_x = random.uniform(0.5, 10.0);
  p.decel_lim_x = random.chance(0.5) ? 0.0 : random.uniform(-10.0, -0.5);
  p.acc_lim_theta = random.uniform(0.5, 20.0);
  p.control_latency = random.chance(0.2) ? 0.0 : random.uniform(0.01, 0.3);
  const double age = random.chance(0.5) ? 0.0 : random.uniform(0.01, 0.2);
  const VelocityLimits limits = VelocityLimits::from(p);
  const double period = random.pick({0.04, 0.05, 0.1});
  CommandHistory history;
  double apart = 0.0;  // the last two cycles at different times [s]
  std::vector<NaiveCycle> cycles{{random.uniform(0.0, 1e4), period, {}, {}, age}};
  for (int k = 0; k < 80; ++k) {
    NaiveCycle cycle = cycles.back();
    if (k > 0) {
      cycle.time += random.chance(0.8) ? period : random.pick({0.0, 0.45 * period, 1.7 * period, 6.0 * period});
      if (random.chance(0.02)) cycle.time -= random.uniform(0.0, 5.0);
      const double passed = cycle.time - cycles.back().time;
      if (passed != 0.0) apart = passed < 0.0 ? period : passed;
      // Not all that a period allows: at exactly that, rounding decides how the twin and the history take it.
      const double elapsed = random.uniform(0.5, 0.99) * period;
      cycle.last_command =
          limits.step(cycle.last_command, {random.uniform(-2.0, 2.0), random.uniform(-4.0, 4.0)}, elapsed);
      if (random.chance(0.05)) cycle.last_command = {random.uniform(-1.0, 1.0), random.uniform(-2.0, 2.0)};
      cycles.push_back(cycle);
    }
    history.observe(cycle.time, period, p.control_latency + period + age, cycle.last_command, limits);
    const NaiveHistory twin(p, cycles);
    ASSERT_EQ(history.size(), twin.shown()) << k;
    ASSERT_NEAR(history.elapsed(), apart, 1e-9) << k;
    checked.begun_anew += k > 0 && history.size() == 1;
    for (double Twist2::*axis : {&Twist2::v, &Twist2::omega}) {
      ASSERT_NEAR(history.range(axis).lo, twin.explained(axis).lo, kRounding) << k;
      ASSERT_NEAR(history.range(axis).hi, twin.explained(axis).hi, kRounding) << k;
    }
    compare_play(history, twin, p, age, period, random);
    checked.lagging += history.range(&Twist2::v).hi - history.range(&Twist2::v).lo > 0.2;
    checked.unreached += std::abs(twin.effects().velocity(p.control_latency).v - cycle.last_command.v) > 1e-3;
    checked.ways += test::naive_legs(twin.effects(), -age, p.control_latency).size() > 3;
    if (testing::Test::HasFatalFailure()) return;
  }
}

TEST(CommandHistory, IsAsTheTwinThatSearchesAllThereEverWas) {
  Checked checked;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE(seed);
    compare_with_twin(seed, checked);
    if (testing::Test::HasFatalFailure()) return;
  }
  EXPECT_GT(checked.lagging, 5000);
  EXPECT_GT(checked.unreached, 500);
  EXPECT_GT(checked.begun_anew, 500);
  EXPECT_GT(checked.ways, 5000);
}

TEST(CommandHistory, SavedAndLoadedItGoesOnToTheSameBits) {
  Cycles cycles;
  cycles.ramp(0.0, 0.375, 0.125);
  Bytes bytes;
  ArchiveWriter write(bytes);
  write(cycles.history());
  CommandHistory loaded;
  loaded.observe(1e9, kPeriod, 0.15, {0.3, 1.0}, VelocityLimits::from(parameters()));  // gone once it is loaded
  ArchiveReader read(bytes);
  read(loaded);
  EXPECT_TRUE(read.complete());
  EXPECT_EQ(loaded.size(), cycles.history().size());
  cycles.observe({0.5, 0.0});
  loaded.observe(cycles.time(), kPeriod, 0.15, {0.5, 0.0}, VelocityLimits::from(parameters()));
  Bytes one, two;
  ArchiveWriter write_one(one), write_two(two);
  write_one(cycles.history());
  write_two(loaded);
  EXPECT_EQ(one, two);
  expect_range(loaded.range(&Twist2::v), 0.125, 0.5);
}

}  // namespace
}  // namespace hidwa_local_planner
