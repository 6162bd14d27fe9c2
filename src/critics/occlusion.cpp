// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "critics/built_in_entry.hpp"
#include "critics/speed_knots.hpp"
#include "hidwa_local_planner/core/critic.hpp"
#include "hidwa_local_planner/core/footprint.hpp"

namespace hidwa_local_planner::critics {
namespace {

// Time between two poses of the rollout that count [s].
constexpr double kTimesApart = 0.25;
// Until a robot that sees somebody begins to brake: two control periods of 20 Hz, besides the latency [s].
constexpr double kReaction = 0.1;
// A metre that is driven at full risk costs nearly what the progress is worth that it makes.
constexpr double kWeight = 20.0;
// Memory is reserved for this many candidates of a tile.
constexpr std::size_t kUsualCandidates = 256;

/// Driving fast past where somebody may step out, whom an obstacle hides. With the speed v, the braking limit a, the
/// reaction time t (control_latency and two periods) and s = occlusion_speed the robot needs
///
///   n(v) = s (t + v / a) + v (t + v / (2 a))                                 [m]
///
/// to come to rest before he is there. With the gap g from the robot's inscribed circle to the nearest such place:
///
///   integral over the rollout of (1 - g / n(v)) (v - blind_speed) dt         [m], where g < n(v) and v > blind_speed
class Occlusion : public Critic {
 public:
  double configure(const Parameters& parameters, const ParameterSource& /*own*/) override {
    speed_ = parameters.occlusion_speed;
    creep_ = parameters.blind_speed;
    reaction_ = parameters.control_latency + kReaction;
    braking_ = parameters.braking_x();
    knots_.reserve(kUsualCandidates);
    needed_.reserve(kUsualCandidates);
    sum_.reserve(kUsualCandidates);
    return parameters.occlusion == ::hidwa_local_planner::Occlusion::cost ? kWeight : 0.0;
  }

  void prepare(const CycleView& cycle) override {
    places_ = cycle.hidden_places;
    radius_ = cycle.hidden_radius + cycle.footprint->inscribed_radius();
  }

  void score(const CycleView& /*cycle*/, const Tile& tile, TileScores& scores) override {
    if (places_ == nullptr || places_->empty() || tile.steps == 0 || tile.count == 0) return;
    knots_.choose(tile);
    needed_.clear();
    sum_.assign(knots_.size(), 0.0);
    for (std::size_t i = 0; i < knots_.size(); ++i) needed_.push_back(needed(std::abs(tile.v[knots_[i]])));
    const auto stride = static_cast<std::size_t>(std::max(1.0, std::round(kTimesApart / tile.dt)));
    bool any = false;
    for (std::size_t k = stride; k <= tile.steps; k += stride) {
      any = add_row(tile, k, static_cast<double>(stride) * tile.dt) || any;
    }
    if (any) knots_.interpolate(tile, sum_, scores.set_all());
  }

 private:
  double needed(double speed) const {
    return speed_ * (reaction_ + speed / braking_) + speed * (reaction_ + 0.5 * speed / braking_);
  }

  bool add_row(const Tile& tile, std::size_t step, double lasts) {
    bool any = false;
    for (std::size_t i = 0; i < knots_.size(); ++i) {
      const double speed = std::abs(tile.v[knots_[i]]), most = needed_[i] + radius_;
      if (speed <= creep_) continue;
      const Point at(tile.x_at(step, knots_[i]), tile.y_at(step, knots_[i]));
      double nearest2 = most * most;
      for (const Point& place : *places_) nearest2 = std::min(nearest2, (place - at).squaredNorm());
      const double left = most - std::max(std::sqrt(nearest2), radius_);
      if (left <= 0.0) continue;
      sum_[i] += lasts * left / needed_[i] * (speed - creep_);
      any = true;
    }
    return any;
  }

  double speed_ = 0.0, creep_ = 0.0;            // [m/s]
  double reaction_ = 0.0, braking_ = 1.0;       // [s], [m/s^2]
  double radius_ = 0.0;                         // of a place and the robot's inscribed circle [m]
  const std::vector<Point>* places_ = nullptr;  // of the cycle [m]; null: there are none
  SpeedKnots knots_;
  std::vector<double> needed_, sum_;  // [knots] [m]
};

const BuiltInEntry entry("Occlusion", make<Occlusion>);

}  // namespace
}  // namespace hidwa_local_planner::critics
