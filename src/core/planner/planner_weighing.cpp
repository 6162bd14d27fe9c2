// SPDX-License-Identifier: BSD-3-Clause
// Makes and scores the candidates of a cycle.
#include <algorithm>
#include <limits>

#include "core/motion/late_cycles.hpp"
#include "core/planner/planner_impl.hpp"

namespace hidwa_local_planner {
namespace {

// Four searches side by side.
double lowest_of(const double* values, std::size_t count) {
  double lowest[4];
  std::fill_n(lowest, 4, std::numeric_limits<double>::infinity());
  std::size_t c = 0;
  for (; c + 4 <= count; c += 4) {
    for (std::size_t lane = 0; lane < 4; ++lane) lowest[lane] = std::min(lowest[lane], values[c + lane]);
  }
  for (; c < count; ++c) lowest[0] = std::min(lowest[0], values[c]);
  return std::min(std::min(lowest[0], lowest[1]), std::min(lowest[2], lowest[3]));
}

// How far beyond the end of a candidate a critic looks at most [m].
double farthest_look(const std::vector<NamedCritic>& critics) {
  double farthest = 0.0;
  for (const NamedCritic& named : critics) {
    if (named.weight != 0.0) farthest = std::max(farthest, named.critic->reach());
  }
  return farthest;
}

}  // namespace

// Makes, checks and scores all candidates.
CycleView Planner::Impl::weigh(const Situation& situation, const GridView& grid, const Sampling& sampling) {
  escape.look(
      parameters, limits, grid, footprint,
      {situation.pose, decision.reference, situation.period, latest_hold(situation.period, longest_period(situation))});
  make_candidates(situation, sampling);
  prepare_checks(situation, grid);
  grids.prepare(grid, situation.plan, parameters.map_grid, parameters.unknown_is_obstacle);
  grids.expect(situation.pose, reach + farthest_look(critics));
  surroundings.prepare({&grid, &grids, &collision, situation.pose, situation.goal});
  CycleView cycle;
  cycle.pose = situation.pose;
  cycle.velocity = decision.velocity;
  cycle.last_command = situation.last_command;
  cycle.goal = situation.goal;
  cycle.time = situation.time;
  cycle.steered = steered;
  cycle.person_decides = steered && (intent.influence == Influence::direct || situation.goal_latched);
  cycle.plan = &situation.plan;
  cycle.grid = &grid;
  cycle.footprint = &footprint;
  cycle.surroundings = &surroundings;
  if (!grids.on_map() && !steered) return cycle;
  for (NamedCritic& named : critics) {
    if (named.weight != 0.0) named.critic->prepare(cycle);
  }
  list_checks();
  // Out of where it is stuck or stands in collision, the way is chosen among all legal candidates.
  const bool check = sampling.check_all || way_out.active() || (escape.overlaps() && !steered);
  for (std::size_t t = 0; t < rollout.tile_count(); ++t) score_tile(cycle, t, check);
  return cycle;
}

void Planner::Impl::make_candidates(const Situation& situation, const Sampling& sampling) {
  SampleRequest request;
  request.reference = decision.reference;
  request.previous = situation.last_command;
  request.wanted = steered ? &intent.u_h : nullptr;
  request.blended = steered && !(wish == intent.u_h) ? &wish : nullptr;
  request.period = situation.period;
  request.vx_samples = sampling.vx_samples > 0 ? sampling.vx_samples : parameters.vx_samples;
  request.vth_samples = sampling.vth_samples > 0 ? sampling.vth_samples : parameters.vth_samples;
  // In collision all of them are slow: of the usual window hardly any sample would be slow enough.
  sampler.make(parameters, escape.overlaps() ? escape.slowed() : limits, request);
  rollout.run(parameters, limits, situation.pose, decision.reference, sampler.samples());
  const std::size_t n = rollout.candidate_count();
  decision.candidates = n;
  fit(totals, n);  // what they hold is set tile by tile
  fit(refused_by, n);
  fit(reasons, n);
  make_room(queue, n);
  make_room(equals, n);
  for (std::vector<double>& scores : raw) fit(scores, n);
}

void Planner::Impl::prepare_checks(const Situation& situation, const GridView& grid) {
  const AdmissibilityCheck::Setup setup{situation.pose,
                                        origin,
                                        decision.reference,
                                        &pending,
                                        situation.period,
                                        longest_period(situation),
                                        !steered && way_out.active(),
                                        steered,
                                        escape.applies() ? &escape : nullptr};
  const double fastest = std::max(pending.fastest(), rollout.fastest());
  const double manoeuvres = AdmissibilityCheck::reach_of_manoeuvres(setup, limits, fastest);
  const double radius = footprint.circumscribed_radius();
  const double growth = AdmissibilityCheck::most_growth(setup, limits, radius, manoeuvres);
  // Nothing lies beyond the map's edge but more of it.
  const double across = std::hypot(grid.size_x, grid.size_y) * grid.resolution + radius;
  reach = std::min(std::max(rollout.fastest() * parameters.sim_time, manoeuvres + growth), across);
  // Half a step: what lies between two clear poses is clear. And enough for the poses of a manoeuvre.
  const double margin = std::max(0.5 * rollout.longest_step(), grid.resolution / 16.0);
  const double room = std::min(growth + 2.0 * grid.resolution, across);
  collision.prepare(grid, footprint, parameters.unknown_is_obstacle, situation.pose, reach, margin, room);
  classes.prepare(collision, grid, parameters.unknown_is_obstacle, situation.pose, reach);
  if (escape.applies()) escape.prepare(reach, margin);
  admissibility.prepare(parameters, limits, escape.applies() ? escape.rest() : collision, footprint, grid.resolution,
                        setup);
  decision.escaping = admissibility.escaping();
}

void Planner::Impl::score_tile(const CycleView& cycle, std::size_t t, bool check) {
  Tile tile = rollout.tile(t);
  classes.classify(tile);
  surroundings.begin(tile);
  std::fill_n(refused_by.begin() + static_cast<std::ptrdiff_t>(tile.first), tile.count, kLegal);
  std::fill_n(reasons.begin() + static_cast<std::ptrdiff_t>(tile.first), tile.count, nullptr);
  check_cells(tile, checks[t]);
  if (check) check_closely(tile, checks[t]);
  ask_critics(cycle, tile);
  sum_up(tile);
  checks[t].lowest = lowest_of(totals.data() + tile.first, tile.count);
}

void Planner::Impl::ask_critics(const CycleView& cycle, const Tile& tile) {
  scored_count = 0;
  for (std::size_t i = 0; i < critics.size(); ++i) {
    double* own = raw[i].data() + tile.first;
    TileScores scores(own, reasons.data() + tile.first, tile.count);
    if (critics[i].weight != 0.0) critics[i].critic->score(cycle, tile, scores);
    if (scores.any_set()) {
      scored[scored_count].raw = own;
      scored[scored_count++].weight = critics[i].weight;
    } else {
      std::fill_n(own, tile.count, 0.0);
    }
    if (!scores.any_rejected()) continue;
    for (std::size_t c = tile.first; c < tile.first + tile.count; ++c) {
      if (reasons[c] != nullptr && refused_by[c] == kLegal) refused_by[c] = static_cast<std::uint8_t>(kFirstCritic + i);
    }
  }
}

// Kalliokoski 2022, the cost J in section III: J = s_nv J_nv + gamma (s_v |v_h - v| + s_omega |omega_h - omega|).
void Planner::Impl::sum_up(const Tile& tile) {
  kernel::Deviation deviation;
  if (steered) {
    deviation = {tile.v, wish.v, parameters.s_v, parameters.s_omega * std::abs(wish.omega - tile.omega)};
  }
  // Direct control takes the legal candidate nearest to what the person wants, by the same weights.
  const std::size_t heard = intent.influence != Influence::direct ? scored_count : 0;
  kernel::sum_up(scored.data(), heard, parameters.s_nv, deviation, tile.count, totals.data() + tile.first);
  strike_refused(tile);
}

void Planner::Impl::strike_refused(const Tile& tile) {
  double* __restrict total = totals.data() + tile.first;
  std::uint8_t* __restrict refuser = refused_by.data() + tile.first;
  unsigned spoiled = 0;
  for (std::size_t c = 0; c < tile.count; ++c) {
    spoiled |= std::abs(total[c]) <= std::numeric_limits<double>::max() ? 0U : 1U;
  }
  for (std::size_t c = 0; spoiled != 0 && c < tile.count; ++c) {
    // A critic of another package may say anything: what is not a number is no legal candidate.
    if (refuser[c] != kLegal || std::isfinite(total[c])) continue;
    refuser[c] = not_a_number(tile.first + c);
    reasons[tile.first + c] = "total is not a number";
  }
  for (std::size_t c = 0; c < tile.count; ++c) {
    total[c] = refuser[c] == kLegal ? total[c] : std::numeric_limits<double>::infinity();
  }
}

// The paper's J_sh; nothing while the person's input does not count.
double Planner::Impl::deviation_of(const Twist2& u) const {
  if (!steered) return 0.0;
  return parameters.s_v * std::abs(wish.v - u.v) + parameters.s_omega * std::abs(wish.omega - u.omega);
}

// The critic that spoiled a total.
std::uint8_t Planner::Impl::not_a_number(std::size_t candidate) const {
  for (std::size_t i = 0; i < critics.size(); ++i) {
    if (!std::isfinite(critics[i].weight * raw[i][candidate])) return static_cast<std::uint8_t>(kFirstCritic + i);
  }
  return kFirstCritic;
}

}  // namespace hidwa_local_planner
