// SPDX-License-Identifier: BSD-3-Clause
#include "ros/guarded_critic.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

namespace hidwa_local_planner {
namespace {

constexpr std::size_t kCandidates = 3;

/// Does what it is told to.
class Told : public Critic {
 public:
  bool prepare_throws = false;
  bool score_throws = false;
  double score_of_all = 1.0;

  double configure(const Parameters& /*parameters*/, const ParameterSource& /*own*/) override {
    if (score_throws) throw std::runtime_error("no such table");
    if (prepare_throws) throw 42;
    return 2.0;
  }
  void prepare(const CycleView& /*cycle*/) override {
    if (prepare_throws) throw 42;
  }
  void score(const CycleView& /*cycle*/, const Tile& /*tile*/, TileScores& scores) override {
    scores.reject(0, "its own reason");
    scores.set(1, score_of_all);
    if (score_throws) throw std::runtime_error("no such row");
  }
  void debrief(const CycleView& /*cycle*/, const Twist2& /*command*/) override { throw std::runtime_error("full"); }
  void reset() override { throw std::runtime_error("full"); }
};

class GuardedCritics : public ::testing::Test {
 protected:
  /// The reasons of a cycle, nullptr where a candidate is legal.
  std::array<const char*, kCandidates> cycle() {
    raw_.fill(0.0);
    std::array<const char*, kCandidates> reasons{};
    TileScores scores(raw_.data(), reasons.data(), kCandidates);
    guarded_.prepare(view_);
    guarded_.score(view_, tile_, scores);
    return reasons;
  }

  std::shared_ptr<Told> told_ = std::make_shared<Told>();
  GuardedCritic guarded_{"other/Told", told_};
  std::array<double, kCandidates> raw_{};
  CycleView view_;
  Tile tile_;
};

TEST_F(GuardedCritics, WhatItSaysCounts) {
  const auto reasons = cycle();
  EXPECT_STREQ(reasons[0], "its own reason");
  EXPECT_EQ(reasons[1], nullptr);
  EXPECT_EQ(reasons[2], nullptr);
  EXPECT_EQ(raw_[1], 1.0);
  EXPECT_EQ(guarded_.configure(Parameters(), ParameterSource()), 2.0);
}

TEST_F(GuardedCritics, WhereItThrowsEverythingIsRejectedUntilTheNextCycle) {
  told_->score_throws = true;
  auto reasons = cycle();
  EXPECT_STREQ(reasons[0], "its own reason");
  EXPECT_STREQ(reasons[1], "it failed with an exception");
  EXPECT_STREQ(reasons[2], "it failed with an exception");
  told_->score_throws = false;
  told_->prepare_throws = true;
  reasons = cycle();
  for (const char* reason : reasons) EXPECT_STREQ(reason, "it failed with an exception");
  told_->prepare_throws = false;
  EXPECT_EQ(cycle()[1], nullptr);
}

TEST_F(GuardedCritics, ScoresThatAreNoNumbersAreLeftToThePlanner) {
  told_->score_of_all = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(cycle()[1], nullptr);
  EXPECT_TRUE(std::isnan(raw_[1]));
}

TEST_F(GuardedCritics, OnlyConfigureThrows) {
  EXPECT_NO_THROW(guarded_.debrief(view_, Twist2{}));
  EXPECT_NO_THROW(guarded_.reset());
  EXPECT_EQ(guarded_.configure(Parameters(), ParameterSource()), 2.0);
}

TEST_F(GuardedCritics, WhatCannotBeConfiguredIsNamedWhateverItThrows) {
  const auto said = [this] {
    try {
      guarded_.configure(Parameters(), ParameterSource());
    } catch (const std::runtime_error& error) {
      return std::string(error.what());
    }
    return std::string("nothing");
  };
  told_->score_throws = true;
  EXPECT_EQ(said(), "other/Told: no such table; mend them, or take it out of the parameter critics");
  told_->score_throws = false;
  told_->prepare_throws = true;
  EXPECT_EQ(said(),
            "other/Told: something that is no std::exception; mend them, or take it out of the parameter critics");
}

}  // namespace
}  // namespace hidwa_local_planner
