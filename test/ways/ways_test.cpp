// SPDX-License-Identifier: BSD-3-Clause
// The short form: few scenes of each kind that needs no file. scripts/ways runs the long one.
#include <cstdio>
#include <string>

#include <gtest/gtest.h>

#include "support/effort.hpp"
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
  const std::vector<Result> results =
      run(short_form(drawn_kinds().size(), hidwa_local_planner::test::effort(2, kBodies), 1));
  const std::vector<Summary> summaries = summaries_of(results);
  const Summary& all = summaries.back();
  std::printf("%s%s", table(summaries).c_str(), failures(results).c_str());
  EXPECT_EQ(all.contacts, 0);
  EXPECT_EQ(all.unverified, 0) << "ways that the slow check does not confirm";
  EXPECT_EQ(all.none_through, 0) << "drives where there is no way";
  EXPECT_GE(2 * all.sure, all.scenes) << "too few scenes with a way to say anything";
  EXPECT_EQ(all.nearer, all.sure);
  EXPECT_EQ(all.through, all.sure);
  EXPECT_EQ(all.failed, all.none);
}

// Scenes that were missed once: the search took too long (0.025 m and 0.1 m cells), a way that turns back was left
// before it did, two ways took turns, or a robot that crept into a corner said so too late.
TEST(Ways, OfThoseMissedOnceNoneIs) {
  const struct {
    const char* kind;
    std::uint64_t seed;
  } scenes[] = {{"posts", 61019},    {"dead_end", 61138}, {"doorway", 60006},  {"doorway", 61104}, {"doorway", 61140},
                {"corridor", 50014}, {"corridor", 50038}, {"corridor", 61015}, {"corner", 50015},  {"boxes", 61094}};
  std::size_t driven = 0;
  const std::size_t step = hidwa_local_planner::test::effort<std::size_t>(5, 1);
  for (std::size_t k = 0; k < std::size(scenes); k += step) {
    const auto& scene = scenes[k];
    for (const Kind& kind : drawn_kinds()) {
      if (kind.name != scene.kind) continue;
      ++driven;
      const Result result = run_scene(kind, scene.seed, nullptr).result;
      EXPECT_TRUE(result.good()) << in_words(result) << "; --scene " << scene.kind << " --seed " << scene.seed;
      EXPECT_NE(result.answer, Class::open);
    }
  }
  EXPECT_EQ(driven, (std::size(scenes) + step - 1) / step);
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
