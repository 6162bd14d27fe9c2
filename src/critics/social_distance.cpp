// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "critics/built_in_entry.hpp"
#include "hidwa_local_planner/core/critic.hpp"
#include "hidwa_local_planner/core/footprint.hpp"

namespace hidwa_local_planner::critics {
namespace {

// Times at which the distance is measured are about so far apart [s].
constexpr double kLooksApart = 0.25;

// Candidates of a tile whose speeds are about so far apart are measured [m/s]; the others lie between them.
constexpr double kSpeedsApart = 0.1;

// For rounding [m].
constexpr double kSpare = 0.01;

// Memory is kept for so many candidates of a tile, sides of a footprint, and movers.
constexpr std::size_t kUsualCandidates = 256;
constexpr std::size_t kUsualSides = 32;
constexpr std::size_t kUsualMovers = 64;

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
  double configure(const Parameters& parameters, const ParameterSource& own) override;
  void prepare(const CycleView& cycle) override;
  void score(const CycleView& cycle, const Tile& tile, TileScores& scores) override;

 private:
  struct Mover {
    Point position;  // at the cycle's start, costmap frame [m]
    Point velocity;  // [m/s]
    double radius;   // [m]
  };
  void find_in_reach(const CycleView& cycle, const Tile& tile);
  void choose_knots(const Tile& tile);
  void take_row(const Tile& tile, std::size_t k);
  bool far_from_row(const Mover& mover, const Point& at) const;
  void project_row(const Tile& tile, std::size_t k, const Footprint& footprint);
  void measure(const Tile& tile, std::size_t k, const Point& at, const Footprint& footprint);
  bool look_around(const Tile& tile, std::size_t k, const Footprint& footprint);
  void interpolate(const Tile& tile, double* raw) const;

  double kept_ = 0.5;        // social_distance [m]
  double fading_ = 1.5;      // [s]
  double own_radius_ = 0.0;  // of the footprint, circumscribed [m]
  std::vector<Mover> movers_;
  std::vector<Mover> in_reach_;     // those of them that any candidate of the tile may come near
  std::vector<std::size_t> knots_;  // candidates of a tile that are measured, ascending
  // Of the knots, at one time:
  std::vector<double> x_, y_;                                 // [m]
  std::vector<double> along_;                                 // [sides * knots] along each side's normal [m]
  std::vector<double> gap_;                                   // [m]
  std::vector<double> nearness_;                              // 1 - d / D
  std::vector<double> sum_;                                   // over all times
  double lo_x_ = 0.0, hi_x_ = 0.0, lo_y_ = 0.0, hi_y_ = 0.0;  // around them [m]
};

double SocialDistance::configure(const Parameters& parameters, const ParameterSource& /*own*/) {
  kept_ = parameters.social_distance;
  fading_ = parameters.SocialDistance_fading_time;
  movers_.reserve(kUsualMovers);
  in_reach_.reserve(kUsualMovers);
  knots_.reserve(kUsualCandidates);
  for (std::vector<double>* values : {&x_, &y_, &gap_, &nearness_, &sum_}) values->reserve(kUsualCandidates);
  along_.reserve(kUsualCandidates * kUsualSides);
  return kept_ > 0.0 ? parameters.SocialDistance_scale : 0.0;
}

void SocialDistance::prepare(const CycleView& cycle) {
  movers_.clear();
  own_radius_ = cycle.footprint->circumscribed_radius();
  for (const MovingObstacleEstimate& mover : *cycle.moving_obstacles) {
    movers_.push_back({mover.position_now(), mover.velocity, mover.radius});
  }
}

// A rollout is no faster than its sample, or than the robot was when it began. What cannot come near within it is near
// at no time: leaving it out changes nothing.
void SocialDistance::find_in_reach(const CycleView& cycle, const Tile& tile) {
  double fastest = std::max(std::abs(cycle.velocity.v), std::abs(cycle.last_command.v));
  for (const std::size_t knot : knots_) fastest = std::max(fastest, std::abs(tile.v[knot]));
  const double lasts = static_cast<double>(tile.steps) * tile.dt;
  const double own = fastest * lasts + own_radius_ + kept_ + kSpare;
  in_reach_.clear();
  for (const Mover& mover : movers_) {
    const Point from(mover.position.x() - cycle.pose.x, mover.position.y() - cycle.pose.y);
    const Point way = lasts * mover.velocity;
    const double length2 = way.squaredNorm();
    const double part = length2 > 0.0 ? std::clamp(-from.dot(way) / length2, 0.0, 1.0) : 0.0;
    const double most = own + mover.radius;
    if ((from + part * way).squaredNorm() < most * most) in_reach_.push_back(mover);
  }
}

// The first and the last candidate, and some between them; all where their speeds are in no order.
void SocialDistance::choose_knots(const Tile& tile) {
  knots_.clear();
  for (std::size_t c = 0; c < tile.count; ++c) {
    const bool end = c == 0 || c + 1 == tile.count;
    if (end || !tile.ascending || tile.v[c + 1] - tile.v[knots_.back()] > kSpeedsApart) knots_.push_back(c);
  }
  for (std::vector<double>* values : {&x_, &y_, &gap_, &nearness_}) values->resize(knots_.size());
  sum_.assign(knots_.size(), 0.0);
}

void SocialDistance::take_row(const Tile& tile, std::size_t k) {
  for (std::size_t i = 0; i < knots_.size(); ++i) {
    x_[i] = tile.x_at(k, knots_[i]);
    y_[i] = tile.y_at(k, knots_[i]);
  }
  const auto [lo_x, hi_x] = std::minmax_element(x_.begin(), x_.end());
  const auto [lo_y, hi_y] = std::minmax_element(y_.begin(), y_.end());
  lo_x_ = *lo_x;
  hi_x_ = *hi_x;
  lo_y_ = *lo_y;
  hi_y_ = *hi_y;
}

bool SocialDistance::far_from_row(const Mover& mover, const Point& at) const {
  const double dx = std::max({lo_x_ - at.x(), at.x() - hi_x_, 0.0});
  const double dy = std::max({lo_y_ - at.y(), at.y() - hi_y_, 0.0});
  const double most = own_radius_ + mover.radius + kept_;
  return dx * dx + dy * dy >= most * most;
}

// How far along each side's normal, in the costmap frame, the side is from the map's origin.
void SocialDistance::project_row(const Tile& tile, std::size_t k, const Footprint& footprint) {
  const double cosine = tile.cos_heading[k], sine = tile.sin_heading[k];
  along_.resize(footprint.sides().size() * knots_.size());
  double* __restrict along = along_.data();
  for (const Footprint::Side& side : footprint.sides()) {
    const double nx = cosine * side.normal.x() - sine * side.normal.y();
    const double ny = sine * side.normal.x() + cosine * side.normal.y();
    for (std::size_t i = 0; i < knots_.size(); ++i) *along++ = nx * x_[i] + ny * y_[i] + side.offset;
  }
}

// How far the footprint is from a point, at step k.
void SocialDistance::measure(const Tile& tile, std::size_t k, const Point& at, const Footprint& footprint) {
  const std::size_t n = knots_.size();
  const double cosine = tile.cos_heading[k], sine = tile.sin_heading[k];
  if (!footprint.sides().empty()) {
    std::fill(gap_.begin(), gap_.end(), -own_radius_);
    const double* __restrict along = along_.data();
    double* __restrict gap = gap_.data();
    for (const Footprint::Side& side : footprint.sides()) {
      const double nx = cosine * side.normal.x() - sine * side.normal.y();
      const double ny = sine * side.normal.x() + cosine * side.normal.y();
      const double point = nx * at.x() + ny * at.y();
      for (std::size_t i = 0; i < n; ++i) gap[i] = std::max(gap[i], point - along[i]);
      along += n;
    }
    return;
  }
  for (std::size_t i = 0; i < n; ++i) {
    const double dx = at.x() - x_[i], dy = at.y() - y_[i];
    gap_[i] = footprint.distance_to({cosine * dx + sine * dy, cosine * dy - sine * dx});
  }
}

// Nearness of all movers at step k; false where none is near.
bool SocialDistance::look_around(const Tile& tile, std::size_t k, const Footprint& footprint) {
  const double time = static_cast<double>(k) * tile.dt;
  bool any = false;
  take_row(tile, k);
  for (const Mover& mover : in_reach_) {
    const Point at = mover.position + time * mover.velocity;
    if (far_from_row(mover, at)) continue;
    if (!any) {
      std::fill(nearness_.begin(), nearness_.end(), 0.0);
      project_row(tile, k, footprint);
    }
    any = true;
    measure(tile, k, at, footprint);
    for (std::size_t i = 0; i < knots_.size(); ++i) {
      nearness_[i] = std::max(nearness_[i], 1.0 - std::max(0.0, gap_[i] - mover.radius) / kept_);
    }
  }
  return any;
}

void SocialDistance::interpolate(const Tile& tile, double* raw) const {
  raw[0] = sum_[0];
  for (std::size_t i = 1; i < knots_.size(); ++i) {
    const double from = tile.v[knots_[i - 1]], span = tile.v[knots_[i]] - from;
    const double slope = span > 0.0 ? (sum_[i] - sum_[i - 1]) / span : 0.0;
    for (std::size_t c = knots_[i - 1] + 1; c < knots_[i]; ++c) raw[c] = sum_[i - 1] + slope * (tile.v[c] - from);
    raw[knots_[i]] = sum_[i];
  }
}

void SocialDistance::score(const CycleView& cycle, const Tile& tile, TileScores& scores) {
  if (movers_.empty() || tile.steps == 0 || tile.count == 0) return;
  choose_knots(tile);
  find_in_reach(cycle, tile);
  if (in_reach_.empty()) return;
  const auto stride = static_cast<std::size_t>(std::max(1.0, std::round(kLooksApart / tile.dt)));
  bool any = false;
  for (std::size_t k = stride; k <= tile.steps; k += stride) {
    if (!look_around(tile, k, *cycle.footprint)) continue;
    any = true;
    const double lasts = static_cast<double>(stride) * tile.dt;
    const double share = lasts * std::exp(-(static_cast<double>(k) * tile.dt - 0.5 * lasts) / fading_);
    for (std::size_t i = 0; i < knots_.size(); ++i) sum_[i] += share * nearness_[i];
  }
  if (any) interpolate(tile, scores.set_all());
}

const BuiltInEntry entry("SocialDistance", make<SocialDistance>);

}  // namespace
}  // namespace hidwa_local_planner::critics
