// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "critics/built_in_entry.hpp"
#include "critics/speed_knots.hpp"
#include "hidwa_local_planner/core/critic.hpp"
#include "hidwa_local_planner/core/footprint.hpp"
#include "hidwa_local_planner/core/util/vector_clones.hpp"

namespace hidwa_local_planner::critics {
namespace {

// Times at which the distance is measured are about so far apart [s].
constexpr double kTimesApart = 0.25;

// For rounding [m].
constexpr double kSpare = 0.01;

// Memory is kept for this many candidates of a tile, sides of a footprint, and movers.
constexpr std::size_t kUsualCandidates = 256;
constexpr std::size_t kUsualSides = 32;
constexpr std::size_t kUsualMovers = 64;

struct Disc {
  double x, y;    // [m]
  double radius;  // [m]
};

// Raises `most` to how far a point lies in front of a side [m], for each place (x, y) of the outline. `along` is the
// point's coordinate along the side's normal.
HIDWA_VECTOR_CLONES
void add_side(const Footprint::Side& side, double along, const std::vector<double>& x, const std::vector<double>& y,
              std::vector<double>& most) {
  const double nx = side.normal.x(), ny = side.normal.y(), offset = side.offset;
  for (std::size_t i = 0; i < most.size(); ++i) {
    const double gap = along - (nx * x[i] + ny * y[i] + offset);
    most[i] = most[i] < gap ? gap : most[i];
  }
}

/// Coming near to what moves, where robot and mover are at the same time, if the mover keeps its velocity. With the
/// distance d(t) from the footprint to the nearest mover's disc, D = social_distance and T =
/// SocialDistance_fading_time:
///
///   integral over the rollout of (1 - d(t) / D) exp(-t / T) dt      [s], where d(t) < D, and d(t) no less than 0
///
/// So it is at most T, however many movers there are. Of a convex footprint the distance is that to the side that is
/// farthest in front of the mover: off a corner it is a little less than the true one. Of the speeds of a tile some are
/// measured, and the others interpolated.
class SocialDistance : public Critic {
 public:
  double configure(const Parameters& parameters, const ParameterSource& /*own*/) override {
    kept_ = parameters.social_distance;
    fading_ = parameters.SocialDistance_fading_time;
    horizon_ = parameters.sim_time;
    fastest_ = std::max(parameters.max_vel_x, -parameters.min_vel_x);
    movers_.reserve(kUsualMovers);
    near_.reserve(kUsualMovers);
    sides_.reserve(kUsualSides);
    knots_.reserve(kUsualCandidates);
    for (std::vector<double>* values : {&x_, &y_, &off_, &gap_, &sum_}) values->reserve(kUsualCandidates);
    return kept_ > 0.0 ? parameters.SocialDistance_scale : 0.0;
  }

  void prepare(const CycleView& cycle) override {
    movers_.clear();
    own_radius_ = cycle.footprint->circumscribed_radius();
    const double own = std::max({fastest_, std::abs(cycle.velocity.v), std::abs(cycle.last_command.v)});
    const Point pose(cycle.pose.x, cycle.pose.y);
    for (const MovingObstacleEstimate& mover : *cycle.moving_obstacles) {
      // A mover that is farther away cannot come within social_distance, and costs nothing.
      const double meet = (own + mover.velocity.norm()) * horizon_ + own_radius_ + mover.radius + kept_ + kSpare;
      if ((mover.position_now() - pose).norm() > meet) continue;
      movers_.push_back({mover.position_now(), mover.velocity, mover.radius});
    }
  }

  void score(const CycleView& cycle, const Tile& tile, TileScores& scores) override {
    if (movers_.empty() || tile.steps == 0 || tile.count == 0) return;
    begin_tile(tile);
    const auto stride = static_cast<std::size_t>(std::max(1.0, std::round(kTimesApart / tile.dt)));
    const double lasts = static_cast<double>(stride) * tile.dt;
    bool any = false;
    for (std::size_t k = stride; k <= tile.steps; k += stride) {
      const double time = static_cast<double>(k) * tile.dt;
      if (!near_at(tile, k, time, *cycle.footprint)) continue;
      any = true;
      const double share = lasts * std::exp(-(time - 0.5 * lasts) / fading_);  // of the integral [s]
      for (std::size_t i = 0; i < knots_.size(); ++i) {
        const double nearness = 1.0 - std::max(0.0, gap_[i]) / kept_;
        sum_[i] += share * std::max(0.0, nearness);
      }
    }
    if (any) knots_.interpolate(tile, sum_, scores.set_all());
  }

 private:
  struct Mover {
    Point position;  // at the cycle's start, costmap frame [m]
    Point velocity;  // [m/s]
    double radius;   // [m]
  };

  void begin_tile(const Tile& tile) {
    knots_.choose(tile);
    for (std::vector<double>* values : {&x_, &y_, &off_, &gap_}) values->resize(knots_.size());
    sum_.assign(knots_.size(), 0.0);
  }

  void take_row(const Tile& tile, std::size_t k) {
    for (std::size_t i = 0; i < x_.size(); ++i) {
      x_[i] = tile.x_at(k, knots_[i]);
      y_[i] = tile.y_at(k, knots_[i]);
    }
    const auto x = std::minmax_element(x_.begin(), x_.end()), y = std::minmax_element(y_.begin(), y_.end());
    lo_x_ = *x.first;
    hi_x_ = *x.second;
    lo_y_ = *y.first;
    hi_y_ = *y.second;
  }

  bool far_from_row(const Disc& disc) const {
    const double dx = std::max({lo_x_ - disc.x, disc.x - hi_x_, 0.0});
    const double dy = std::max({lo_y_ - disc.y, disc.y - hi_y_, 0.0});
    const double most = own_radius_ + disc.radius + kept_;
    return dx * dx + dy * dy >= most * most;
  }

  // The gap to the nearest mover at a step; false where none is near.
  bool near_at(const Tile& tile, std::size_t k, double time, const Footprint& footprint) {
    take_row(tile, k);
    near_.clear();
    for (const Mover& mover : movers_) {
      const Point at = mover.position + time * mover.velocity;
      const Disc disc{at.x(), at.y(), mover.radius};
      if (!far_from_row(disc)) near_.push_back(disc);
    }
    if (near_.empty()) return false;
    const double cosine = tile.cos_heading[k], sine = tile.sin_heading[k];
    sides_.clear();
    for (const Footprint::Side& side : footprint.sides()) {
      const double x = side.normal.x(), y = side.normal.y();
      sides_.push_back({{cosine * x - sine * y, sine * x + cosine * y}, side.offset});
    }
    std::fill(gap_.begin(), gap_.end(), std::numeric_limits<double>::infinity());
    for (const Disc& disc : near_) {
      measure(disc, footprint, cosine, sine);
      for (std::size_t i = 0; i < gap_.size(); ++i) gap_[i] = std::min(gap_[i], off_[i] - disc.radius);
    }
    return true;
  }

  void measure(const Disc& disc, const Footprint& footprint, double cosine, double sine) {
    std::fill(off_.begin(), off_.end(), -own_radius_);
    for (const Footprint::Side& side : sides_) {
      add_side(side, side.normal.x() * disc.x + side.normal.y() * disc.y, x_, y_, off_);
    }
    if (!sides_.empty()) return;
    for (std::size_t i = 0; i < off_.size(); ++i) {
      const double dx = disc.x - x_[i], dy = disc.y - y_[i];
      off_[i] = footprint.distance_to({cosine * dx + sine * dy, cosine * dy - sine * dx});
    }
  }

  double kept_ = 0.5;        // social_distance [m]
  double fading_ = 1.5;      // [s]
  double own_radius_ = 0.0;  // of the footprint, circumscribed [m]
  double horizon_ = 0.0;     // no tile lasts longer [s]
  double fastest_ = 0.0;     // of the candidates [m/s]
  std::vector<Mover> movers_;
  SpeedKnots knots_;
  // Of the knots, at one time:
  std::vector<double> x_, y_;                                 // [m]
  std::vector<Footprint::Side> sides_;                        // of the footprint, turned
  std::vector<Disc> near_;                                    // there
  std::vector<double> off_;                                   // from the outline to the middle of one of them [m]
  std::vector<double> gap_;                                   // to the nearest of them [m]
  std::vector<double> sum_;                                   // over all times
  double lo_x_ = 0.0, hi_x_ = 0.0, lo_y_ = 0.0, hi_y_ = 0.0;  // around them [m]
};

const BuiltInEntry entry("SocialDistance", make<SocialDistance>);

}  // namespace
}  // namespace hidwa_local_planner::critics
