// SPDX-License-Identifier: BSD-3-Clause
// A robot whose odometry shows a command only a latency and a ramp later: the planner goes on from its last command,
// and notices nonetheless when the robot does something else.
#include <algorithm>
#include <cmath>
#include <ostream>

#include <gtest/gtest.h>

#include "drive_on.hpp"
#include "support/drive_limits.hpp"
#include "support/random.hpp"
#include "support/scene_loop.hpp"

namespace hidwa_local_planner::test {
namespace {

struct Base {
  double v, omega;          // the fastest [m/s, rad/s]
  double acc_x, acc_theta;  // [m/s^2, rad/s^2]
  double decel_x;           // [m/s^2]
  double latency;           // [s]
};
void PrintTo(const Base& b, std::ostream* out) { *out << b.acc_x << " m/s^2, " << b.latency << " s"; }

// In free space a person moves it as they like.
class LaggingRobot {
 public:
  explicit LaggingRobot(const Base& base) : scene_(begin(base)), drive_(limits(scene_.parameters)), loop_(scene_) {}

  struct Cycle {
    Twist2 measured, last_command, reference, command;
    bool goes_on() const { return reference == last_command; }
    bool doubted = false, fast = false;
  };

  /// One control period; `held`: the wheels are blocked.
  Cycle cycle(const Twist2& wanted, bool held = false) {
    Situation& now = scene_.situation;
    if (held) drive_.set_velocity({});
    now.velocity = {drive_.velocity().v, drive_.velocity().omega};
    scene_.intent.u_h = wanted;
    const control::Result result = loop_.cycle(stopped_);
    const Decision& decision = *result.decision;
    const Cycle cycle{now.velocity,   now.last_command,          decision.reference,
                      result.command, decision.odometry_doubted, decision.odometry_fast};
    const Pose2 stays = now.pose;  // the planner sees it in the same place
    drive_on(now, drive_, cycle.command, 5, [&](int) {
      if (held) drive_.set_velocity({});
    });
    now.pose = stays;
    return cycle;
  }
  void stop(bool stops) { stopped_ = stops; }
  void push(const Twist2& u) { drive_.set_velocity({u.v, u.omega}); }
  double period() const { return scene_.situation.period; }

 private:
  static Scene begin(const Base& base) {
    Scene scene = Scene::empty();
    Parameters& p = scene.parameters;
    p = Parameters();
    p.max_vel_x = base.v;
    p.min_vel_x = -base.v;
    p.max_vel_theta = base.omega;
    p.acc_lim_x = base.acc_x;
    p.acc_lim_theta = base.acc_theta;
    p.decel_lim_x = -base.decel_x;
    p.control_latency = base.latency;
    scene.intent.influence = Influence::direct;
    scene.intent.guarded = false;
    return scene;
  }
  // It may be pushed to twice its speed.
  static sim::DriveLimits limits(const Parameters& p) {
    sim::DriveLimits limits = limits_of(p);
    limits.max_vel_x *= 2.0;
    limits.max_vel_theta *= 2.0;
    return limits;
  }

  Scene scene_;
  sim::DiffDrive drive_;
  SceneLoop loop_;
  bool stopped_ = false;  // by the host
};

class Latency : public ::testing::TestWithParam<Base> {};

TEST_P(Latency, WhateverThePersonWantsItGoesOnFromTheLastCommand) {
  const Base base = GetParam();
  Random random(1);
  int far_behind = 0;
  for (int robots = 0; robots < 20; ++robots) {
    LaggingRobot robot(base);
    Twist2 wanted;
    for (int k = 0; k < 400; ++k) {
      if (random.chance(0.2)) wanted = {random.uniform(-base.v, base.v), random.uniform(-base.omega, base.omega)};
      robot.stop(random.chance(0.1));
      const LaggingRobot::Cycle cycle = robot.cycle(wanted);
      ASSERT_TRUE(cycle.goes_on()) << k << ": " << cycle.measured.v << " " << cycle.last_command.v << ", "
                                   << cycle.measured.omega << " " << cycle.last_command.omega;
      far_behind += std::abs(cycle.measured.v - cycle.last_command.v) > 0.2;
    }
  }
  // Where the lag is more than the tolerance, 0.2 m/s, it was.
  if (base.latency * base.acc_x > 0.2) {
    EXPECT_GT(far_behind, 100);
  }
}

TEST_P(Latency, ItBrakesToRestWithoutAnySpeedingUp) {
  const Base base = GetParam();
  LaggingRobot robot(base);
  for (int k = 0; k < 100; ++k) robot.cycle({base.v, 0.0});
  double before = base.v;
  robot.stop(true);
  while (before > 0.0) {
    const LaggingRobot::Cycle cycle = robot.cycle({});
    EXPECT_TRUE(cycle.goes_on()) << before;
    EXPECT_NEAR(cycle.command.v, std::max(0.0, before - base.decel_x * robot.period()), 1e-9);
    ASSERT_LT(cycle.command.v, before);
    before = cycle.command.v;
  }
}

// Two slow readings are doubted, the third is believed: commands then fall, at the braking limit, towards what a robot
// at rest could be told. Let go, they rise at the limit. They are the same again where the readings may be those of a
// robot that follows them: within 0.2 m/s, the tolerance.
TEST_P(Latency, ARobotThatIsHeldIsNoticed) {
  const Base base = GetParam();
  LaggingRobot robot(base);
  for (int k = 0; k < 100; ++k) robot.cycle({base.v, 0.0});
  const double least = std::max(0.2, base.acc_x * robot.period()), braked = base.decel_x * robot.period();
  double before = base.v;
  for (int k = 1; before > least; ++k) {  // its commands were the same for long: noticed at once
    const LaggingRobot::Cycle cycle = robot.cycle({base.v, 0.0}, true);
    EXPECT_TRUE(cycle.goes_on());
    EXPECT_EQ(cycle.doubted, k < 3) << k;
    ASSERT_NEAR(cycle.command.v, k < 3 ? before : std::max(base.acc_x * robot.period(), before - braked), 1e-9) << k;
    before = cycle.command.v;
  }
  for (int k = 0; before < base.v; ++k) {
    ASSERT_LT(k, 1000);
    const LaggingRobot::Cycle cycle = robot.cycle({base.v, 0.0});
    EXPECT_TRUE(cycle.goes_on());
    EXPECT_LE(cycle.command.v, before + base.acc_x * robot.period() + 1e-9);
    before = cycle.command.v;
  }
  // From rest: within a latency, a period and a cycle after it had to move by more than the tolerance, and two more
  // readings.
  LaggingRobot blocked(base);
  int cycles = 0;
  LaggingRobot::Cycle cycle;
  do {
    cycle = blocked.cycle({base.v, 0.0}, true);
    cycles += cycle.last_command.v > 0.2;
  } while (cycle.command.v >= cycle.last_command.v && cycles < 100);
  EXPECT_LE(cycles, std::ceil(base.latency / blocked.period() - 1e-9) + 4);
}

// A velocity that no command explains is doubted at once, and believed once it has agreed with itself for 0.3 s; a
// command never starts from it.
void expect_noticed(LaggingRobot& robot, const Twist2& wanted, const Twist2& pushed) {
  for (double t = 0.0; t < 0.35; t += robot.period()) {
    robot.push(pushed);
    const LaggingRobot::Cycle cycle = robot.cycle(wanted);
    EXPECT_TRUE(cycle.goes_on());
    EXPECT_EQ(cycle.doubted, t < 0.3 - 1e-9) << t;
    EXPECT_EQ(cycle.fast, t >= 0.3 - 1e-9) << t;
  }
}

TEST_P(Latency, ARobotThatIsPushedIsNoticedAtOnce) {
  const Base base = GetParam();
  const Twist2 wanted{0.5 * base.v, 0.0};
  LaggingRobot robot(base);
  for (int k = 0; k < 100; ++k) robot.cycle(wanted);
  expect_noticed(robot, wanted, {0.5 * base.v + 0.21, 0.0});
  LaggingRobot turned(base);
  for (int k = 0; k < 100; ++k) turned.cycle(wanted);
  expect_noticed(turned, wanted, {0.5 * base.v, -0.51});
  // While it speeds up too, where it is faster than it was ever told.
  LaggingRobot starting(base);
  starting.cycle({base.v, 0.0});
  starting.cycle({base.v, 0.0});
  starting.push({std::min(base.v, 2.0 * base.acc_x * starting.period()) + 0.21, 0.0});
  EXPECT_TRUE(starting.cycle({base.v, 0.0}).doubted);
}

INSTANTIATE_TEST_SUITE_P(Bases, Latency,
                         ::testing::Values(Base{0.5, 1.0, 2.5, 3.2, 2.5, 0.1}, Base{0.5, 1.0, 2.5, 3.2, 2.5, 0.0},
                                           Base{2.0, 4.0, 10.0, 20.0, 10.0, 0.05},
                                           Base{2.0, 4.0, 10.0, 20.0, 10.0, 0.1},
                                           Base{2.0, 4.0, 10.0, 20.0, 10.0, 0.12},
                                           Base{1.0, 2.0, 2.0, 6.0, 5.0, 0.17}));

}  // namespace
}  // namespace hidwa_local_planner::test
