// SPDX-License-Identifier: BSD-3-Clause
#include "core/collision/escape.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/collision/rounding.hpp"

namespace hidwa_local_planner {
namespace {

// A total depth that grows by less has not grown [m]: rounding, and no more than 2 um a second at 20 Hz.
constexpr double kSameDepth = 1e-7;

// What is less deep, or farther away, is so by more than this [m].
constexpr double kBetter = 1e-6;

// Farther from what it overlaps, and not by rounding [m].
constexpr double kClearly = 0.01;

// Poses of a rollout that are looked at, in cells: the manoeuvre of the command itself is looked at more closely.
constexpr double kRolloutSpacing = 0.25;

// Parts of a straight way.
constexpr int kParts = 8;

// Clusters of a usual collision: room that is taken once.
constexpr std::size_t kUsualClusters = 512;

}  // namespace

void EscapeRule::look(const Parameters& parameters, const GridView& grid, const Footprint& footprint,
                      const CycleStart& start) {
  footprint_ = &footprint;
  window_.map = grid;
  window_.unknown_is_obstacle = parameters.unknown_is_obstacle;
  sim_time_ = parameters.sim_time;
  start_ = &start;
  overlaps_.clear();
  centre_inscribed_ = false;
  if (parameters.method == Method::paper) return;
  depth_.prepare(footprint, grid.resolution);
  find_overlaps();
  const Cell centre = grid.cell_at(start.pose.x, start.pose.y);
  centre_inscribed_ = footprint.is_circle() && grid.contains(centre) && grid.at(centre) == cost::kInscribed;
  if (!applies()) return;
  const double arm = footprint.is_circle() ? 0.0 : footprint.circumscribed_radius();
  speed_ =
      EscapeSpeed(start.limits, arm, grid.resolution, parameters.control_latency + start.period + start.latest_hold());
}

TurnedPose EscapeRule::relative(const Pose2& pose, const Rotation& heading) const {
  return {{pose.x - start_->pose.x, pose.y - start_->pose.y, pose.theta}, heading};
}

void EscapeRule::find_overlaps() {
  list_near_cells();
  if (overlaps_.empty()) return;
  depths_.resize(overlaps_.size());
  const double theta = start_->pose.theta;
  depth_.of({0.0, 0.0, theta}, Rotation::direction(theta), x_.data(), y_.data(), overlaps_.size(), depths_.data());
  std::size_t kept = 0;
  for (std::size_t k = 0; k < overlaps_.size(); ++k) {
    if (depths_[k] >= -kRounding) overlaps_[kept++] = {overlaps_[k].cell, depths_[k]};
  }
  overlaps_.resize(kept);
}

// The obstacle cells around the robot, whether it overlaps them or not.
void EscapeRule::list_near_cells() {
  const double reach = footprint_->circumscribed_radius() + kRounding;
  const Pose2& pose = start_->pose;
  const Cell lo = window_.map.cell_at(pose.x - reach, pose.y - reach),
             hi = window_.map.cell_at(pose.x + reach, pose.y + reach);
  for (std::vector<double>* values : {&x_, &y_, &depths_}) values->reserve(kUsualClusters);
  overlaps_.reserve(kUsualClusters);
  x_.clear();
  y_.clear();
  for (int j = lo.j; j <= hi.j; ++j) {
    for (int i = lo.i; i <= hi.i; ++i) {
      if (!window_.obstacle({i, j})) continue;
      overlaps_.push_back({{i, j}, 0.0});
      x_.push_back(window_.map.centre({i, j}).x() - pose.x);
      y_.push_back(window_.map.centre({i, j}).y() - pose.y);
    }
  }
}

void EscapeRule::prepare(double reach, double margin, double largest_clearance) {
  const double farthest = reach + footprint_->circumscribed_radius() + std::max(margin, largest_clearance);
  // Beyond the window everything counts as an obstacle: it is large enough for whatever is asked.
  const int radius = static_cast<int>(std::ceil(farthest / window_.map.resolution)) + 8;
  const Cell middle = window_.map.cell_at(start_->pose.x, start_->pose.y);
  window_.first = {middle.i - radius, middle.j - radius};
  window_.size = 2 * radius + 1;
  const AxisLimits slow = slowed().x;
  const double longest = std::max(std::abs(slow.min), std::abs(slow.max)) * sim_time_;
  clusters_.gather(window_, overlaps_, 1 + static_cast<int>(std::ceil(longest / window_.map.resolution)));
  list_members();
  make_rest();
  const GridView rest{rest_costs_.data(),
                      window_.size,
                      window_.size,
                      window_.map.resolution,
                      window_.map.origin_x + window_.first.i * window_.map.resolution,
                      window_.map.origin_y + window_.first.j * window_.map.resolution};
  rest_.prepare(rest, *footprint_, true, start_->pose, reach, margin, largest_clearance);
}

void EscapeRule::make_rest() {
  rest_costs_.resize(static_cast<std::size_t>(window_.size) * static_cast<std::size_t>(window_.size));
  std::size_t at = 0;
  for (int j = 0; j < window_.size; ++j) {
    for (int i = 0; i < window_.size; ++i, ++at) {
      const Cell cell{window_.first.i + i, window_.first.j + j};
      rest_costs_[at] = window_.obstacle(cell) && !clusters_.holds(cell) ? cost::kLethal : cost::kFree;
    }
  }
}

void EscapeRule::list_members() {
  x_.clear();
  y_.clear();
  for (const ObstacleClusters::Member& member : clusters_.members()) {
    const Point centre = window_.map.centre(member.cell);
    x_.push_back(centre.x() - start_->pose.x);
    y_.push_back(centre.y() - start_->pose.y);
  }
  depths_.resize(clusters_.members().size());
  Descent descent{std::numeric_limits<double>::infinity(), 0.0};
  descends(TurnedPose::of(start_->pose), Ahead::rollout, descent);
  start_total_ = descent.total;
}

bool EscapeRule::descends(const TurnedPose& at, Ahead ahead, Descent& descent) {
  const std::vector<ObstacleClusters::Member>& members = clusters_.members();
  const TurnedPose here = relative(at.pose, at.heading);
  depth_.of(here.pose, here.heading, x_.data(), y_.data(), members.size(), depths_.data());
  double total = 0.0, deepest = 0.0;
  for (std::size_t k = 0; k < members.size(); ++k) {
    const double limit = ahead == Ahead::rollout ? members[k].limit : members[k].near_limit;
    if (depths_[k] > limit + kSameDepth) return false;
    if (k > 0 && members[k].cluster != members[k - 1].cluster) {
      total += deepest;
      deepest = 0.0;
    }
    deepest = std::max(deepest, depths_[k]);
  }
  descent.total = total + deepest;
  if (descent.total > descent.least + kSameDepth) return false;
  descent.least = std::min(descent.least, descent.total);
  return true;
}

// The number of rollout steps in which the outline moves a quarter of a cell at most.
std::size_t EscapeRule::stride(const Tile& tile, std::size_t c) const {
  const double v = std::max(std::abs(tile.v[c]), std::abs(start_->reference.v));
  const double omega = std::max(std::abs(tile.omega), std::abs(start_->reference.omega));
  const double way = (v + speed_.arm() * omega) * tile.dt, most = kRolloutSpacing * window_.map.resolution;
  if (way * static_cast<double>(tile.steps) <= most) return tile.steps;
  return std::max<std::size_t>(1, static_cast<std::size_t>(most / way));
}

bool EscapeRule::descends(const Tile& tile, std::size_t c, Descent& descent) {
  const std::size_t step = stride(tile, c);
  for (std::size_t k = std::min(step, tile.steps);; k = std::min(k + step, tile.steps)) {
    const TurnedPose at{tile.pose(k, c), {tile.cos_heading[k], tile.sin_heading[k]}};
    if (!descends(at, Ahead::rollout, descent)) return false;
    if (k == tile.steps) return true;
  }
}

double EscapeRule::depth_at_end(const Tile& tile, std::size_t c) {
  Descent descent{std::numeric_limits<double>::infinity(), 0.0};
  descends({tile.last_pose(c), {tile.cos_heading[tile.steps], tile.sin_heading[tile.steps]}}, Ahead::rollout, descent);
  return descent.total;
}

bool EscapeRule::ends_better(const Pose2& end, const Descent& descent) const {
  if (descent.total < start_total_ - kBetter) return true;
  return distance_to_overlapped(end) > distance_to_overlapped(start_->pose) + kBetter;
}

// From the robot's centre to the nearest cell that it overlaps at the start [m].
double EscapeRule::distance_to_overlapped(const Pose2& pose) const {
  const double half = 0.5 * window_.map.resolution;
  double nearest2 = std::numeric_limits<double>::infinity();
  for (const ObstacleClusters::Overlap& overlap : overlaps_) {
    const Point centre = window_.map.centre(overlap.cell);
    const double dx = beyond(pose.x - centre.x(), half), dy = beyond(pose.y - centre.y(), half);
    nearest2 = std::min(nearest2, dx * dx + dy * dy);
  }
  return std::sqrt(nearest2);
}

bool EscapeRule::may_face(double heading) {
  const TurnedPose at = TurnedPose::of({start_->pose.x, start_->pose.y, heading});
  Descent descent = start();
  return !rest_.collides(at.pose, at.heading) && descends(at, Ahead::rollout, descent);
}

bool EscapeRule::leads_out(double heading, double length) {
  const Rotation direction = Rotation::direction(heading);
  Descent descent = start();
  TurnedPose at{start_->pose, direction};
  at.pose.theta = heading;
  if (!descends(at, Ahead::rollout, descent)) return false;
  const double before = descent.total;
  for (int part = 1; part <= kParts; ++part) {
    const double way = length * part / kParts;
    at.pose.x = start_->pose.x + way * direction.c;
    at.pose.y = start_->pose.y + way * direction.s;
    if (rest_.collides(at.pose, direction) || !descends(at, Ahead::rollout, descent)) return false;
  }
  return descent.total < before - kBetter ||
         distance_to_overlapped(at.pose) > distance_to_overlapped(start_->pose) + kClearly;
}

}  // namespace hidwa_local_planner
