// SPDX-License-Identifier: BSD-3-Clause
// Looking for the collisions of all candidates, the slow and obvious way, changes nothing that is decided.
#include <cmath>
#include <cstdio>

#include <gtest/gtest.h>

#include "hidwa_local_planner/core/planner.hpp"
#include "support/effort.hpp"
#include "support/random.hpp"
#include "support/random_scene.hpp"
#include "support/renewed_planner.hpp"

namespace hidwa_local_planner {
namespace {

using test::Random;
using test::Scene;

const int kScenes = test::effort(400, 1500);
constexpr int kCycles = 3;

struct Tally {
  int cycles = 0, chosen = 0, nothing_legal = 0, fewer_looks = 0, own_rejected = 0;
};

void expect_same(const Decision& brief, const Decision& full) {
  EXPECT_EQ(brief.outcome, full.outcome);
  EXPECT_TRUE(brief.command == full.command);
  EXPECT_TRUE(brief.sample == full.sample);
  EXPECT_EQ(brief.total, full.total);
  EXPECT_EQ(brief.trajectory.size(), full.trajectory.size());
  EXPECT_EQ(brief.agreement, full.agreement);
  EXPECT_EQ(brief.operator_rejected_by, full.operator_rejected_by);
  EXPECT_EQ(brief.escaping, full.escaping);
  EXPECT_EQ(brief.problem, full.problem);
  EXPECT_EQ(brief.candidates, full.candidates);
  ASSERT_EQ(brief.terms.size(), full.terms.size());
  for (std::size_t i = 0; i < full.terms.size(); ++i) EXPECT_EQ(brief.terms[i].raw, full.terms[i].raw);
}

void expect_same_rejections(const Decision& brief, const Decision& full) {
  EXPECT_EQ(brief.legal, full.legal);
  ASSERT_EQ(brief.rejections.size(), full.rejections.size());
  for (std::size_t i = 0; i < full.rejections.size(); ++i) {
    EXPECT_EQ(brief.rejections[i].name, full.rejections[i].name);
    EXPECT_EQ(brief.rejections[i].count, full.rejections[i].count) << full.rejections[i].name;
  }
}

// What is known to be rejected is; a rejection that is not known of was none of the choice's business.
void expect_known_rejections(const Planner& brief, const Planner& full) {
  ASSERT_EQ(brief.totals().size(), full.totals().size());
  for (std::size_t c = 0; c < full.totals().size(); ++c) {
    if (std::isfinite(full.totals()[c])) {
      EXPECT_EQ(brief.totals()[c], full.totals()[c]) << "candidate " << c;
    }
  }
}

// A few cycles of one robot, so that what critics remember counts.
void compare(Scene& scene, Random& random, Tally& tally) {
  static test::RenewedPlanner renewed_brief, renewed_full;
  Planner &brief = renewed_brief(scene), &full = renewed_full(scene);
  Sampling all;
  all.report = Report::legality;
  for (int k = 0; k < kCycles; ++k) {
    const Decision& a = brief.plan(scene.situation, scene.grid(), scene.intent);
    const Decision& b = full.plan(scene.situation, scene.grid(), scene.intent, all);
    expect_same(a, b);
    expect_known_rejections(brief, full);
    const bool chosen = b.outcome == Outcome::drive || b.outcome == Outcome::hold;
    EXPECT_GE(a.legal, b.legal);
    if (!chosen) expect_same_rejections(a, b);
    ++tally.cycles;
    tally.chosen += chosen;
    tally.nothing_legal += b.candidates > 0 && b.legal == 0;
    tally.fewer_looks += a.legal > b.legal;
    tally.own_rejected += !b.operator_rejected_by.empty();
    scene.situation.velocity = scene.situation.last_command = b.command;
    scene.situation.pose.x += random.uniform(-0.05, 0.05);
    scene.situation.pose.y += random.uniform(-0.05, 0.05);
    scene.situation.time += scene.situation.period;
  }
}

TEST(CheckAll, DecidesTheSame) {
  Tally tally;
  for (int k = 0; k < kScenes && !testing::Test::HasFailure(); ++k) {
    SCOPED_TRACE("seed " + std::to_string(3000000 + k));
    Scene scene = test::random_scene(3000000 + static_cast<std::uint64_t>(k));
    Random random(static_cast<std::uint64_t>(k));
    if (random.chance(0.5)) test::take_default_profile(scene.parameters);
    // Equal totals all over: the tie rule decides.
    if (random.chance(0.1)) scene.parameters.critics = "Oscillation";
    if (random.chance(0.1)) scene.intent.influence = Influence::direct;
    if (random.chance(0.2)) scene.situation.velocity = scene.situation.last_command = {};  // it fails, if at all
    // Critics reject many that hit something too: whose rejection is told?
    if (random.chance(0.3)) scene.situation.goal_latched = true;
    compare(scene, random, tally);
  }
  std::printf("%d cycles: %d chosen, %d nothing legal, %d with fewer looks, %d with the person's own rejected\n",
              tally.cycles, tally.chosen, tally.nothing_legal, tally.fewer_looks, tally.own_rejected);
  EXPECT_GT(tally.chosen, kScenes * 4 / 3);
  EXPECT_GT(tally.nothing_legal, kScenes / 30);
  EXPECT_GT(tally.fewer_looks, kScenes / 5);
  EXPECT_GT(tally.own_rejected, kScenes / 15);
}

}  // namespace
}  // namespace hidwa_local_planner
