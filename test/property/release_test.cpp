// SPDX-License-Identifier: BSD-3-Clause
// The default profile in free space, commands carried out perfectly in nominal periods: what the robot does
// when the person lets go of the stick, with the control loop and the state machine that a robot runs.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include <gtest/gtest.h>

#include "control/control_loop.hpp"
#include "hidwa_local_planner/critics/built_in.hpp"
#include "input/operator_state_machine.hpp"
#include "input/stick_reading.hpp"

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
  explicit Drive(const Case& c) : loop_(critics::built_in()) {
    p_.max_vel_x = c.v_max;
    EXPECT_TRUE(loop_.configure(p_).empty());
    machine_.configure(p_);
    Polygon outline;
    for (int i = 0; i < 16; ++i) outline.emplace_back(0.3 * std::cos(M_PI * i / 8), 0.3 * std::sin(M_PI * i / 8));
    loop_.set_footprint(outline);
    // p^2 max_vel_theta = omega_h.
    deflection_ = static_cast<float>(std::copysign(std::sqrt(std::abs(c.omega_h) / p_.max_vel_theta), c.omega_h));
    std::vector<Pose2> plan;
    for (int i = 0; i <= 1200; ++i) plan.push_back({0.05 * i, 0.0, 0.0});
    loop_.set_plan(plan, "map", 0.0, kPeriod);
    costs_.assign(kCells * kCells, cost::kFree);
    pose_.x = 1.0;
  }

  std::vector<Step> run() {
    std::vector<Step> steps;
    for (int k = 0; k * kPeriod < kEnd; ++k) steps.push_back(cycle(k * kPeriod));
    return steps;
  }
  const Parameters& parameters() const { return p_; }

 private:
  static constexpr int kCells = 180;

  Step cycle(double now) {
    input::StickMessage message;
    message.received = now - 0.01;
    const bool pressed = now > kPressed - 1e-9 && now < kReleased - 1e-9;
    message.axes = {pressed ? deflection_ : 0.0F, 0.0F};
    EXPECT_EQ(machine_.receive(message), "");

    control::Observation seen;
    seen.timing = {now, kPeriod, kPeriod, kPeriod, false};
    seen.pose = pose_;
    seen.velocity = u_;
    seen.costmap = {costs_.data(),
                    kCells,
                    kCells,
                    0.05,
                    std::floor(pose_.x / 0.05) * 0.05 - 4.5,
                    std::floor(pose_.y / 0.05) * 0.05 - 4.5};
    if (loop_.goal_begins()) machine_.new_goal();
    const control::Result result = loop_.step(seen, machine_.update(now));
    machine_.debrief(now, result.feedback);
    const Step step{now, result.intent.state, result.outcome, u_, result.command, pose_};
    u_ = result.command;
    const double middle = pose_.theta + 0.5 * u_.omega * kPeriod;
    pose_.x += u_.v * std::cos(middle) * kPeriod;
    pose_.y += u_.v * std::sin(middle) * kPeriod;
    pose_.theta += u_.omega * kPeriod;
    return step;
  }

  Parameters p_;
  input::OperatorStateMachine machine_;
  control::ControlLoop loop_;
  float deflection_ = 0.0F;
  std::vector<std::uint8_t> costs_;
  Pose2 pose_;
  Twist2 u_;
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
