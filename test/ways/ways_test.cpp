// SPDX-License-Identifier: BSD-3-Clause
// The short form: few scenes of each kind that needs no file. scripts/ways runs the long one.
#include <cstdio>
#include <string>

#include <gtest/gtest.h>

#include "ways/campaign.hpp"
#include "ways/report.hpp"

namespace hidwa_ways {
namespace {

Extent short_form(std::size_t kinds, int scenes, int threads) {
  Extent extent;
  for (std::size_t k = 0; k < kinds; ++k) extent.kinds.push_back(&drawn_kinds()[k]);
  extent.scenes = scenes;
  extent.threads = threads;
  return extent;
}

// Every way that is there is driven, and where there is none that is said. Of the thousands of scripts/ways a few may
// be missed; of these none is.
TEST(Ways, EveryWayIsDrivenAndNothingIsTouched) {
  const std::vector<Result> results = run(short_form(drawn_kinds().size(), kBodies, 1));
  const std::vector<Summary> summaries = summaries_of(results);
  const Summary& all = summaries.back();
  std::printf("%s%s", table(summaries).c_str(), failures(results).c_str());
  EXPECT_EQ(all.contacts, 0);
  EXPECT_EQ(all.unverified, 0) << "ways that the slow check does not confirm";
  EXPECT_EQ(all.none_through, 0) << "drives where there is no way";
  EXPECT_GT(2 * all.sure, all.scenes) << "too few scenes with a way to say anything";
  EXPECT_EQ(all.nearer, all.sure);
  EXPECT_EQ(all.through, all.sure);
  EXPECT_EQ(all.failed, all.none);
}

TEST(Ways, TheSameSeedIsTheSameDrive) {
  const std::vector<Result> one = run(short_form(3, 1, 1)), two = run(short_form(3, 1, 3));
  for (std::size_t k = 0; k < one.size(); ++k) {
    EXPECT_EQ(one[k].print, two[k].print) << one[k].repeat;
    EXPECT_EQ(one[k].answer, two[k].answer) << one[k].repeat;
    EXPECT_EQ(one[k].way_length, two[k].way_length) << one[k].repeat;
  }
}

}  // namespace
}  // namespace hidwa_ways
