// SPDX-License-Identifier: BSD-3-Clause
// Chooses among the candidates, and tells what became of the choice.
#include <algorithm>
#include <functional>
#include <limits>

#include "core/planner/planner_impl.hpp"

namespace hidwa_local_planner {
namespace {

void pop(std::vector<Queued>& queue) {
  std::pop_heap(queue.begin(), queue.end(), std::greater<Queued>());
  queue.pop_back();
}

}  // namespace

int Planner::Impl::choose(const Situation& situation) {
  const TieRule tie(parameters, situation.last_command);
  const auto cheaper = [](const TileCheck& a, const TileCheck& b) { return a.lowest < b.lowest; };
  const auto cheapest = std::min_element(checks.begin(), checks.end(), cheaper);
  if (cheapest == checks.end() || !std::isfinite(cheapest->lowest)) return -1;
  const Tile tile = rollout.extent(static_cast<std::size_t>(cheapest - checks.begin()));
  std::size_t best = tile.first;
  while (totals[best] != cheapest->lowest) ++best;
  const double equal = cheapest->lowest + kEqualTotals;
  if (!stays_legal(best)) return choose_next(tie);
  for (std::size_t t = 0; t < checks.size(); ++t) {
    if (checks[t].lowest > equal) continue;
    const Tile equals_in = rollout.extent(t);
    for (std::size_t c = equals_in.first; c < equals_in.first + equals_in.count; ++c) {
      if (totals[c] <= equal && tie.prefers(sample_at(c), sample_at(best)) && stays_legal(c)) best = c;
    }
  }
  if (parameters.admissibility != Admissibility::braking || admissibility.can_brake_surely(sample_at(best))) {
    return static_cast<int>(best);
  }
  refuse(best, kBraking, kCannotBrake);
  return choose_next(tie);
}

// The same rule for the rest, where a closer look refused the first: cheapest first, without searching all anew.
int Planner::Impl::choose_next(const TieRule& tie) {
  queue.clear();
  for (std::size_t c = 0; c < totals.size(); ++c) {
    if (std::isfinite(totals[c])) queue.emplace_back(totals[c], static_cast<std::uint32_t>(c));
  }
  std::make_heap(queue.begin(), queue.end(), std::greater<Queued>());
  while (!queue.empty()) {
    if (!stays_legal(queue.front().second)) {
      pop(queue);
      continue;
    }
    const std::uint32_t best = pick_equals(tie);
    if (parameters.admissibility != Admissibility::braking || admissibility.can_brake_surely(sample_at(best))) {
      return static_cast<int>(best);
    }
    refuse(best, kBraking, kCannotBrake);
    for (const std::uint32_t c : equals) {
      if (c == best) continue;
      queue.emplace_back(totals[c], c);
      std::push_heap(queue.begin(), queue.end(), std::greater<Queued>());
    }
  }
  return -1;
}

// Takes the cheapest, which is legal, and its equals off the queue; of these the one that the tie rule prefers.
std::uint32_t Planner::Impl::pick_equals(const TieRule& tie) {
  std::uint32_t best = queue.front().second;
  const double equal = queue.front().first + kEqualTotals;
  equals.clear();
  while (!queue.empty() && queue.front().first <= equal) {
    if (stays_legal(queue.front().second)) equals.push_back(queue.front().second);
    pop(queue);
  }
  std::sort(equals.begin(), equals.end());
  for (const std::uint32_t c : equals) {
    if (tie.prefers(sample_at(c), sample_at(best))) best = c;
  }
  return best;
}

void Planner::Impl::describe(int best) {
  const auto index = static_cast<std::size_t>(best);
  marked.best = best;
  decision.sample = sample_at(index);
  decision.command = admissibility.command_for(decision.sample);
  decision.total = totals[index];
  list_terms(index, decision.terms);
  decision.outcome = at_rest(decision.command) && at_rest(decision.sample) ? Outcome::hold : Outcome::drive;
  const Tile tile = rollout.tile(rollout.tile_of(index));
  decision.step = tile.dt;
  for (std::size_t k = 0; k <= tile.steps; ++k) decision.trajectory.push_back(tile.pose(k, index - tile.first));
}

void Planner::Impl::count_refusals() {
  const auto count = [this](std::uint8_t refuser) {
    return static_cast<std::size_t>(std::count(refused_by.begin(), refused_by.end(), refuser));
  };
  decision.legal = count(kLegal);
  std::size_t left = refused_by.size() - decision.legal;
  for (std::uint8_t refuser = kCollision; left > 0; ++refuser) {
    const std::size_t refused = count(refuser);
    if (refused > 0) decision.refusals.push_back({name_of(refuser), refused});
    left -= refused;
  }
}

// How near the choice comes to the operator's own command, and what became of that: of its own candidate, or of the
// sample nearest to it.
void Planner::Impl::judge_operator() {
  if (intent.influence == Influence::none) return;
  const double v_span = std::max(limits.x.max - limits.x.min, 1e-6);
  const double omega_span = std::max(limits.theta.max - limits.theta.min, 1e-6);
  decision.agreement = std::max(0.0, 1.0 - std::abs(intent.u_h.v - decision.sample.v) / v_span -
                                         std::abs(intent.u_h.omega - decision.sample.omega) / omega_span);
  marked.operator_own = find_operator_own();
  if (marked.operator_own < 0) return;
  check_tile(rollout.tile_of(static_cast<std::size_t>(marked.operator_own)));
  const std::uint8_t refuser = refused_by[static_cast<std::size_t>(marked.operator_own)];
  if (refuser != kLegal) decision.operator_refused_by = name_of(refuser);
}

// The person's own candidate, one of the last, or the sample nearest to what the person wants.
int Planner::Impl::find_operator_own() const {
  const std::vector<Sample>& samples = sampler.samples();
  for (std::size_t c = samples.size(); c-- > 0 && samples[c].kind != SampleKind::grid;) {
    if (samples[c].kind == SampleKind::operator_own) return static_cast<int>(c);
  }
  int own = -1;
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t c = 0; c < samples.size(); ++c) {
    const double off = std::abs(samples[c].u.v - intent.u_h.v) + std::abs(samples[c].u.omega - intent.u_h.omega);
    if (off < nearest) {
      nearest = off;
      own = static_cast<int>(c);
    }
  }
  return own;
}

}  // namespace hidwa_local_planner
