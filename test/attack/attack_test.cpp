// SPDX-License-Identifier: BSD-3-Clause
// The short form of the campaign: few drives under each promised condition. scripts/attack runs the long one.
#include <cstdint>
#include <ostream>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "conditions.hpp"
#include "drive.hpp"
#include "support/effort.hpp"

namespace hidwa_attack {

// How gtest names a condition in its output.
void PrintTo(const Condition& condition, std::ostream* out) { *out << condition.name; }

namespace {

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
  const std::uint64_t drives = hidwa_local_planner::test::effort(2, 16);
  int cycles = 0, moving = 0;
  bool stood_in = false;
  for (std::uint64_t seed = kFirst; seed < kFirst + drives; ++seed) {
    const DriveResult result = drive(spec_of(GetParam(), seed), seed);
    const std::string alone = "; alone: hidwa_study attack --out DIR --condition " + std::string(GetParam().name) +
                              " --drive 0 --seed " + std::to_string(seed);
    EXPECT_FALSE(result.touched) << "by " << 1e3 * result.depth << " mm" << alone;
    EXPECT_EQ(result.beyond, 0) << "commands beyond the bound" << alone;
    EXPECT_EQ(result.hard, 0) << "commands beyond the acceleration limits" << alone;
    cycles += result.cycles;
    moving += result.moving;
    stood_in = stood_in || result.stood_in;
  }
  // Who stands still touches nothing; of those that begin in collision some have no way out.
  EXPECT_GT(moving, (stood_in ? 0.05 : 0.2) * cycles);
}

INSTANTIATE_TEST_SUITE_P(Conditions, Attack, testing::ValuesIn(promised()),
                         [](const testing::TestParamInfo<Condition>& tested) {
                           return std::string(tested.param.name);
                         });

TEST(Campaign, ComesNearObstaclesAtSpeed) {
  int cycles = 0, threatened = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const DriveResult result = drive(spec_of(*find_condition("speed_1"), seed), seed);
    cycles += result.cycles;
    threatened += result.threatened;
  }
  EXPECT_GT(threatened, cycles / 20);
}

TEST(Campaign, SeesAContactWhereTheBrakesAreWorseThanTold) {
  int touched = 0;  // a third of them touch
  for (std::uint64_t seed = 1; seed <= 40 && touched == 0; ++seed) {
    touched += drive(spec_of(*find_condition("out_latency_more"), seed), seed).touched;
  }
  EXPECT_GT(touched, 0);
}

TEST(Campaign, TheSameSeedIsTheSameDrive) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    Spec spec = spec_of(*find_condition("anything"), seed);
    spec.seconds = 5;
    std::ostringstream first, second;
    drive(spec, seed, &first);
    drive(spec, seed, &second);
    EXPECT_EQ(first.str(), second.str());
  }
}

}  // namespace
}  // namespace hidwa_attack
