// SPDX-License-Identifier: BSD-3-Clause
#include "study/participant.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace hidwa_local_planner {
namespace study {
namespace {

TEST(Participant, TheSameNumberIsTheSamePerson) {
  const Participant a = draw_participant(1, 7), again = draw_participant(1, 7);
  const Participant other = draw_participant(1, 8), elsewhere = draw_participant(2, 7);
  for (const Trait& trait : traits()) {
    EXPECT_EQ(a.*trait.member, again.*trait.member) << trait.name;
    if (trait.spread.kind == Spread::Kind::fixed) continue;
    EXPECT_NE(a.*trait.member, other.*trait.member) << trait.name;
    EXPECT_NE(a.*trait.member, elsewhere.*trait.member) << trait.name;
  }
}

TEST(Participant, PeopleAreSpreadAsSaid) {
  std::vector<Participant> people;
  for (int i = 1; i <= 2000; ++i) people.push_back(draw_participant(3, i));
  for (const Trait& trait : traits()) {
    double sum = 0.0, least = 1e9, most = -1e9;
    for (const Participant& person : people) {
      const double value = person.*trait.member;
      sum += value;
      least = std::fmin(least, value);
      most = std::fmax(most, value);
    }
    const Spread& s = trait.spread;
    EXPECT_GE(least, s.low) << trait.name;
    EXPECT_LE(most, s.high) << trait.name;
    EXPECT_GE(s.low, trait.least) << trait.name;
    EXPECT_LE(s.high, trait.greatest) << trait.name;
    const double mean = sum / static_cast<double>(people.size());
    double expected = s.low;
    if (s.kind == Spread::Kind::normal) expected = s.mean;
    if (s.kind == Spread::Kind::uniform) expected = 0.5 * (s.low + s.high);
    if (s.kind == Spread::Kind::log_uniform) expected = (s.high - s.low) / std::log(s.high / s.low);
    EXPECT_NEAR(mean, expected, 0.05 * (s.high - s.low)) << trait.name;
  }
}

TEST(Participant, TraitsAreSetByName) {
  Participant person = draw_participant(1, 1);
  EXPECT_EQ(set_trait(person, "reaction_time", 1.25), "");
  EXPECT_EQ(person.reaction_time, 1.25);
  EXPECT_NE(set_trait(person, "reaction_time", -1.0).find("within 0 to 5"), std::string::npos);
  EXPECT_NE(set_trait(person, "reaction_time", NAN), "");
  EXPECT_NE(set_trait(person, "patience", 1.0).find("there are reaction_time"), std::string::npos);
  EXPECT_EQ(person.reaction_time, 1.25);
}

}  // namespace
}  // namespace study
}  // namespace hidwa_local_planner
