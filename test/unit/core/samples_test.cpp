// SPDX-License-Identifier: BSD-3-Clause
#include "core/motion/samples.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "support/random.hpp"

namespace hidwa_local_planner {
namespace {

struct Request : SampleRequest {
  Twist2 reference;  // [m/s, rad/s]
};

std::vector<Sample> make(const Parameters& p, const Request& request) {
  CycleStart start;
  start.reference = request.reference;
  Sampler sampler;
  sampler.make(p, VelocityLimits::from(p), start, request);
  return sampler.samples();
}

Parameters plain() {
  Parameters p;
  p.method = Method::paper;
  p.admissibility = Admissibility::horizon;
  return p;
}

Request driving(double v, double omega, int vx = 20, int vth = 20) {
  Request request;
  request.reference = request.previous = {v, omega};
  request.vx_samples = vx;
  request.vth_samples = vth;
  return request;
}

bool contains(const std::vector<Sample>& samples, const Twist2& u, SampleKind kind) {
  return std::any_of(samples.begin(), samples.end(), [&](const Sample& s) { return s.u == u && s.kind == kind; });
}

TEST(Spread, EvenlyWithBothEndsAndAnExactZero) {
  std::vector<double> values;
  spread({-1.0, 1.0}, 4, values);
  ASSERT_EQ(values.size(), 5u);  // -1, -1/3, (0), 1/3, 1
  EXPECT_EQ(values[0], -1.0);
  EXPECT_DOUBLE_EQ(values[1], -1.0 / 3.0);
  EXPECT_EQ(values[2], 0.0);
  EXPECT_DOUBLE_EQ(values[3], 1.0 / 3.0);
  EXPECT_EQ(values[4], 1.0);
  spread({-1.0, 1.0}, 5, values);  // hits 0 by itself: not twice
  EXPECT_EQ(values.size(), 5u);
  EXPECT_EQ(values[2], 0.0);
  spread({0.0, 0.5}, 3, values);  // 0 is an end
  EXPECT_EQ(values, (std::vector<double>{0.0, 0.25, 0.5}));
  spread({0.3, 0.3}, 7, values);
  EXPECT_EQ(values, (std::vector<double>{0.3}));
}

TEST(Spread, MirroredIntervalsGiveMirroredValuesToTheBit) {
  test::Random random(4);
  std::vector<double> left, right;
  for (int k = 0; k < 2000; ++k) {
    const double a = random.uniform(-3.0, 3.0), b = random.uniform(-3.0, 3.0);
    const int count = random.integer(2, 40);
    spread({std::min(a, b), std::max(a, b)}, count, right);
    spread({-std::max(a, b), -std::min(a, b)}, count, left);
    ASSERT_EQ(left.size(), right.size());
    for (std::size_t i = 0; i < left.size(); ++i) ASSERT_EQ(left[i], -right[right.size() - 1 - i]);
    ASSERT_TRUE(std::is_sorted(right.begin(), right.end()));
    ASSERT_EQ(std::adjacent_find(right.begin(), right.end()), right.end());  // nothing twice
    const bool straddles = a * b < 0.0;
    ASSERT_TRUE(!straddles || std::binary_search(right.begin(), right.end(), 0.0));
  }
}

TEST(Window, StandardReachesAsFarAsTheHorizonDwaAsOnePeriod) {
  Parameters p;
  p.sim_time = 1.7;
  p.max_vel_x = 5.0;
  p.max_vel_theta = 9.0;
  p.decel_lim_x = 1.0;
  const VelocityLimits limits = VelocityLimits::from(p);
  // 1.7 s: v to 0.5 + 2.5 * 1.7 = 4.75, down past 0 to the limit; omega 0.2 +- 3.2 * 1.7 = 5.44.
  const DynamicWindow standard = dynamic_window(p, limits, {0.5, 0.2}, 0.05);
  EXPECT_DOUBLE_EQ(standard.v.hi, 4.75);
  EXPECT_EQ(standard.v.lo, 0.0);
  EXPECT_DOUBLE_EQ(standard.omega.hi, 5.64);
  p.generator = Generator::dwa;
  const DynamicWindow dwa = dynamic_window(p, limits, {0.5, 0.2}, 0.05);
  EXPECT_DOUBLE_EQ(dwa.v.lo, 0.45);  // 0.5 - 1.0 * 0.05
  EXPECT_DOUBLE_EQ(dwa.v.hi, 0.625);
  EXPECT_DOUBLE_EQ(dwa.omega.lo, 0.04);
  EXPECT_DOUBLE_EQ(dwa.omega.hi, 0.36);
}

TEST(Window, IsNoShorterThanAPeriod) {
  Parameters p;
  p.sim_time = 0.1;
  p.max_vel_theta = 0.3;  // lowered while the robot turns
  const VelocityLimits limits = VelocityLimits::from(p);
  const DynamicWindow window = dynamic_window(p, limits, {0.0, 0.987}, 0.2);
  EXPECT_DOUBLE_EQ(window.omega.lo, 0.987 - 3.2 * 0.2);
  EXPECT_DOUBLE_EQ(window.omega.hi, 0.987 - 3.2 * 0.2);
  EXPECT_DOUBLE_EQ(dynamic_window(p, limits, {0.0, -0.987}, 0.2).omega.hi, -(0.987 - 3.2 * 0.2));
  p.sim_time = 0.2;  // as long as the period
  EXPECT_DOUBLE_EQ(dynamic_window(p, limits, {0.0, 0.987}, 0.2).omega.lo, 0.987 - 3.2 * 0.2);
  p.sim_time = 0.25;  // 0.987 - 3.2 * 0.25 is less than the limit
  EXPECT_DOUBLE_EQ(dynamic_window(p, limits, {0.0, 0.987}, 0.2).omega.hi, 0.3);
}

TEST(Grid, ThePapersGridHas419Samples) {
  // 20 speeds x (20 turns and an exact 0), without (0, 0).
  const std::vector<Sample> samples = make(plain(), driving(0.5, 0.0));
  EXPECT_EQ(samples.size(), 419u);
  EXPECT_FALSE(contains(samples, {0.0, 0.0}, SampleKind::grid));
  EXPECT_TRUE(contains(samples, {0.5, 0.0}, SampleKind::grid));
  EXPECT_TRUE(contains(samples, {0.0, -1.0}, SampleKind::grid));
  EXPECT_TRUE(contains(samples, {0.5, 1.0}, SampleKind::grid));
}

TEST(Grid, GroupedByOmegaAscendingWithSpeedsAscending) {
  const std::vector<Sample> samples = make(plain(), driving(0.5, 0.3, 7, 8));
  for (std::size_t i = 1; i < samples.size(); ++i) {
    const Twist2& a = samples[i - 1].u;
    const Twist2& b = samples[i].u;
    EXPECT_TRUE(a.omega < b.omega || (a.omega == b.omega && a.v < b.v));
  }
}

TEST(Grid, ReverseWhereAllowed) {
  Parameters p = plain();
  p.min_vel_x = -0.2;
  const std::vector<Sample> samples = make(p, driving(0.0, 0.0, 8, 3));
  // v: -0.2, -0.1, 0, 0.1 ... 0.5 (8 values); omega -1, 0, 1: 24 without (0, 0).
  EXPECT_EQ(samples.size(), 23u);
  EXPECT_TRUE(contains(samples, {-0.2, 1.0}, SampleKind::grid));
}

TEST(Grid, WheelsCutTheCorners) {
  Parameters p = plain();
  p.wheel_separation = 0.4;
  p.max_wheel_speed = 0.5;
  const std::vector<Sample> samples = make(p, driving(0.5, 0.0, 6, 5));
  // |v| + 0.2 |omega| <= 0.5 with v in {0, .1, .. .5}: omega 0: 5 without (0, 0); +-0.5: v <= 0.4: 5 each;
  // +-1: v <= 0.3: 4 each. 5 + 10 + 8.
  EXPECT_EQ(samples.size(), 23u);
  EXPECT_TRUE(contains(samples, {0.5, 0.0}, SampleKind::grid));
  EXPECT_FALSE(contains(samples, {0.5, 0.5}, SampleKind::grid));
}

TEST(DeadBand, SlowTurnsAreNotCommanded) {
  Parameters p = plain();
  p.min_vel_theta = 0.3;
  const std::vector<Sample> samples = make(p, driving(0.5, 0.0, 3, 9));
  // omega: -1, -.75, -.5, (-.25), 0, (.25), .5, .75, 1: seven of them; v 0, .25, .5; on the spot only
  // min_in_place_vel_theta (0) counts: 7 * 3 - (0, 0) + 2 on the spot.
  EXPECT_EQ(samples.size(), 22u);
  EXPECT_FALSE(contains(samples, {0.5, 0.25}, SampleKind::grid));
  EXPECT_TRUE(contains(samples, {0.0, 0.25}, SampleKind::grid));
  EXPECT_TRUE(contains(samples, {0.5, 0.0}, SampleKind::grid));
}

TEST(DeadBand, OnTheSpotHasItsOwnAndItsEdgesAreAlwaysTried) {
  Parameters p = plain();
  p.min_in_place_vel_theta = 0.4;
  p.generator = Generator::dwa;
  // At rest the window is +-3.2 * 0.05 = 0.16, all of it inside the band on the spot.
  const std::vector<Sample> samples = make(p, driving(0.0, 0.0, 2, 2));
  EXPECT_TRUE(contains(samples, {0.0, 0.4}, SampleKind::grid));
  EXPECT_TRUE(contains(samples, {0.0, -0.4}, SampleKind::grid));
  EXPECT_TRUE(contains(samples, {2.5 * 0.05, 3.2 * 0.05}, SampleKind::grid));  // while driving there is no band
  for (const Sample& sample : samples) {
    const bool turns_on_the_spot = std::abs(sample.u.v) < 0.01 && sample.u.omega != 0.0;
    EXPECT_TRUE(!turns_on_the_spot || std::abs(sample.u.omega) >= 0.4) << sample.u.omega;
  }
}

TEST(ExtraSamples, ThePapersMethodHasNoneButToBrake) {
  Parameters p = plain();
  Request request = driving(0.3, 0.1, 3, 3);
  request.previous = {0.31, 0.07};
  const Twist2 wanted{9.0, -0.33};
  request.operator_command = &wanted;
  const std::size_t grid = make(p, request).size();
  p.admissibility = Admissibility::braking;  // braking must be possible to choose
  EXPECT_TRUE(contains(make(p, request), {0.0, 0.0}, SampleKind::brake));
  EXPECT_EQ(make(p, request).size(), grid + 1);
  p.admissibility = Admissibility::horizon;
  p.method = Method::hidwa;
  EXPECT_TRUE(contains(make(p, request), {0.0, 0.0}, SampleKind::brake));
  EXPECT_TRUE(contains(make(p, request), {0.5, -0.33}, SampleKind::operator_command));
  EXPECT_TRUE(contains(make(p, request), {0.31, 0.07}, SampleKind::previous));
  EXPECT_EQ(make(p, request).size(), grid + 3);
  request.operator_command = nullptr;
  EXPECT_EQ(make(p, request).size(), grid + 2);
}

TEST(IntoWindow, AxisEndsWheelsAndDeadBand) {
  Parameters p;
  p.wheel_separation = 0.4;
  p.max_wheel_speed = 0.5;
  p.min_vel_theta = 0.2;
  const VelocityLimits limits = VelocityLimits::from(p);
  const DynamicWindow window{{0.1, 0.5}, {-0.8, 0.8}};
  EXPECT_EQ(into_window(p, limits, window, {-1.0, 0.5}).v, 0.1);
  const Twist2 cut = into_window(p, limits, window, {0.5, 2.0});
  EXPECT_EQ(cut.omega, 0.8);
  EXPECT_DOUBLE_EQ(cut.v, 0.34);                                        // 0.5 - 0.8 * 0.2
  EXPECT_EQ(into_window(p, limits, window, {0.3, 0.09}).omega, 0.0);    // less than half the band
  EXPECT_EQ(into_window(p, limits, window, {0.3, -0.11}).omega, -0.2);  // more: its edge
}

TEST(IntoWindow, TheWheelsHoldAfterTheDeadBandToo) {
  Parameters p;
  p.wheel_separation = 0.4;
  p.max_wheel_speed = 0.5;
  p.min_vel_theta = 0.2;
  const VelocityLimits limits = VelocityLimits::from(p);
  // (0.48, 0.1) fits the wheels just so; (0.48, 0.2) would not: 0.48 + 0.04 = 0.52 > 0.5.
  const Twist2 u = into_window(p, limits, {{0.0, 0.5}, {-1.0, 1.0}}, {0.48, 0.1});
  EXPECT_EQ(u.omega, 0.2);
  EXPECT_DOUBLE_EQ(u.v, 0.46);  // 0.5 - 0.2 * 0.2
}

// As in collision: what the motors cannot turn so slowly is no turn.
TEST(IntoWindow, LimitsBelowTheDeadBandLeaveNoTurn) {
  Parameters p;
  p.min_vel_theta = 0.4;
  VelocityLimits limits = VelocityLimits::from(p);
  limits.theta.min = -0.3;
  limits.theta.max = 0.3;
  const Twist2 u = into_window(p, limits, {{0.0, 0.5}, {-0.3, 0.3}}, {0.1, 0.3});
  EXPECT_EQ(u.omega, 0.0);
  EXPECT_EQ(u.v, 0.1);
}

}  // namespace
}  // namespace hidwa_local_planner
