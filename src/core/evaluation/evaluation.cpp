// SPDX-License-Identifier: BSD-3-Clause
#include "core/evaluation/evaluation.hpp"

#include "core/movers/hidden_places.hpp"

namespace hidwa_local_planner {

Evaluation::Result Evaluation::evaluate(const Cycle& cycle, const Steering& steering, const Mode& mode) {
  const bool recovering = mode.recovering && !steering.active;
  const VelocityLimits window_limits = obstacles_.find_overlaps(cycle);
  const ComfortTurn bound = obstacles_.in_collision() ? ComfortTurn{} : mode.comfort;
  candidates_.make(cycle, window_limits, steering, bound, mode.sim_time);
  const Rollout& rollout = candidates_.rollout();
  scores_.resize(rollout.candidate_count(), critics_.size());
  obstacles_.prepare(cycle, rollout, bound, steering.active, recovering);
  prepare_grids(cycle);
  const CycleView view = view_of(cycle, steering, mode.to_goal);
  if (!grids_.on_map() && !steering.active) return {view, false, bound.binds()};
  critics_.prepare(view);
  checks_.begin(cycle.blind);
  // Recovery, and a way out of collision, are chosen among all legal candidates.
  const bool out_of_collision = obstacles_.in_collision() && !steering.active;
  score_tiles(cycle, steering, view, cycle.sampling.report >= Report::legality || recovering || out_of_collision);
  return {view, true, bound.binds()};
}

void Evaluation::prepare_grids(const Cycle& cycle) {
  const Parameters& p = cycle.parameters;
  grids_.prepare(cycle.grid, cycle.situation.plan, p.method, p.unknown_is_obstacle);
  const Situation& situation = cycle.situation;
  const Pose2& aim = situation.turns_back ? situation.plan.back() : situation.goal;
  surroundings_.prepare({&cycle.grid, &grids_, &obstacles_.collision(), cycle.start.pose, aim});
}

CycleView Evaluation::view_of(const Cycle& cycle, const Steering& steering, bool to_goal) {
  CycleView view;
  view.pose = cycle.start.pose;
  view.velocity = cycle.start.velocity;
  view.last_command = cycle.situation.last_command;
  view.goal = cycle.situation.goal;
  view.time = cycle.situation.time;
  view.steered = steering.active;
  view.operator_decides = view.person_decides =
      to_goal || (steering.active && (cycle.intent.influence == Influence::direct || cycle.situation.goal_latched));
  view.goal_next = cycle.situation.goal_next;
  view.plan = &cycle.situation.plan;
  view.grid = &cycle.grid;
  view.footprint = &cycle.footprint;
  view.surroundings = &surroundings_;
  view.moving_obstacles = &cycle.situation.moving_obstacles;
  view.hidden_places = cycle.hidden_places;
  view.hidden_radius = HiddenPlaces::kRadius;
  return view;
}

void Evaluation::score_tiles(const Cycle& cycle, const Steering& steering, const CycleView& view, bool check_closely) {
  for (std::size_t t = 0; t < candidates_.rollout().tile_count(); ++t) {
    const Tile tile = checks_.tile(t);
    scores_.begin(tile);
    checks_.check_before_scoring(tile, t, check_closely);
    scores_.score(view, tile, critics_, cycle, steering);
  }
}

}  // namespace hidwa_local_planner
