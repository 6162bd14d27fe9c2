// SPDX-License-Identifier: BSD-3-Clause
#include "control/sample_budget.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace hidwa_local_planner {
namespace {

using Event = SampleBudget::Event;
constexpr double kBudget = 0.025;  // [s]

SampleBudget budget_for(int vx_samples, int vth_samples) {
  SampleBudget budget;
  budget.configure({vx_samples, vth_samples});
  return budget;
}

double candidates(const SampleBudget& budget) {
  return static_cast<double>(budget.in_force().vx_samples) * budget.in_force().vth_samples;
}

void expect_samples(const SampleBudget& budget, int vx_samples, int vth_samples) {
  EXPECT_EQ(budget.in_force().vx_samples, vx_samples);
  EXPECT_EQ(budget.in_force().vth_samples, vth_samples);
}

/// The last event of `count` cycles of `duration` [s].
Event cycles(SampleBudget& budget, int count, double duration) {
  Event last = Event::none;
  for (int i = 0; i < count; ++i) {
    const Event event = budget.observe(duration, kBudget);
    if (event != Event::none) last = event;
  }
  return last;
}

/// Of 20 x 20 samples by three cycles of twice the budget: 0.7 / 2 of 400 candidates are 140, and 10 x 10 is the first
/// of 18 x 18, 16 x 16, ... below.
SampleBudget thinned_to_10_x_10() {
  SampleBudget budget = budget_for(20, 20);
  cycles(budget, 3, 2.0 * kBudget);
  expect_samples(budget, 10, 10);
  return budget;
}

TEST(SampleBudget, WhatTheParametersAskFor) {
  Parameters parameters;
  parameters.vx_samples = 7;
  parameters.vth_samples = 9;
  EXPECT_EQ(configured_samples(parameters).vx_samples, 7);
  EXPECT_EQ(configured_samples(parameters).vth_samples, 9);
  parameters.cycle_budget = 0.0;
  EXPECT_EQ(cycle_budget(parameters, 0.1), 0.05);
  parameters.cycle_budget = 0.02;
  EXPECT_EQ(cycle_budget(parameters, 0.1), 0.02);
  parameters.cycle_budget = -1.0;
  EXPECT_LT(cycle_budget(parameters, 0.1), 0.0);
}

TEST(SampleBudget, AllSamplesWhileThereIsTime) {
  SampleBudget budget = budget_for(20, 20);
  expect_samples(budget, 20, 20);
  EXPECT_EQ(cycles(budget, 1000, kBudget), Event::none);
  expect_samples(budget, 20, 20);
  EXPECT_FALSE(budget.thinned());
}

TEST(SampleBudget, TwoOutliersInFiveChangeNothingThreeDo) {
  SampleBudget first = budget_for(20, 20);  // the first three cycles may thin
  EXPECT_EQ(cycles(first, 2, 0.05), Event::none);
  EXPECT_EQ(cycles(first, 1, 0.05), Event::thinning_began);
  SampleBudget budget = budget_for(20, 20);
  for (int i = 0; i < 100; ++i) {
    EXPECT_EQ(cycles(budget, 3, 0.002), Event::none);
    EXPECT_EQ(cycles(budget, 2, 1.0), Event::none);
  }
  EXPECT_EQ(cycles(budget, 1, 1.0), Event::thinning_began);
}

// 2.8 s for 20 x 20 candidates where 1 s is to be had: 0.7 of that affords 400 x 0.7 / 2.8 = 100 = 10 x 10, and so many
// are left.
TEST(SampleBudget, AsManyAreLeftAsCanBeAfforded) {
  SampleBudget budget = budget_for(20, 20);
  for (int i = 0; i < 3; ++i) budget.observe(2.8, 1.0);
  expect_samples(budget, 10, 10);
}

TEST(SampleBudget, ThinsInProportionToWhatIsTooLong) {
  thinned_to_10_x_10();
  // 400 x 20: level k takes k of the 197 pairs of one axis and k 7 / 197 of the 7 of the other. Of 8000
  // candidates 2800 are affordable: 248 x 14 = 3472 at level 76, ..., 204 x 14 = 2856 at 98, 202 x 12 = 2424
  // at 99, where 99 x 7 / 197 = 3.52 rounds to 4 pairs.
  SampleBudget wide = budget_for(400, 20);
  cycles(wide, 3, 2.0 * kBudget);
  expect_samples(wide, 202, 12);
}

TEST(SampleBudget, OddCountsStayOddAndSmallOnesAsTheyAre) {
  struct Row {
    int vx, vth, fewest_vx, fewest_vth;
  };
  for (const Row& row : {Row{21, 15, 5, 5}, Row{20, 40, 6, 6}, Row{3, 20, 3, 6}, Row{5, 4, 5, 4}}) {
    SampleBudget budget = budget_for(row.vx, row.vth);
    cycles(budget, 100, 1.0);
    expect_samples(budget, row.fewest_vx, row.fewest_vth);
  }
}

TEST(SampleBudget, ComesBackStepByStepAfterACalmWhile) {
  SampleBudget budget = thinned_to_10_x_10();
  // No thinning followed a return yet: each step takes 40 calm cycles. 12 x 12 is 1.44 times as many.
  for (const int count : {12, 14, 16, 18}) {
    EXPECT_EQ(cycles(budget, 39, 0.002), Event::none);
    expect_samples(budget, count - 2, count - 2);
    EXPECT_EQ(cycles(budget, 1, 0.002), Event::none);
    expect_samples(budget, count, count);
  }
  EXPECT_EQ(cycles(budget, 40, 0.002), Event::thinning_ended);
  expect_samples(budget, 20, 20);
}

TEST(SampleBudget, StaysWhereAStepMoreWouldLeaveNoRoom) {
  SampleBudget budget = thinned_to_10_x_10();
  // 144 candidates instead of 100 would take 1.44 x 0.56 = 0.806 of the budget: more than 0.8.
  cycles(budget, 1000, 0.56 * kBudget);
  expect_samples(budget, 10, 10);
  cycles(budget, 40, 0.55 * kBudget);  // 0.792
  expect_samples(budget, 12, 12);
}

TEST(SampleBudget, OneOutlierPutsAReturnOff) {
  SampleBudget budget = thinned_to_10_x_10();
  cycles(budget, 39, 0.002);
  cycles(budget, 1, 1.0);  // costs half of the 40: 19 are left
  cycles(budget, 20, 0.002);
  expect_samples(budget, 10, 10);
  cycles(budget, 1, 0.002);
  expect_samples(budget, 12, 12);
}

/// Changes of the samples in force over `count` cycles that take `fixed` + `each` x candidates [s].
int changes(SampleBudget& budget, int count, double fixed, double each) {
  int seen = 0;
  for (int i = 0; i < count; ++i) {
    const double before = candidates(budget);
    budget.observe(fixed + each * before, kBudget);
    if (candidates(budget) != before) ++seen;
  }
  return seen;
}

TEST(SampleBudget, SettlesUnderEveryConstantLoad) {
  for (const auto& [vx_samples, vth_samples] : {std::pair{20, 20}, {400, 400}, {5, 99}, {21, 7}}) {
    for (const double fixed : {0.0, 0.3 * kBudget, 0.9 * kBudget, 3.0 * kBudget}) {
      for (double load = 0.2; load < 200.0; load *= 1.3) {  // of all samples, in budgets
        SampleBudget budget = budget_for(vx_samples, vth_samples);
        const double each = load * kBudget / candidates(budget);
        changes(budget, 20, fixed, each);
        const Sampling settled = budget.in_force();
        const bool fewest = settled.vx_samples <= 6 && settled.vth_samples <= 6;
        const double duration = fixed + each * candidates(budget);
        EXPECT_TRUE(duration <= kBudget || fewest) << duration;
        // From here on samples only come back, and the end of that is for good.
        double most = candidates(budget);
        for (int i = 0; i < 5000; ++i) {
          budget.observe(fixed + each * candidates(budget), kBudget);
          EXPECT_GE(candidates(budget), most);
          most = candidates(budget);
        }
        EXPECT_EQ(changes(budget, 5000, fixed, each), 0);
      }
    }
  }
}

TEST(SampleBudget, ReturnsThatWereTooEarlyBecomeRare) {
  // A load that comes whenever all samples are back: 3 cycles thin to 10 x 10, five returns follow.
  SampleBudget budget = budget_for(20, 20);
  std::vector<int> between;  // cycles from one thinning to the next
  int since = 0;
  for (int i = 0; i < 20000; ++i) {
    const bool all = !budget.thinned();
    ++since;
    if (budget.observe(all ? 2.0 * kBudget : 0.002, kBudget) == Event::thinning_began) {
      between.push_back(since);
      since = 0;
    }
  }
  // 5 returns of 40, 80, 160, 320, 640 and no more cycles each, and the 3 that thin; the first has no return.
  ASSERT_GE(between.size(), 7u);
  EXPECT_EQ(std::vector<int>(between.begin(), between.begin() + 7),
            (std::vector<int>{3, 203, 403, 803, 1603, 3203, 3203}));
}

TEST(SampleBudget, PatienceReturnsAfterALongCalmWithAllSamples) {
  SampleBudget budget = thinned_to_10_x_10();
  cycles(budget, 5 * 40, 0.002);
  cycles(budget, 3, 2.0 * kBudget);  // too early: 80 cycles a step from now on
  cycles(budget, 5 * 80, 0.002);
  expect_samples(budget, 20, 20);
  cycles(budget, 640, 0.002);
  cycles(budget, 3, 2.0 * kBudget);
  expect_samples(budget, 10, 10);
  cycles(budget, 40, 0.002);
  expect_samples(budget, 12, 12);
}

TEST(SampleBudget, OtherSamplesStartAnewTheSameOnesDoNot) {
  SampleBudget budget = budget_for(20, 20);
  cycles(budget, 3, 1.0);
  EXPECT_TRUE(budget.thinned());
  budget.configure({20, 20});
  EXPECT_TRUE(budget.thinned());
  budget.configure({20, 18});
  EXPECT_FALSE(budget.thinned());
  expect_samples(budget, 20, 18);
  EXPECT_EQ(cycles(budget, 2, 1.0), Event::none);  // what was before counts no more
}

TEST(SampleBudget, ANegativeBudgetNeverThins) {
  SampleBudget budget = budget_for(20, 20);
  for (int i = 0; i < 100; ++i) EXPECT_EQ(budget.observe(100.0, -1.0), Event::none);
  cycles(budget, 3, 1.0);
  EXPECT_TRUE(budget.thinned());
  EXPECT_EQ(budget.observe(100.0, -1.0), Event::thinning_ended);
  expect_samples(budget, 20, 20);
}

TEST(SampleBudget, TheComplaintNamesCountsAndRemedy) {
  EXPECT_EQ(thinning_complaint({20, 20}, {20, 20}, 0.025), "");
  const std::string said = thinning_complaint({10, 12}, {20, 24}, 0.025);
  EXPECT_NE(said.find("budget of 25.0 ms"), std::string::npos) << said;
  EXPECT_NE(said.find("from 20 x 24 to 10 x 12;"), std::string::npos) << said;
  EXPECT_NE(said.find("lower vx_samples or vth_samples, raise cycle_budget"), std::string::npos) << said;
  EXPECT_NE(thinning_complaint({6, 5}, {20, 21}, 0.025).find("to 6 x 5, the fewest;"), std::string::npos);
}

}  // namespace
}  // namespace hidwa_local_planner
