// SPDX-License-Identifier: BSD-3-Clause
#include "core/autonomy/escape_turn.hpp"

#include <cmath>
#include <limits>

#include "core/autonomy/least_legal.hpp"
#include "core/util/elapsed.hpp"

namespace hidwa_local_planner {
namespace {

// Longest escape [s].
constexpr double kLongestEscape = 15.0;

// Step between the headings that are tried, and tolerance of the one that is reached [rad].
constexpr double kTriedStep = 0.1;
constexpr double kHeadingReached = 0.05;

// The short way straight on, in cells.
constexpr double kShortWay = 2.0;

// Depths in collision that count as one [m].
constexpr double kSameDepth = 0.001;

// Of the legal ones that drive: what ends least deep, by whole millimetres, and of these the cheapest.
int out_of_collision(Evaluation& evaluated) {
  EscapeRule& escape = evaluated.obstacles().escape();
  return least_legal(evaluated, [&](const Tile& tile, std::size_t c) {
    if (tile.v[c] == 0.0) return std::numeric_limits<double>::infinity();
    return std::floor(escape.depth_at_end(tile, c) / kSameDepth);
  });
}

// The legal turn on the spot that ends nearest to `angle` from here, if it ends nearer than now; -1 where there is
// none.
int turn_by(const Cycle& cycle, Evaluation& evaluated, double angle) {
  return least_legal(evaluated, [&](const Tile& tile, std::size_t c) {
    const double left = std::abs(wrap_angle(angle - (tile.heading[tile.steps] - cycle.start.pose.theta)));
    const bool turns = tile.v[c] == 0.0 && tile.omega != 0.0 && left < std::abs(angle);
    return turns ? left : std::numeric_limits<double>::infinity();
  });
}

int towards_way_out(const Cycle& cycle, Evaluation& evaluated, EscapeTurn::State& state) {
  EscapeRule& escape = evaluated.obstacles().escape();
  const auto leads_out = [&](double heading) { return escape.leads_out(heading, kShortWay * cycle.grid.resolution); };
  const double now = cycle.start.pose.theta;
  if (state.turning) {
    const double left = wrap_angle(state.heading - now);
    state.turning = std::abs(left) > kHeadingReached && leads_out(state.heading);
    if (state.turning) return turn_by(cycle, evaluated, left);
  }
  // The turn itself must be free, to either side.
  bool open[2] = {true, true};
  for (double angle = kTriedStep; angle < M_PI; angle += kTriedStep) {
    for (int side = 0; side < 2; ++side) {
      const double turn = side == 0 ? angle : -angle;
      open[side] = open[side] && escape.may_face(now + turn);
      if (!open[side] || !leads_out(now + turn)) continue;
      const int best = turn_by(cycle, evaluated, turn);
      if (best < 0) continue;
      state.turning = true;
      state.heading = wrap_angle(now + turn);
      return best;
    }
  }
  return -1;
}

}  // namespace

EscapeTurn::Step EscapeTurn::propose(const Cycle& cycle, Evaluation& evaluated) const {
  Step step{out_of_collision(evaluated), state_};
  if (step.candidate >= 0 || !state_.active) return step;
  step.next.active = !elapsed(state_.begun, kLongestEscape, cycle.situation.time);
  if (step.next.active) step.candidate = towards_way_out(cycle, evaluated, step.next);
  return step;
}

}  // namespace hidwa_local_planner
