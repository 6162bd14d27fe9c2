// SPDX-License-Identifier: BSD-3-Clause
// A planner that hears every critic about every candidate decides the same, and what it heard explains the choice.
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "core/planner/choice.hpp"
#include "hidwa_local_planner/core/planner.hpp"
#include "hidwa_local_planner/critics/built_in.hpp"
#include "hidwa_local_planner/record/cycle_record.hpp"
#include "support/random_scene.hpp"

namespace hidwa_local_planner {
namespace {

using test::random_scene;
using test::Scene;

// The rule in its plainest form, from what was said of each candidate: the smallest sum of those that nobody refuses,
// of equals whom the tie rule prefers.
int cheapest(const std::vector<CandidateVerdict>& candidates, const Parameters& p, const Twist2& last) {
  double lowest = std::numeric_limits<double>::infinity();
  for (const CandidateVerdict& candidate : candidates) {
    if (candidate.legal() && candidate.total < lowest) lowest = candidate.total;
  }
  const TieRule tie(p, last);
  int best = -1;
  for (std::size_t c = 0; c < candidates.size(); ++c) {
    if (!candidates[c].legal() || candidates[c].total > lowest + kEqualTotals) continue;
    if (best < 0 || candidates[c].total < candidates[static_cast<std::size_t>(best)].total - kEqualTotals ||
        tie.prefers(candidates[c].sample, candidates[static_cast<std::size_t>(best)].sample)) {
      best = static_cast<int>(c);
    }
  }
  return best;
}

TEST(Thorough, TheDecisionIsTheSameToTheBit) {
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    const Scene scene = random_scene(seed);
    Planner brief(critics::built_in()), thorough(critics::built_in());
    for (Planner* planner : {&brief, &thorough}) {
      ASSERT_TRUE(planner->configure(scene.parameters).empty());
      planner->set_footprint(scene.outline);
    }
    thorough.set_thorough(true);
    for (int cycle = 0; cycle < 2; ++cycle) {  // what critics remember must not have changed either
      const Decision& a = brief.plan(scene.situation, scene.grid(), scene.intent);
      const Decision& b = thorough.plan(scene.situation, scene.grid(), scene.intent);
      ASSERT_TRUE(identical(record::verdict_of(a, brief.totals()), record::verdict_of(b, thorough.totals()))) << seed;
    }
  }
}

TEST(Thorough, WhatWasSaidOfTheCandidatesExplainsTheChoice) {
  int chosen = 0, refused_twice = 0;
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    const Scene scene = random_scene(seed);
    Planner planner(critics::built_in());
    ASSERT_TRUE(planner.configure(scene.parameters).empty());
    planner.set_footprint(scene.outline);
    planner.set_thorough(true);
    const Decision& decision = planner.plan(scene.situation, scene.grid(), scene.intent);
    const std::vector<CandidateVerdict>& all = planner.verdicts();
    if (decision.candidates == 0 || all.empty()) continue;
    ASSERT_EQ(all.size(), decision.candidates);
    for (const CandidateVerdict& candidate : all) {
      int refusals = (candidate.collision != nullptr ? 1 : 0) + (candidate.can_brake ? 0 : 1);
      double sum = 0.0;
      for (const CriticVerdict& critic : candidate.critics) {
        refusals += critic.reason != nullptr && critic.weight != 0.0 ? 1 : 0;
        sum += critic.raw * critic.weight;
      }
      EXPECT_DOUBLE_EQ(sum, candidate.sum);
      refused_twice += refusals > 1 ? 1 : 0;
      // Who is legal was weighed by the same sum; only direct control leaves the critics' scores out.
      if (candidate.legal() && scene.intent.influence != Influence::direct) {
        EXPECT_NEAR(candidate.total, sum, 1e-9 * (1.0 + std::abs(sum)));
      }
      if (!candidate.legal() && candidate.can_brake) {
        EXPECT_TRUE(std::isinf(candidate.total));
      }
    }
    const int best = cheapest(all, scene.parameters, scene.situation.last_command);
    EXPECT_EQ(best, planner.marked().best) << seed;
    if (best < 0) continue;
    ++chosen;
    EXPECT_EQ(planner.choice().rule, ChoiceReport::Rule::cheapest);
    EXPECT_EQ(all[static_cast<std::size_t>(best)].sample, decision.sample);
  }
  EXPECT_GT(chosen, 250);
  EXPECT_GT(refused_twice, 1000);
}

TEST(Thorough, NothingIsHeardWhereNobodyAsked) {
  const Scene scene = Scene::empty();
  Planner planner(critics::built_in());
  planner.configure(scene.parameters);
  planner.set_footprint(scene.outline);
  planner.plan(scene.situation, scene.grid(), scene.intent);
  EXPECT_TRUE(planner.verdicts().empty());
  planner.set_thorough(true);
  planner.plan(scene.situation, scene.grid(), scene.intent);
  EXPECT_EQ(planner.verdicts().size(), planner.totals().size());
  OperatorIntent stop;
  stop.influence = Influence::stop;
  planner.plan(scene.situation, scene.grid(), stop);
  EXPECT_TRUE(planner.verdicts().empty());
  EXPECT_EQ(planner.choice().rule, ChoiceReport::Rule::none);
}

}  // namespace
}  // namespace hidwa_local_planner
