// SPDX-License-Identifier: BSD-3-Clause
// What holds for every scene, on 10,000 of them in the long form: symmetry, repeatability, and commands that can be
// driven and stopped.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "core/motion/velocity_limits.hpp"
#include "support/effort.hpp"
#include "support/naive_collision.hpp"
#include "support/naive_manoeuvre.hpp"
#include "support/random_scene.hpp"
#include "support/renewed_planner.hpp"
#include "support/transforms.hpp"

namespace hidwa_local_planner {
namespace {

using test::Scene;

const std::uint64_t kScenes = test::effort<std::uint64_t>(600, 10000);
constexpr double kSameTotal = 1e-9;
constexpr double kNearlyTied = 1e-6;

struct Answer {
  Decision decision;
  bool tied = false;  // another velocity's total lies within kNearlyTied of the best
};

Answer ask(const Scene& scene) {
  static test::RenewedPlanner renewed;
  Planner& planner = renewed(scene);
  Answer answer;
  answer.decision = planner.plan(scene.situation, scene.grid(), scene.intent);
  const Twist2 chosen = answer.decision.sample;
  for (const CandidateReport& record : planner.candidates()) {
    if (!record.legal()) continue;
    const bool other = std::abs(record.sample.v - chosen.v) + std::abs(record.sample.omega - chosen.omega) > 1e-9;
    if (other && std::abs(record.total - answer.decision.total) <= kNearlyTied) answer.tied = true;
  }
  return answer;
}

bool chose(const Decision& decision) { return !decision.trajectory.empty(); }

void expect_same(const Answer& a, const Answer& b, double side, const char* what, std::uint64_t seed) {
  ASSERT_EQ(chose(a.decision), chose(b.decision)) << what << ", scene " << seed;
  EXPECT_EQ(a.decision.candidates, b.decision.candidates) << what << ", scene " << seed;
  if (!chose(a.decision)) return;
  // J sums terms of up to some thousands: a rounding of its own size is no difference.
  EXPECT_NEAR(a.decision.total, b.decision.total, kSameTotal) << what << ", scene " << seed;
  if (a.tied || b.tied) return;
  EXPECT_NEAR(a.decision.sample.v, b.decision.sample.v, 1e-12) << what << ", scene " << seed;
  EXPECT_NEAR(a.decision.sample.omega, side * b.decision.sample.omega, 1e-12) << what << ", scene " << seed;
}

TEST(Property, SymmetricScenesGiveTheSameCandidate) {
  std::uint64_t tied = 0, chosen = 0;
  for (std::uint64_t seed = 0; seed < kScenes; ++seed) {
    const Scene scene = test::random_scene(seed);
    const Answer answer = ask(scene);
    chosen += chose(answer.decision);
    tied += answer.tied;
    Scene turned = scene;
    for (const char* what : {"turned by 90 degrees", "turned by 180 degrees", "turned by 270 degrees"}) {
      turned = test::turned(turned);
      expect_same(answer, ask(turned), 1.0, what, seed);
    }
    expect_same(answer, ask(test::mirrored(scene)), -1.0, "mirrored", seed);
    expect_same(answer, ask(test::translated(scene, 7, -11)), 1.0, "moved by whole cells", seed);
  }
  std::printf("%.1f %% of the scenes had a choice; in %.2f %% the two best totals lie within 1e-6\n",
              100.0 * static_cast<double>(chosen) / static_cast<double>(kScenes),
              100.0 * static_cast<double>(tied) / static_cast<double>(kScenes));
  EXPECT_GT(chosen, kScenes / 2);
  EXPECT_LT(tied, kScenes / 20);
}

// A new planner, and one that has planned for many other scenes.
TEST(Property, TheSameInputGivesTheSameBits) {
  for (std::uint64_t seed = 0; seed < kScenes; ++seed) {
    const Scene scene = test::random_scene(seed);
    test::RenewedPlanner renewed;
    const Decision a = ask(scene).decision, b = renewed(scene).plan(scene.situation, scene.grid(), scene.intent);
    ASSERT_EQ(a.outcome, b.outcome) << seed;
    ASSERT_TRUE(a.command == b.command && a.sample == b.sample && a.total == b.total) << seed;
  }
}

void expect_within_limits(const Parameters& p, const Decision& decision, const Twist2& last, double period,
                          std::uint64_t seed) {
  const Twist2 u = decision.command, from = decision.reference;
  ASSERT_TRUE(is_finite(u)) << seed;
  // Outside its limits only as far as braking from a reference outside them has not yet brought it back.
  EXPECT_LE(u.v, std::max(p.max_vel_x, from.v) + 1e-9) << seed;
  EXPECT_GE(u.v, std::min({p.min_vel_x, 0.0, from.v}) - 1e-9) << seed;
  EXPECT_LE(std::abs(u.omega), std::max(p.max_vel_theta, std::abs(from.omega)) + 1e-9) << seed;
  if (p.has_wheel_limit()) {
    const double half = 0.5 * p.wheel_separation;
    const double before = std::abs(from.v) + half * std::abs(from.omega);
    EXPECT_LE(std::abs(u.v) + half * std::abs(u.omega), std::max(p.max_wheel_speed, before) + 1e-8) << seed;
  }
  // Braking may start from the last command: odometry that lags must not take back what brakes already.
  const auto step = [](double to, double reference, double before) {
    return std::min(std::abs(to - reference), std::abs(to - before));
  };
  EXPECT_LE(step(u.v, from.v, last.v), std::max(p.acc_lim_x, p.braking_x()) * period + 1e-9) << seed;
  EXPECT_LE(step(u.omega, from.omega, last.omega), std::max(p.acc_lim_theta, p.braking_theta()) * period + 1e-9)
      << seed;
}

// The deepest overlap of the braked trajectory [m], poses a quarter of a cell apart.
double braked_overlap(const Scene& scene, const Decision& decision) {
  const Parameters& p = scene.parameters;
  const Footprint footprint = Footprint::from_outline(scene.outline, p.footprint_padding);
  const test::NaiveBody body{footprint.outline(), footprint.radius()};
  const test::NaiveEffects steady(p, scene.situation.period, decision.reference);
  const test::NaiveManoeuvre manoeuvre =
      test::naive_manoeuvre(p, scene.situation.pose, steady, decision.command, scene.situation.period);
  double worst = 0.0;
  for (const Pose2& pose : test::naive_poses(manoeuvre, test::naive_outer_radius(body), 0.25 * scene.resolution)) {
    worst = std::max(worst, test::naive_overlap(scene.grid(), body, pose, p.unknown_is_obstacle));
  }
  return worst;
}

TEST(Property, ChosenCommandsKeepTheLimitsAndCanBeBraked) {
  std::uint64_t braked = 0, near_obstacles = 0;
  for (std::uint64_t seed = 0; seed < kScenes; ++seed) {
    const Scene scene = test::random_scene(seed);
    const Decision decision = ask(scene).decision;
    expect_within_limits(scene.parameters, decision, scene.situation.last_command, scene.situation.period, seed);
    if (!chose(decision) || decision.escaping) continue;
    const Footprint footprint = Footprint::from_outline(scene.outline, scene.parameters.footprint_padding);
    const test::NaiveBody body{footprint.outline(), footprint.radius()};
    // A robot that stands in collision without the licence to escape has no free trajectory to choose.
    if (test::naive_overlap(scene.grid(), body, scene.situation.pose, scene.parameters.unknown_is_obstacle) > 0.0) {
      continue;
    }
    ++braked;
    near_obstacles += decision.legal < decision.candidates;
    // The root of an area: rounding of 1e-15 m^2 shows as some 1e-8 m.
    EXPECT_LE(braked_overlap(scene, decision), 1e-6) << "scene " << seed;
  }
  std::printf("%llu commands braked, %llu of them where something was rejected\n",
              static_cast<unsigned long long>(braked), static_cast<unsigned long long>(near_obstacles));
  EXPECT_GT(braked, kScenes / 2);
  EXPECT_GT(near_obstacles, kScenes / 4);
}

}  // namespace
}  // namespace hidwa_local_planner
