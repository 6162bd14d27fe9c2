// SPDX-License-Identifier: BSD-3-Clause
// By hand; test/oracle/planner_twin_test.cpp compares the samples of random scenes.
#include "core/motion/samples.hpp"

#include <algorithm>

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

Request driving(double v, double omega, int vx, int vth) {
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
  const auto values_of = [](const Interval& interval, int count) {
    std::vector<double> values;
    spread(interval, count, values);
    return values;
  };
  EXPECT_EQ(values_of({-1.0, 1.0}, 2), (std::vector<double>{-1.0, 0.0, 1.0}));
  EXPECT_EQ(values_of({-1.0, 1.0}, 5), (std::vector<double>{-1.0, -0.5, 0.0, 0.5, 1.0}));  // it holds 0 by itself
  EXPECT_EQ(values_of({0.0, 0.5}, 3), (std::vector<double>{0.0, 0.25, 0.5}));              // 0 is an end
  EXPECT_EQ(values_of({0.3, 0.3}, 7), (std::vector<double>{0.3}));
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

struct Wish {
  const char* what;
  Twist2 wanted, becomes;
};

// Wheels of 0.5 m/s, 0.2 m from the middle; no turns on the spot slower than 0.2 rad/s.
TEST(IntoWindow, AxisEndsWheelsAndDeadBand) {
  Parameters p;
  p.wheel_separation = 0.4;
  p.max_wheel_speed = 0.5;
  p.min_in_place_vel_theta = 0.2;
  const VelocityLimits limits = VelocityLimits::from(p);
  const DynamicWindow window{{0.0, 0.5}, {-0.8, 0.8}};
  const Wish wishes[] = {
      {"is slower than the window", {-1.0, 0.5}, {0.0, 0.5}},
      {"turns faster: 0.5 - 0.8 * 0.2 is left to drive", {0.5, 2.0}, {0.34, 0.8}},
      {"turns slowly while it drives", {0.3, 0.09}, {0.3, 0.09}},
      {"turns less than half of the dead band on the spot", {0.0, 0.09}, {0.0, 0.0}},
      {"turns more than half of it", {0.0, -0.11}, {0.0, -0.2}},
      {"hardly drives, and turns more than half of it", {0.009, -0.11}, {0.009, -0.2}},
  };
  for (const Wish& wish : wishes) {
    const Twist2 u = into_window(p, limits, window, wish.wanted);
    EXPECT_DOUBLE_EQ(u.v, wish.becomes.v) << wish.what;
    EXPECT_DOUBLE_EQ(u.omega, wish.becomes.omega) << wish.what;
  }
}

// As in collision: what the motors cannot turn so slowly is no turn.
TEST(IntoWindow, LimitsBelowTheDeadBandLeaveNoTurn) {
  Parameters p;
  p.min_in_place_vel_theta = 0.4;
  VelocityLimits limits = VelocityLimits::from(p);
  limits.theta.min = -0.3;
  limits.theta.max = 0.3;
  const Twist2 u = into_window(p, limits, {{0.0, 0.5}, {-0.3, 0.3}}, {0.0, 0.3});
  EXPECT_TRUE(u == Twist2{});
}

}  // namespace
}  // namespace hidwa_local_planner
