// SPDX-License-Identifier: BSD-3-Clause
#include "study/plan.hpp"

#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>

#include <gtest/gtest.h>

namespace hidwa_local_planner {
namespace study {
namespace {

const std::vector<std::string> kAll{"SG", "SJ", "SW"};

TEST(Plan, SjAndSwAreCounterbalancedAndSgIsLast) {
  const Plan plan = make_plan("run", 32, kAll, {{}}, false);
  ASSERT_EQ(plan.runs.size(), 96u);
  std::map<std::string, std::map<int, int>> count;
  std::map<int, std::set<int>> orders;
  for (const auto& run : plan.runs) {
    ++count[run.condition][run.order];
    orders[run.participant].insert(run.order);
  }
  EXPECT_EQ(count["SJ"][1], 16);
  EXPECT_EQ(count["SJ"][2], 16);
  EXPECT_EQ(count["SW"][1], 16);
  EXPECT_EQ(count["SW"][2], 16);
  EXPECT_EQ(count["SG"][3], 32);
  for (const auto& participant : orders) EXPECT_EQ(participant.second, (std::set<int>{1, 2, 3}));
}

TEST(Plan, OrdersHaveNoGapsWithFewerConditions) {
  for (const auto& run : make_plan("run", 4, {"SG", "SW"}, {{}}, false).runs) {
    EXPECT_EQ(run.order, run.condition == "SW" ? 1 : 2);
  }
}

TEST(Plan, ThePilotsSettingsAreThePapersAndBalanced) {
  const Plan plan = make_plan("pilot", 8, {"SJ"}, pilot_settings(), true);
  ASSERT_EQ(plan.runs.size(), 32u);
  EXPECT_EQ(to_string(plan.settings[1]), "s_v=400;s_omega=800;delta=2");
  std::map<std::pair<std::size_t, int>, int> places;
  std::map<int, std::map<int, std::size_t>> by_person;
  for (const auto& run : plan.runs) {
    ++places[{run.setting, run.order}];
    by_person[run.participant][run.order] = run.setting;
  }
  ASSERT_EQ(places.size(), 16u);
  for (const auto& place : places) EXPECT_EQ(place.second, 2);
  std::map<std::pair<std::size_t, std::size_t>, int> after;
  for (const auto& person : by_person) {
    for (int order = 2; order <= 4; ++order) ++after[{person.second.at(order - 1), person.second.at(order)}];
  }
  ASSERT_EQ(after.size(), 12u);
  for (const auto& pair : after) EXPECT_EQ(pair.second, 2);
}

TEST(Plan, RunsAreSortedAndTheirIdsAreUnique) {
  const Plan plan = make_plan("sweep", 11, kAll, std::vector<Setting>(12, Setting{{"delta", "1"}}), false);
  for (std::size_t i = 1; i < plan.runs.size(); ++i) EXPECT_LT(plan.runs[i - 1].id, plan.runs[i].id);
}

TEST(Plan, ShardsShareTheRunsOut) {
  const Plan plan = make_plan("run", 5, kAll, {{}}, false);
  std::multiset<std::string> all;
  for (std::size_t k = 1; k <= 4; ++k) {
    for (const auto& run : shard(plan.runs, k, 4)) all.insert(run.id);
  }
  EXPECT_EQ(all.size(), plan.runs.size());
  EXPECT_EQ(std::set<std::string>(all.begin(), all.end()).size(), plan.runs.size());
  EXPECT_EQ(shard(plan.runs, 1, 1).size(), plan.runs.size());
  EXPECT_TRUE(shard(plan.runs, 20, 20).empty());
}

TEST(Plan, IsReadAsItWasWritten) {
  const std::string csv = to_csv(make_plan("pilot", 3, {"SJ"}, pilot_settings(), true));
  const Plan plan = plan_from_csv(csv);
  EXPECT_EQ(to_csv(plan), csv);
  EXPECT_EQ(plan.experiment, "pilot");
  EXPECT_EQ(plan.settings.size(), 4u);
  EXPECT_THROW(plan_from_csv("something else\n"), std::invalid_argument);
  EXPECT_THROW(plan_from_csv("id,participant,condition,order,setting\nrun\n"), std::invalid_argument);
}

}  // namespace
}  // namespace study
}  // namespace hidwa_local_planner
