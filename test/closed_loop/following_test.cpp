// SPDX-License-Identifier: BSD-3-Clause
// How closely the robot follows the stick in free space, in the default profile: from a stick's message to the
// command, through the control loop. Commands are carried out perfectly.
#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "input/operator_state_machine.hpp"
#include "input/stick_reading.hpp"
#include "plan_drive.hpp"

namespace hidwa_local_planner::test {
namespace {

constexpr double kPeriod = 0.05;    // [s]
constexpr double kClose = 0.01;     // [rad/s]
const Pose2 kGoal{60.0, 0.0, 0.0};  // far away: the person steers off the way there all the time

/// The paper's map in the default profile.
double omega_of(float deflection) {
  const double p = static_cast<double>(deflection);
  return std::abs(deflection) <= 0.1F ? 0.0 : p * std::abs(p);
}

class Follower {
 public:
  struct Cycle {
    double wanted = 0.0;     // by the stick's last message [rad/s]
    double reachable = 0.0;  // of it, within the acceleration limit [rad/s]
    Decision decision;
    OperatorIntent intent;
  };

  /// One control period at whose end the planner runs; the stick's message comes `early` [s] before that.
  Cycle cycle(float deflection, double early = 0.02) {
    Situation& now = scene_.situation;
    const Parameters p;
    input::StickMessage message;
    message.axes = {deflection, 0.0F};
    message.buttons = {0};
    message.received = now.time - early;
    EXPECT_EQ(machine_.receive(message), "");
    Cycle cycle;
    cycle.wanted = omega_of(deflection);
    const double step = p.acc_lim_theta * kPeriod;
    cycle.reachable = std::clamp(cycle.wanted, now.last_command.omega - step, now.last_command.omega + step);
    surround();
    scene_.intent = machine_.update(now.time);
    const control::Result result = loop_.cycle();
    machine_.debrief(now.time, result.feedback);
    cycle.intent = result.intent;
    cycle.decision = *result.decision;
    carry_out(scene_, result.command);
    return cycle;
  }

 private:
  static Scene begin() {
    Scene scene = Scene::empty(81);
    scene.parameters = Parameters();
    scene.situation.period = kPeriod;
    scene.situation.time = 1.0;
    scene.situation.goal = kGoal;
    return scene;
  }

  /// The costmap rolls along; once a second there is another plan, straight to the goal.
  void surround() {
    follow_robot(scene_);
    if (cycles_++ % 20 != 0) return;
    scene_.situation.plan = {scene_.situation.pose};
    go_to(scene_.situation.plan, kGoal.x, kGoal.y);
    loop_.plan();
  }

  Scene scene_ = begin();
  input::OperatorStateMachine machine_;
  SceneLoop loop_{scene_};
  int cycles_ = 0;
};

// On the way at full speed, with the stick centred.
void set_off(Follower& robot) {
  double v = 0.0;
  for (int i = 0; i < 20; ++i) v = robot.cycle(0.0F).decision.command.v;
  ASSERT_NEAR(v, 0.5, 1e-9);
}

struct Errors {
  double largest = 0.0;    // of omega* against what the acceleration limit lets through of omega_h [rad/s]
  double unlimited = 0.0;  // of omega* against omega_h where the limit leaves it alone [rad/s]
  int cycles = 0;
  int limited = 0;
  void add(const Follower::Cycle& cycle) {
    const double omega = cycle.decision.command.omega;
    largest = std::max(largest, std::abs(omega - cycle.reachable));
    ++cycles;
    if (cycle.reachable != cycle.wanted) {
      ++limited;
    } else {
      unlimited = std::max(unlimited, std::abs(omega - cycle.wanted));
    }
  }
};

TEST(Following, EveryDeflectionIsFollowedOnceTheAccelerationLimitAllows) {
  Follower robot;
  set_off(robot);
  Errors errors;
  for (const bool jumps : {false, true}) {
    for (int i = -50; i <= 50; ++i) {
      // In small steps from right to left; and back and forth between the sides.
      const float deflection = static_cast<float>(jumps && i % 2 != 0 ? -i : i) / 50.0F;
      Follower::Cycle cycle;
      for (int k = 0; k < 16; ++k) {  // from one end to the other are 2 / 0.16 = 13 periods
        cycle = robot.cycle(deflection);
        ASSERT_EQ(cycle.decision.outcome, Outcome::drive);
        if (cycle.intent.influence == Influence::none) continue;  // centred for longer than delta
        errors.add(cycle);
        EXPECT_EQ(cycle.decision.operator_rejected_by, "");
      }
      if (cycle.intent.influence == Influence::none) continue;
      EXPECT_NEAR(cycle.decision.command.omega, cycle.wanted, kClose) << deflection;
      EXPECT_NEAR(cycle.decision.command.v, 0.5, 0.01) << deflection;
    }
  }
  EXPECT_LE(errors.largest, kClose);
  EXPECT_LE(errors.unlimited, kClose);
  EXPECT_GT(errors.cycles, 2900);  // of 3232: all but those in the dead zone beyond delta
  EXPECT_GT(errors.limited, 100);
  RecordProperty("largest_error_1e9_rad_s", static_cast<int>(1e9 * errors.largest));
}

TEST(Following, ASweptSineIsFollowed) {
  Follower robot;
  set_off(robot);
  constexpr double kDuration = 40.0;  // from 0.1 to 1 Hz [s]
  Errors errors;
  for (int i = 0; i * kPeriod < kDuration; ++i) {
    const double t = i * kPeriod;
    const double phase = 2.0 * M_PI * (0.1 + 0.5 * 0.9 * t / kDuration) * t;
    const Follower::Cycle cycle = robot.cycle(static_cast<float>(std::sin(phase)));
    ASSERT_EQ(cycle.decision.outcome, Outcome::drive);
    if (cycle.intent.influence == Influence::none) continue;  // before the first deflection
    EXPECT_NEAR(cycle.decision.command.omega, cycle.reachable, kClose) << t;
    errors.add(cycle);
  }
  EXPECT_LE(errors.unlimited, kClose);
  EXPECT_GT(errors.cycles, 780);                   // of 800
  EXPECT_GT(errors.cycles - errors.limited, 400);  // and it bites in part of them only
  RecordProperty("largest_error_1e9_rad_s", static_cast<int>(1e9 * errors.largest));
}

TEST(Following, TheCommandOfTheNextCycleHasTheMessageInIt) {
  for (const double early : {0.0, 0.001, 0.025, 0.0499}) {
    Follower robot;
    set_off(robot);
    for (const float deflection : {0.3F, 0.35F, -0.2F, -0.3F, 0.0F, 0.2F}) {
      const Follower::Cycle cycle = robot.cycle(deflection, early);
      EXPECT_NEAR(cycle.decision.command.omega, cycle.reachable, kClose) << early << ", " << deflection;
      EXPECT_DOUBLE_EQ(cycle.intent.u_h.omega, cycle.wanted) << early << ", " << deflection;
    }
  }
}

}  // namespace
}  // namespace hidwa_local_planner::test
