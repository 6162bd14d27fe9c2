// SPDX-License-Identifier: BSD-3-Clause
#include <chrono>
#include <limits>
#include <stdexcept>
#include <thread>

#include <pluginlib/class_list_macros.hpp>

#include "hidwa_local_planner/core/critic.hpp"

namespace hidwa_broken_critics {

using hidwa_local_planner::CycleView;
using hidwa_local_planner::Parameters;
using hidwa_local_planner::ParameterSource;
using hidwa_local_planner::Tile;
using hidwa_local_planner::TileScores;

class CannotBeMade : public hidwa_local_planner::Critic {
 public:
  CannotBeMade() { throw std::runtime_error("no memory of its own"); }
  double configure(const Parameters& /*parameters*/, const ParameterSource& /*own*/) override { return 1.0; }
  void score(const CycleView& /*cycle*/, const Tile& /*tile*/, TileScores& /*scores*/) override {}
};

class CannotBeConfigured : public hidwa_local_planner::Critic {
 public:
  double configure(const Parameters& /*parameters*/, const ParameterSource& /*own*/) override {
    throw std::runtime_error("its table is missing");
  }
  void score(const CycleView& /*cycle*/, const Tile& /*tile*/, TileScores& /*scores*/) override {}
};

class Throws : public hidwa_local_planner::Critic {
 public:
  double configure(const Parameters& /*parameters*/, const ParameterSource& own) override {
    in_prepare_ = own.flag("in_prepare", false);
    return 1.0;
  }
  void prepare(const CycleView& /*cycle*/) override {
    if (in_prepare_) throw 42;
  }
  void score(const CycleView& /*cycle*/, const Tile& /*tile*/, TileScores& /*scores*/) override {
    throw std::runtime_error("its table has no such row");
  }

 private:
  bool in_prepare_ = false;
};

class ThrowsAtTheEnd : public hidwa_local_planner::Critic {
 public:
  double configure(const Parameters& /*parameters*/, const ParameterSource& /*own*/) override { return 1.0; }
  void score(const CycleView& /*cycle*/, const Tile& /*tile*/, TileScores& /*scores*/) override {}
  void debrief(const CycleView& /*cycle*/, const hidwa_local_planner::Twist2& /*command*/) override {
    throw std::runtime_error("its log is full");
  }
};

/// Takes a second for one cycle in forty.
class Hangs : public hidwa_local_planner::Critic {
 public:
  double configure(const Parameters& /*parameters*/, const ParameterSource& /*own*/) override { return 1.0; }
  void prepare(const CycleView& /*cycle*/) override {
    if (++cycles_ % 40 == 0) std::this_thread::sleep_for(std::chrono::seconds(1));
  }
  void score(const CycleView& /*cycle*/, const Tile& /*tile*/, TileScores& /*scores*/) override {}

 private:
  int cycles_ = 0;
};

/// Of what is faster than 0.2 m/s alone.
class HalfNotANumber : public hidwa_local_planner::Critic {
 public:
  double configure(const Parameters& /*parameters*/, const ParameterSource& /*own*/) override { return 1.0; }
  void score(const CycleView& /*cycle*/, const Tile& tile, TileScores& scores) override {
    for (std::size_t c = 0; c < scores.count(); ++c) {
      scores.set(c, tile.v[c] > 0.2 ? std::numeric_limits<double>::quiet_NaN() : 0.0);
    }
  }
};

}  // namespace hidwa_broken_critics

PLUGINLIB_EXPORT_CLASS(hidwa_broken_critics::Throws, hidwa_local_planner::Critic)
PLUGINLIB_EXPORT_CLASS(hidwa_broken_critics::ThrowsAtTheEnd, hidwa_local_planner::Critic)
PLUGINLIB_EXPORT_CLASS(hidwa_broken_critics::Hangs, hidwa_local_planner::Critic)
PLUGINLIB_EXPORT_CLASS(hidwa_broken_critics::HalfNotANumber, hidwa_local_planner::Critic)
PLUGINLIB_EXPORT_CLASS(hidwa_broken_critics::CannotBeMade, hidwa_local_planner::Critic)
PLUGINLIB_EXPORT_CLASS(hidwa_broken_critics::CannotBeConfigured, hidwa_local_planner::Critic)
