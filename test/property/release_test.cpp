// SPDX-License-Identifier: BSD-3-Clause
// The default profile in free space, commands carried out perfectly in nominal periods: what the robot does
// when the person lets go of the stick, with the control loop and the state machine that a robot runs.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include <gtest/gtest.h>

#include "input/operator_state_machine.hpp"
#include "input/stick_reading.hpp"
#include "support/round_outline.hpp"
#include "support/scene_loop.hpp"

namespace hidwa_local_planner {
namespace {

constexpr double kPeriod = 0.05;   // [s]
constexpr double kPressed = 1.0;   // the stick is deflected from here ... [s]
constexpr double kReleased = 2.5;  // ... to here [s]
constexpr double kEnd = 16.0;      // [s]

struct Case {
  double v_max;    // [m/s]
  double omega_h;  // of the person [rad/s]
};

struct Step {
  double time = 0.0;
  OperatorStateId state = OperatorStateId::autonomy;
  Outcome outcome = Outcome::fail;
  Twist2 before, command;
  Pose2 pose;
};

// A straight plan along +x, a rolling empty map of 9 x 9 m, a stick that repeats at 20 Hz.
class Drive {
 public:
  explicit Drive(const Case& c) : scene_(begin(c)) {
    machine_.configure(parameters());
    // p^2 max_vel_theta = omega_h.
    deflection_ =
        static_cast<float>(std::copysign(std::sqrt(std::abs(c.omega_h) / parameters().max_vel_theta), c.omega_h));
  }

  std::vector<Step> run() {
    std::vector<Step> steps;
    while (scene_.situation.time < kEnd) steps.push_back(cycle());
    return steps;
  }
  const Parameters& parameters() const { return scene_.parameters; }

 private:
  static test::Scene begin(const Case& c) {
    test::Scene scene = test::Scene::empty(180);
    scene.parameters = Parameters();
    scene.parameters.max_vel_x = c.v_max;
    scene.outline = test::round_outline(0.3);
    Situation& now = scene.situation;
    now.plan.clear();
    for (int i = 0; i <= 1200; ++i) now.plan.push_back({0.05 * i, 0.0, 0.0});
    now.goal = now.plan.back();
    now.pose.x = 1.0;
    return scene;
  }

  Step cycle() {
    const Situation& now = scene_.situation;
    input::StickMessage message;
    message.received = now.time - 0.01;
    const bool pressed = now.time > kPressed - 1e-9 && now.time < kReleased - 1e-9;
    message.axes = {pressed ? deflection_ : 0.0F, 0.0F};
    EXPECT_EQ(machine_.receive(message), "");

    test::follow_robot(scene_);
    if (loop_.goal_begins()) machine_.new_goal();
    scene_.intent = machine_.update(now.time);
    const control::Result result = loop_.cycle();
    machine_.debrief(now.time, result.feedback);
    const Step step{now.time, result.intent.state, result.outcome, now.velocity, result.command, now.pose};
    test::carry_out(scene_, result.command);
    return step;
  }

  test::Scene scene_;
  test::SceneLoop loop_{scene_};
  input::OperatorStateMachine machine_;
  float deflection_ = 0.0F;
};

class Release : public ::testing::TestWithParam<Case> {};

TEST_P(Release, TheTurnRampsToZeroStaysThereAndNothingJumps) {
  Drive drive(GetParam());
  const Parameters& p = drive.parameters();
  const double fall = p.acc_lim_theta * kPeriod;  // 3.2 * 0.05 = 0.16 rad/s a cycle
  constexpr double kRounding = 1e-12;
  double held_from = -1.0, held_to = -1.0;
  int straight = 0;
  bool steered = false;
  const std::vector<Step> steps = drive.run();
  for (const Step& step : steps) {
    SCOPED_TRACE("t = " + std::to_string(step.time));
    ASSERT_EQ(step.outcome, Outcome::drive);
    ASSERT_LE(std::abs(step.command.v - step.before.v), p.acc_lim_x * kPeriod + kRounding);
    ASSERT_LE(std::abs(step.command.omega - step.before.omega), fall + kRounding);
    if (step.state == OperatorStateId::shared) {
      steered = steered || std::abs(step.command.omega - GetParam().omega_h) < 1e-6;
    }
    if (step.state != OperatorStateId::hold) continue;
    if (held_from < 0.0) held_from = step.time;
    held_to = step.time;
    const double expected = std::max(0.0, std::abs(step.before.omega) - fall);
    if (expected > 0.0) {
      ASSERT_NEAR(std::abs(step.command.omega), expected, kRounding);
      ASSERT_GT(step.command.omega * step.before.omega, 0.0);
    } else {
      ASSERT_EQ(step.command.omega, 0.0);
      ++straight;
    }
  }
  EXPECT_TRUE(steered);                     // the person's turn was reached before
  EXPECT_NEAR(held_from, kReleased, 1e-9);  // from the first cycle after the release
  // delta counts from the last deflected message, one period before the release.
  EXPECT_NEAR(held_to - held_from, p.delta - 2.0 * kPeriod, kPeriod + 1e-9);
  EXPECT_GT(straight, 25);
  // Autonomy then leads back to the plan.
  double farthest = 0.0;
  for (const Step& step : steps) farthest = std::max(farthest, std::abs(step.pose.y));
  std::printf("v_max %.2f omega_h %+.4f: %.2f m off, at the end %.3f m\n", GetParam().v_max, GetParam().omega_h,
              farthest, steps.back().pose.y);
  EXPECT_LT(std::abs(steps.back().pose.y), 0.1);
}

// 0.481 and 0.1601 leave a last step of 0.001 and 0.0001 rad/s: it too must go, though it costs next to
// nothing.
INSTANTIATE_TEST_SUITE_P(SpeedsAndTurns, Release,
                         ::testing::Values(Case{0.26, 1.0}, Case{0.26, -0.3}, Case{0.26, 0.481}, Case{0.5, 1.0},
                                           Case{0.5, -1.0}, Case{0.5, 0.25}, Case{0.5, -0.481}, Case{0.5, 0.1601},
                                           Case{0.5, 0.05}, Case{1.0, -1.0}, Case{1.0, 0.6}, Case{1.0, -0.3201}));

}  // namespace
}  // namespace hidwa_local_planner
