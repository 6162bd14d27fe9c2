// SPDX-License-Identifier: BSD-3-Clause
// With Report::full every critic is asked about every candidate. The decision is the same, and the reports explain it.
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "core/evaluation/tie_rule.hpp"
#include "hidwa_local_planner/critics/built_in.hpp"
#include "record/cycle_record.hpp"
#include "support/effort.hpp"
#include "support/planner_bench.hpp"
#include "support/random_scene.hpp"

namespace hidwa_local_planner {
namespace {

using test::effort;
using test::PlannerBench;
using test::random_scene;
using test::Scene;

// The rule in its plainest form: the smallest total of those that nobody rejects, of equals the one that the tie rule
// prefers.
int cheapest(const std::vector<CandidateReport>& candidates, const Parameters& p, const Twist2& last) {
  double lowest = std::numeric_limits<double>::infinity();
  for (const CandidateReport& candidate : candidates) {
    if (candidate.legal() && candidate.total < lowest) lowest = candidate.total;
  }
  const TieRule tie(p, last);
  int best = -1;
  for (std::size_t c = 0; c < candidates.size(); ++c) {
    if (!candidates[c].legal() || candidates[c].total > lowest + kEqual) continue;
    if (best < 0 || candidates[c].total < candidates[static_cast<std::size_t>(best)].total - kEqual ||
        tie.prefers(candidates[c].sample, candidates[static_cast<std::size_t>(best)].sample)) {
      best = static_cast<int>(c);
    }
  }
  return best;
}

const Decision& plan(PlannerBench& bench, Report report) {
  Sampling sampling;
  sampling.report = report;
  const Scene& scene = bench.scene();
  return bench.planner().plan(scene.situation, scene.grid(), scene.intent, sampling);
}

TEST(FullReport, TheDecisionIsTheSameToTheBit) {
  for (std::uint64_t seed = 0; seed < effort<std::uint64_t>(150, 400); ++seed) {
    PlannerBench legality(random_scene(seed)), full(random_scene(seed));
    for (int cycle = 0; cycle < 2; ++cycle) {  // what critics remember must not have changed either
      const Decision &a = plan(legality, Report::legality), &b = plan(full, Report::full);
      ASSERT_TRUE(identical(record::decision_record(a, legality.planner().totals()),
                            record::decision_record(b, full.planner().totals())))
          << seed;
    }
  }
}

// In the order of the planner's names, and who came first in the cycle is among them.
void expect_consistent(const CandidateReport& candidate, const Scene& scene) {
  EXPECT_EQ(candidate.legal(), std::isfinite(candidate.total));
  for (std::size_t i = 1; i < candidate.rejections.size(); ++i) {
    EXPECT_NE(candidate.rejections[i].name, "Collision");
    EXPECT_NE(candidate.rejections[i].name, candidate.rejections[i - 1].name);
  }
  // Who is legal was scored by the same sum; only direct control leaves the critics' scores out.
  if (candidate.legal() && scene.intent.influence != Influence::direct) {
    EXPECT_NEAR(candidate.total, candidate.sum(), 1e-9 * (1.0 + std::abs(candidate.sum())));
  }
}

TEST(FullReport, ExplainsTheChoice) {
  int chosen = 0, rejected_twice = 0;
  for (std::uint64_t seed = 0; seed < effort<std::uint64_t>(150, 400); ++seed) {
    const Scene scene = random_scene(seed);
    PlannerBench bench(scene);
    const Decision& decision = plan(bench, Report::full);
    const Planner& planner = bench.planner();
    const std::vector<CandidateReport> all = planner.candidates();
    if (decision.candidates == 0 || all.empty()) continue;
    ASSERT_EQ(all.size(), decision.candidates);
    for (const CandidateReport& candidate : all) {
      expect_consistent(candidate, scene);
      rejected_twice += candidate.rejections.size() > 1 ? 1 : 0;
    }
    const int best = cheapest(all, scene.parameters, scene.situation.last_command);
    EXPECT_EQ(best, planner.marked().best) << seed;
    if (best < 0) continue;
    ++chosen;
    if (planner.choice().rule == ChoiceReport::Rule::escape) continue;  // out of a collision
    EXPECT_EQ(planner.choice().rule, ChoiceReport::Rule::cheapest);
    EXPECT_EQ(all[static_cast<std::size_t>(best)].sample, decision.sample);
  }
  EXPECT_GT(chosen, effort(94, 250));
  EXPECT_GT(rejected_twice, effort(400, 1000));
}

// A critic that gives no numbers rejects by that: it is named, though it never says so itself.
class NotANumber : public Critic {
 public:
  double configure(const Parameters&, const ParameterSource&) override { return 1.0; }
  void score(const CycleView&, const Tile& tile, TileScores& scores) override {
    for (std::size_t c = 0; c < tile.count; ++c) scores.set(c, tile.v[c] > 0.2 ? NAN : 0.0);
  }
};

TEST(FullReport, NamesTheCriticThatGivesNoNumber) {
  CriticRegistry registry = critics::built_in();
  registry.add("NotANumber", [] { return std::make_shared<NotANumber>(); });
  Scene scene = Scene::empty();
  scene.parameters.critics += " NotANumber";
  PlannerBench bench(scene, registry);
  plan(bench, Report::full);
  int fast = 0;
  for (const CandidateReport& candidate : bench.planner().candidates()) {
    if (candidate.sample.v <= 0.2) continue;
    ++fast;
    ASSERT_FALSE(candidate.legal());
    EXPECT_EQ(candidate.rejections.back().name, "NotANumber");
  }
  EXPECT_GT(fast, 10);
}

TEST(FullReport, IsEmptyWhereNothingWasScored) {
  PlannerBench bench(Scene::empty());
  const Planner& planner = bench.planner();
  plan(bench, Report::full);
  EXPECT_EQ(planner.candidates().size(), planner.totals().size());
  EXPECT_FALSE(planner.candidates().empty());
  bench.scene().intent.influence = Influence::stop;
  plan(bench, Report::full);
  EXPECT_TRUE(planner.candidates().empty());
  EXPECT_EQ(planner.choice().rule, ChoiceReport::Rule::none);
}

}  // namespace
}  // namespace hidwa_local_planner
