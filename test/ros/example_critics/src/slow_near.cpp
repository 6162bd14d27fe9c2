// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include <pluginlib/class_list_macros.hpp>

#include "hidwa_local_planner/core/critic.hpp"

namespace hidwa_example_critics {

using hidwa_local_planner::CycleView;
using hidwa_local_planner::Parameters;
using hidwa_local_planner::ParameterSource;
using hidwa_local_planner::PlanDistance;
using hidwa_local_planner::Tile;
using hidwa_local_planner::TileScores;

/// Makes driving cost near the path or the goal: `scale` for every m/s above the speed that is allowed there.
///   to: [goal]               which of `path` and `goal`; the nearer one counts
///   distances: [1.0, 0.5]    within these [m] ...
///   speeds: [0.3, 0.1]       ... these are allowed [m/s]
///   measured_at: centre      `centre` or `nose`, which is PathAlign's
class SlowNear : public hidwa_local_planner::Critic {
 public:
  double configure(const Parameters& parameters, const ParameterSource& own) override {
    distances_ = own.numbers("distances", {1.0, 0.5});
    speeds_ = own.numbers("speeds", {0.3, 0.1});
    if (distances_.size() != speeds_.size()) throw std::invalid_argument("SlowNear: as many speeds as distances");
    targets_.clear();
    for (const std::string& to : own.words("to", {"goal"})) {
      if (to != "path" && to != "goal") throw std::invalid_argument("SlowNear/to: expected path or goal, found " + to);
      targets_.push_back(to == "path" ? PlanDistance::to_path() : PlanDistance::to_goal());
    }
    forward_ = own.word("measured_at", "centre") == "nose" ? parameters.forward_point_distance : 0.0;
    return own.number("scale", 1.0);
  }

  void score(const CycleView& /*cycle*/, const Tile& tile, TileScores& scores) override {
    found_.resize(tile.count);
    nearest_.assign(tile.count, std::numeric_limits<double>::infinity());
    for (const PlanDistance& target : targets_) {
      tile.distances(target, forward_, scores, found_.data());
      for (std::size_t c = 0; c < tile.count; ++c) {
        if (found_[c] >= 0.0) nearest_[c] = std::min(nearest_[c], found_[c]);
      }
    }
    for (std::size_t c = 0; c < tile.count; ++c) {
      scores.set(c, std::max(0.0, std::abs(tile.v[c]) - allowed(nearest_[c])));
    }
  }

 private:
  double allowed(double distance) const {
    double speed = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < distances_.size(); ++k) {
      if (distance <= distances_[k]) speed = std::min(speed, speeds_[k]);
    }
    return speed;
  }

  std::vector<PlanDistance> targets_;
  std::vector<double> distances_;  // [m]
  std::vector<double> speeds_;     // [m/s]
  double forward_ = 0.0;           // [m]
  std::vector<double> found_, nearest_;
};

}  // namespace hidwa_example_critics

PLUGINLIB_EXPORT_CLASS(hidwa_example_critics::SlowNear, hidwa_local_planner::Critic)
