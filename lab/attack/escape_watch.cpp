// SPDX-License-Identifier: BSD-3-Clause
#include "escape_watch.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "contact_watch.hpp"

namespace hidwa_attack {
namespace {

constexpr double kFinestMove = 2e-5;  // between two looks [m]
constexpr double kBeside = 0.01;      // looked for around the outline [m]
constexpr double kEitherEnd = 3e-3;   // Allowance for a base that takes up each axis at either end of a period [m]

// v (latency + period) + v^2 / (2 dec) = way, solved for v.
double speed_that_stops_in(double way, double delay, double dec) {
  return dec * (std::sqrt(delay * delay + 2.0 * way / dec) - delay);
}

template <typename Set, typename Cell>
auto find(Set& set, const Cell& cell) {
  return std::find_if(set.begin(), set.end(),
                      [&](const auto& other) { return other.i == cell.i && other.j == cell.j; });
}

}  // namespace

EscapeWatch::EscapeWatch(const World& world, const Shape& padded_shape, const Spec& spec)
    : world_(world),
      shape_(padded_shape),
      outermost_(outermost(padded_shape)),
      half_cell_(0.5 * world.resolution()),
      allowed_(spec.reaching == Reaching::either ? kEitherEnd : kTouch) {
  const Parameters& p = spec.parameters;
  const double dec = p.decel_lim_x != 0.0 ? std::abs(p.decel_lim_x) : p.acc_lim_x;
  bound_ = speed_that_stops_in(half_cell_, p.control_latency + 1e-3 * spec.period, dec);
  memory_ = static_cast<int>(1000.0 * p.control_latency) + spec.period + 2;
  find_clusters();
  const double dec_theta = p.decel_lim_theta != 0.0 ? std::abs(p.decel_lim_theta) : p.acc_lim_theta;
  settling_ =
      memory_ + 2 * spec.period + static_cast<int>(1000.0 * std::max(p.max_vel_x / dec, p.max_vel_theta / dec_theta));
}

EscapeWatch::Set EscapeWatch::overlapped(const Pose2& pose) const {
  Set set;
  world_.near(Placed(shape_, pose), kBeside, [&set](int i, int j, double depth) {
    if (depth > 0.0) set.push_back({i, j, depth, false});
  });
  return set;
}

void EscapeWatch::decide(int now, const Pose2& pose, const Twist2& velocity) {
  Decided decided{now, overlapped(pose), 0.0};
  for (const In& cell : decided.set) decided.deepest = std::max(decided.deepest, cell.depth);
  const bool in = decided.deepest > kTouch;
  if (!in) in_since_ = -1;
  if (in && in_since_ < 0) in_since_ = now;
  if (in_since_ >= 0 && now - in_since_ >= settling_ && judging(now))
    fastest_ = std::max(fastest_, std::abs(velocity.v));
  decided_.push_back(std::move(decided));
  // What was decided up to that time is what the base does now.
  while (decided_.size() > 1 && decided_[1].time <= now - memory_) decided_.pop_front();
}

void EscapeWatch::observe(int now, const Pose2& pose, const Twist2& velocity) {
  moved_ += 1e-3 * (std::abs(velocity.v) + outermost_ * std::abs(velocity.omega));
  if (moved_ < kFinestMove && now != judged_from_) return;
  moved_ = 0.0;
  Set now_in = overlapped(pose);
  if (judging(now)) {
    judge_cells(now_in);
    judge_total(now_in);
  }
  now_in_ = std::move(now_in);
}

void EscapeWatch::world_changed(int now) {
  judged_from_ = now + settling_;
  floor_ = 1e9;
  in_since_ = -1;
  decided_.clear();
  find_clusters();
}

void EscapeWatch::find_clusters() {
  cluster_.assign(static_cast<std::size_t>(world_.columns()) * static_cast<std::size_t>(world_.rows()), -1);
  std::vector<std::pair<int, int>> open;
  for (int seed = 0, cluster = 0; seed < static_cast<int>(cluster_.size()); ++seed, ++cluster) {
    open.assign(1, {seed % world_.columns(), seed / world_.columns()});
    while (!open.empty()) {
      const auto [i, j] = open.back();
      open.pop_back();
      if (!world_.lethal(i, j) || cluster_[world_.index(i, j)] >= 0) continue;
      cluster_[world_.index(i, j)] = cluster;
      for (int dj = -1; dj <= 1; ++dj) {
        for (int di = -1; di <= 1; ++di) open.emplace_back(i + di, j + dj);
      }
    }
  }
}

bool EscapeWatch::was_in(const In& cell) const {
  return std::any_of(decided_.begin(), decided_.end(),
                     [&](const Decided& d) { return find(d.set, cell) != d.set.end(); });
}

bool EscapeWatch::may_neighbour(const In& cell) const {
  const auto beside = [&cell](const In& other) {
    return std::abs(other.i - cell.i) <= 1 && std::abs(other.j - cell.j) <= 1;
  };
  return std::any_of(decided_.begin(), decided_.end(),
                     [&](const Decided& d) { return std::any_of(d.set.begin(), d.set.end(), beside); });
}

void EscapeWatch::judge_cells(Set& now_in) {
  double deepest = 0.0;
  for (const Decided& d : decided_) deepest = std::max(deepest, d.deepest);
  for (In& cell : now_in) {
    const auto before = find(now_in_, cell);
    cell.forbidden = before != now_in_.end() && before->forbidden;
    if (cell.depth <= kTouch) continue;
    if (!cell.forbidden && !was_in(cell)) {
      if (may_neighbour(cell)) {
        excess_ = std::max(excess_, cell.depth - std::min(deepest, half_cell_));
      } else {
        cell.forbidden = true;
        ++entered_;
      }
    }
    if (cell.forbidden) entered_depth_ = std::max(entered_depth_, cell.depth);
  }
}

void EscapeWatch::judge_total(const Set& now_in) {
  std::map<int, double> depths;
  for (const In& cell : now_in) {
    double& depth = depths[cluster_[world_.index(cell.i, cell.j)]];
    depth = std::max(depth, cell.depth);
  }
  double total = 0.0;
  for (const auto& [cluster, depth] : depths) total += depth;
  floor_ = std::min(floor_, total);
  growth_ = std::max(growth_, total - floor_);
}

bool EscapeWatch::broken() const {
  return entered_ > 0 || excess_ > allowed_ || growth_ > allowed_ || fastest_ > 1.02 * bound_;
}

}  // namespace hidwa_attack
