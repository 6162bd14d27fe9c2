// SPDX-License-Identifier: BSD-3-Clause
#include "control/response_watch.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <functional>

#include <gtest/gtest.h>

#include "support/random.hpp"

namespace hidwa_local_planner {
namespace {

constexpr double kPeriod = 0.05;  // [s]

// A base that carries out commands after a latency, each evenly within a period.
struct Drive {
  double latency = 0.1;                     // [s]
  double delay = 0.0;                       // of odometry: its stamp is older by that [s]
  double noise = 0.0;                       // of a velocity, uniform [m/s, rad/s]
  std::function<Twist2(double)> commanded;  // by time
  std::function<Twist2(Twist2)> does = [](const Twist2& u) { return u; };

  Twist2 at(double time) const {
    const double effect = std::floor((time - latency) / kPeriod + 1e-9) * kPeriod;  // of the newest command in force
    const double share = (time - latency - effect) / kPeriod;
    const Twist2 from = commanded(effect - kPeriod), to = commanded(effect);
    return {from.v + share * (to.v - from.v), from.omega + share * (to.omega - from.omega)};
  }

  void run(ResponseWatch& watch, double seconds, double begin = 100.0) const {
    test::Random random(5);
    for (int i = 0; i * kPeriod < seconds; ++i) {
      const double now = begin + i * kPeriod, measured_at = now - delay;
      Twist2 measured = does(at(measured_at));
      measured.v += random.uniform(-noise, noise);
      measured.omega += random.uniform(-noise, noise);
      watch.add(now, kPeriod, commanded(now), measured_at, measured);
    }
  }
};

// Speeds up and brakes within the planner's limits (at most 0.125 m/s a period), and turns.
Twist2 lively(double time) { return {0.25 + 0.25 * std::sin(2.0 * time), 0.5 * std::sin(1.3 * time)}; }

TEST(ResponseWatch, FindsTheLatency) {
  for (const double latency : {0.0, 0.1, 0.25, 0.6}) {
    for (const double delay : {0.0, 0.04}) {
      ResponseWatch watch;
      Drive drive;
      drive.latency = latency;
      drive.delay = delay;
      drive.noise = 0.01;
      drive.commanded = lively;
      drive.run(watch, 10.0);
      ASSERT_TRUE(watch.latency()) << latency;
      EXPECT_NEAR(*watch.latency(), latency, 0.05) << "delay " << delay;
    }
  }
}

TEST(ResponseWatch, TellsWhereTheLatencyIsLargerThanTold) {
  EXPECT_EQ(latency_complaint(0.14, 0.1, kPeriod), "");
  EXPECT_EQ(latency_complaint(0.15, 0.1, kPeriod), "");  // a period, which no estimate is better than
  const std::string said = latency_complaint(0.2, 0.1, kPeriod);
  EXPECT_NE(said.find("after about 0.20 s, later than control_latency says (0.10 s)"), std::string::npos) << said;
  EXPECT_EQ(latency_complaint(0.25, 0.1, 0.2), "");
}

TEST(ResponseWatch, ASteadyDriveTellsNothing) {
  ResponseWatch watch;
  Drive drive;
  drive.latency = 0.4;
  drive.noise = 0.02;
  drive.commanded = [](double) { return Twist2{0.5, 0.0}; };
  drive.run(watch, 10.0);
  EXPECT_FALSE(watch.latency());
}

// Held by a wall half of the time; wheels that slip; driven by somebody else.
TEST(ResponseWatch, ABaseThatDoesSomethingElseIsNotCalledLate) {
  double t = 0.0;
  const std::function<Twist2(Twist2)> others[] = {
      [&t](const Twist2& u) { return std::sin(0.7 * (t += kPeriod)) > 0.0 ? Twist2{} : u; },
      [](const Twist2& u) {
        return Twist2{0.5 * u.v, 0.4 * u.omega};
      },
      [&t](const Twist2&) {
        return Twist2{0.3 * std::sin(3.1 * (t += kPeriod)), 0.6 * std::sin(1.9 * t)};
      }};
  for (const auto& other : others) {
    ResponseWatch watch;
    Drive drive;
    drive.commanded = lively;
    drive.does = other;
    for (int i = 0; i < 60; ++i) {
      drive.run(watch, 1.0, 100.0 + i);
      EXPECT_EQ(latency_complaint(watch.latency().value_or(0.0), 0.1, kPeriod), "") << i << " s";
    }
  }
}

TEST(ResponseWatch, GoesOnAfterAPauseAndAClockSetBack) {
  ResponseWatch watch;
  Drive drive;
  drive.commanded = lively;
  drive.run(watch, 10.0);
  ASSERT_TRUE(watch.latency());
  drive.latency = 0.3;
  drive.run(watch, 10.0, 500.0);
  EXPECT_NEAR(watch.latency().value_or(0.0), 0.3, 0.05);
  drive.latency = 0.2;
  drive.run(watch, 10.0, 50.0);
  EXPECT_NEAR(watch.latency().value_or(0.0), 0.2, 0.05);
}

}  // namespace
}  // namespace hidwa_local_planner
