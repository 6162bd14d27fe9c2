// SPDX-License-Identifier: BSD-3-Clause
// The short form of the campaign: few drives under each promised condition. scripts/attack runs the long one.
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <string>

#include <gtest/gtest.h>

#include "campaign.hpp"
#include "drive.hpp"
#include "report.hpp"
#include "support/effort.hpp"

namespace hidwa_attack {

// How gtest names a condition in its output.
void PrintTo(const Condition& condition, std::ostream* out) { *out << condition.name; }

namespace {

constexpr int kSeconds = 20;

// Under the thread sanitizer a drive takes many times as long, and a race shows in the first that run side by side.
#ifdef HIDWA_SANITIZED_THREADS
constexpr int kDrives = 4;
#else
const int kDrives = hidwa_local_planner::test::effort(2, 16);
#endif

// Seeds from here on found most of what the long form did when it was first run.
constexpr std::uint64_t kFirst = 78;

std::vector<Condition> promised() {
  std::vector<Condition> conditions;
  for (const Condition& condition : all_conditions()) {
    if (condition.promised) conditions.push_back(condition);
  }
  return conditions;
}

class Attack : public testing::TestWithParam<Condition> {};

TEST_P(Attack, Holds) {
  Extent extent;
  extent.drives = kDrives;
  extent.first_seed = kFirst;
  extent.seconds = kSeconds;
  const Summary summary(GetParam(), run(GetParam(), extent));
  std::printf("%s", table_line(summary).c_str());
  EXPECT_EQ(summary.contacts, 0) << "drives that touched, worst by " << 1e3 * summary.worst_depth << " mm; alone:\n"
                                 << how_to_repeat(summary, kSeconds);
  EXPECT_EQ(summary.beyond, 0) << "commands beyond the bound; alone:\n" << how_to_repeat(summary, kSeconds);
  EXPECT_EQ(summary.hard, 0) << "commands beyond the acceleration limits; alone:\n" << how_to_repeat(summary, kSeconds);
  // Who stands still touches nothing; of those that begin in collision some have no way out.
  EXPECT_GT(summary.moving, summary.stood_in > 0 ? 0.05 : 0.2);
}

INSTANTIATE_TEST_SUITE_P(Conditions, Attack, testing::ValuesIn(promised()),
                         [](const testing::TestParamInfo<Condition>& tested) {
                           return std::string(tested.param.name);
                         });

TEST(Campaign, ComesNearObstaclesAtSpeed) {
  const Condition& condition = *find_condition("speed_1");
  Extent extent;
  extent.drives = 6;
  extent.seconds = kSeconds;
  const Summary summary(condition, run(condition, extent));
  EXPECT_GT(summary.threatened, summary.cycles / 20);
}

TEST(Campaign, SeesAContactWhereTheBrakesAreWorseThanTold) {
  const Condition& condition = *find_condition("out_latency_more");
  Extent extent;
  extent.drives = 40;  // a third of them touch
  extent.seconds = kSeconds;
  EXPECT_GT(Summary(condition, run(condition, extent)).contacts, 0);
}

TEST(Campaign, TheSameSeedIsTheSameDrive) {
  const Condition& condition = *find_condition("anything");
  Extent one, two;
  one.drives = two.drives = 4;
  one.seconds = two.seconds = 5;
  two.threads = 3;
  const Summary a(condition, run(condition, one)), b(condition, run(condition, two));
  EXPECT_EQ(as_json({a}, 5), as_json({b}, 5));
}

}  // namespace
}  // namespace hidwa_attack
