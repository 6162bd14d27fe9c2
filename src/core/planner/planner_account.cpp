// SPDX-License-Identifier: BSD-3-Clause
// What the planner says of its candidates, and what it remembers.
#include <limits>
#include <utility>

#include "core/planner/planner_impl.hpp"

namespace hidwa_local_planner {

std::string_view Planner::Impl::name_of(std::uint8_t refuser) const {
  constexpr std::string_view kNames[] = {"", "Collision", "Braking"};
  if (refuser < kFirstCritic) return kNames[refuser];
  return critics[static_cast<std::size_t>(refuser - kFirstCritic)].name;
}

void Planner::Impl::list_terms(std::size_t candidate, std::vector<CriticTerm>& terms) const {
  for (std::size_t i = 0; i < critics.size(); ++i) {
    terms.push_back({critics[i].name, raw[i][candidate], parameters.s_nv * critics[i].weight});
  }
  terms.push_back({"OperatorDeviation", deviation_of(sample_at(candidate)), 1.0});
}

std::vector<CandidateRecord> Planner::evaluation() const {
  std::vector<CandidateRecord> records;
  if (impl_->totals.empty()) return records;
  for (std::size_t t = 0; t < impl_->rollout.tile_count(); ++t) {
    const Tile tile = impl_->rollout.tile(t);
    for (std::size_t c = 0; c < tile.count; ++c) {
      const std::size_t at = tile.first + c;
      CandidateRecord record;
      record.sample = tile.sample(c);
      record.step = tile.dt;
      for (std::size_t k = 0; k <= tile.steps; ++k) record.poses.push_back(tile.pose(k, c));
      impl_->list_terms(at, record.terms);
      if (std::isfinite(impl_->totals[at])) record.total = impl_->totals[at];
      record.refused_by = impl_->name_of(impl_->refused_by[at]);
      record.reason = impl_->reasons[at] != nullptr ? impl_->reasons[at] : "";
      records.push_back(std::move(record));
    }
  }
  return records;
}

Planner::Marked Planner::marked() const {
  Marked marked = impl_->marked;
  double worst = -std::numeric_limits<double>::infinity();
  for (std::size_t c = 0; c < impl_->totals.size(); ++c) {
    const double total = impl_->totals[c];
    if (std::isfinite(total) && total > worst) {
      worst = total;
      marked.worst = static_cast<int>(c);
    }
  }
  return marked;
}

const std::vector<double>& Planner::totals() const { return impl_->totals; }
const ChoiceReport& Planner::choice() const { return impl_->report; }
const std::vector<CandidateVerdict>& Planner::verdicts() const { return impl_->verdicts; }
void Planner::set_thorough(bool thorough) { impl_->thorough = thorough; }

// After the choice and before anybody is told of it: what the critics remember is still what they judged by.
void Planner::Impl::hear_everybody(const CycleView& cycle) {
  verdicts.assign(totals.size(), CandidateVerdict{});
  for (std::size_t t = 0; t < rollout.tile_count(); ++t) {
    Tile tile = rollout.tile(t);
    classes.classify(tile);
    surroundings.begin(tile);
    std::vector<const char*> collides(tile.count, nullptr);
    admissibility.check_rollouts(tile, collides.data());
    for (std::size_t c = 0; c < tile.count; ++c) {
      CandidateVerdict& verdict = verdicts[tile.first + c];
      verdict.sample = tile.sample(c);
      verdict.end = tile.pose(tile.steps, c);
      verdict.collision = collides[c];
      verdict.can_brake = parameters.admissibility != Admissibility::braking ||
                          (refused_by[tile.first + c] != kBraking && admissibility.can_brake_surely(verdict.sample));
      const bool refused = verdict.collision != nullptr || !verdict.can_brake;
      verdict.total = refused ? std::numeric_limits<double>::infinity() : totals[tile.first + c];
      verdict.operator_own = sampler.samples()[tile.first + c].kind == SampleKind::operator_own;
    }
    hear_critics(cycle, tile);
  }
}

void Planner::Impl::hear_critics(const CycleView& cycle, const Tile& tile) {
  for (const NamedCritic& named : critics) {
    std::vector<double> scores(tile.count, 0.0);
    std::vector<const char*> refusals(tile.count, nullptr);
    TileScores said(scores.data(), refusals.data(), tile.count);
    if (named.weight != 0.0) named.critic->score(cycle, tile, said);
    for (std::size_t c = 0; c < tile.count; ++c) {
      verdicts[tile.first + c].critics.push_back({named.name, scores[c], parameters.s_nv * named.weight, refusals[c]});
    }
  }
  for (std::size_t c = 0; c < tile.count; ++c) {
    CandidateVerdict& verdict = verdicts[tile.first + c];
    verdict.critics.push_back({"OperatorDeviation", deviation_of(verdict.sample), 1.0, nullptr});
    for (const CriticVerdict& critic : verdict.critics) verdict.sum += critic.raw * critic.weight;
  }
}

void Planner::save(Bytes& state) const {
  ArchiveWriter write(state);
  write(impl_->commands, impl_->odometry, impl_->way_out, impl_->caught, impl_->unturned, impl_->unturned_reset,
        static_cast<std::uint32_t>(impl_->critics.size()));
  for (const NamedCritic& named : impl_->critics) {
    Bytes own;
    ArchiveWriter write_own(own);
    named.critic->save(write_own);
    write(named.name, own);
  }
}

bool Planner::load(const Bytes& state) {
  ArchiveReader read(state);
  std::uint32_t count = 0;
  reset();
  read(impl_->commands, impl_->odometry, impl_->way_out, impl_->caught, impl_->unturned, impl_->unturned_reset, count);
  for (std::uint32_t i = 0; i < count && !read.failed(); ++i) {
    std::string name;
    Bytes own;
    read(name, own);
    for (NamedCritic& named : impl_->critics) {
      if (named.name != name) continue;
      ArchiveReader read_own(own);
      named.critic->load(read_own);
      break;
    }
  }
  return read.complete();
}

}  // namespace hidwa_local_planner
