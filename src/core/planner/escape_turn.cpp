// SPDX-License-Identifier: BSD-3-Clause
#include "core/planner/escape_turn.hpp"

#include <cmath>
#include <limits>

#include "core/planner/least_legal.hpp"

namespace hidwa_local_planner {
namespace {

// It gives up after so long [s].
constexpr double kLongestEscape = 15.0;

// Headings are tried in such steps [rad], and reached when so near.
constexpr double kTriedStep = 0.1;
constexpr double kHeadingReached = 0.05;

// The short way straight on, in cells.
constexpr double kShortWay = 2.0;

// Depths in collision that count as one [m].
constexpr double kSameDepth = 0.001;

}  // namespace

void EscapeTurn::begin(double now) {
  active_ = true;
  begun_ = now;
  turning_ = false;
}

int EscapeTurn::choose(const Scene& scene) {
  const int out = out_of_collision(scene);
  if (out >= 0 || !active_) return out;
  const double now = scene.situation.time;
  active_ = now >= begun_ && now - begun_ < kLongestEscape;
  return active_ ? towards_way_out(scene) : -1;
}

// Of the legal ones that drive: what ends least deep, by whole millimetres, and of these the cheapest.
int EscapeTurn::out_of_collision(const Scene& scene) const {
  return least_legal(scene.rollout, scene.totals, scene.admissibility, [&](const Tile& tile, std::size_t c) {
    if (tile.v[c] == 0.0) return std::numeric_limits<double>::infinity();
    return std::floor(scene.escape.depth_at_end(tile, c) / kSameDepth);
  });
}

int EscapeTurn::towards_way_out(const Scene& scene) {
  const double now = scene.situation.pose.theta;
  if (turning_) {
    const double left = wrap_angle(heading_ - now);
    turning_ = std::abs(left) > kHeadingReached && leads_out(scene, heading_);
    if (turning_) return turn_by(scene, left);
  }
  // The turn itself must be free, to either side.
  bool open[2] = {true, true};
  for (double angle = kTriedStep; angle < M_PI; angle += kTriedStep) {
    for (int side = 0; side < 2; ++side) {
      const double turn = side == 0 ? angle : -angle;
      open[side] = open[side] && scene.escape.may_face(now + turn);
      if (!open[side] || !leads_out(scene, now + turn)) continue;
      const int best = turn_by(scene, turn);
      if (best < 0) continue;
      turning_ = true;
      heading_ = wrap_angle(now + turn);
      return best;
    }
  }
  return -1;
}

// The legal turn on the spot that ends nearest to `angle` from here, if it ends nearer than now; -1 where there is
// none.
int EscapeTurn::turn_by(const Scene& scene, double angle) const {
  return least_legal(scene.rollout, scene.totals, scene.admissibility, [&](const Tile& tile, std::size_t c) {
    const double left = std::abs(wrap_angle(angle - (tile.heading[tile.steps] - scene.situation.pose.theta)));
    const bool turns = tile.v[c] == 0.0 && tile.omega != 0.0 && left < std::abs(angle);
    return turns ? left : std::numeric_limits<double>::infinity();
  });
}

bool EscapeTurn::leads_out(const Scene& scene, double heading) const {
  return scene.escape.leads_out(heading, kShortWay * scene.grid.resolution);
}

}  // namespace hidwa_local_planner
