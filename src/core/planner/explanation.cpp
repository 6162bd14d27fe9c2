// SPDX-License-Identifier: BSD-3-Clause
#include "core/planner/explanation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace hidwa_local_planner {
namespace {

constexpr const char* kDeviation = "OperatorDeviation";
constexpr const char* kUnknownCells = "Unknown cells";  // that reject where the collision check does

// This many rollouts are examined to say what most of them meet.
constexpr std::size_t kLookedAt = 64;

}  // namespace

void Explanation::clear() {
  marked_ = {};
  choice_ = {};
  steering_ = {};
  full_.clear();
}

void Explanation::note_choice(const Proposal& proposal, const Steering& steering) {
  marked_.best = proposal.candidate;
  choice_ = {proposal.rule, steering.target, steering.active};
  steering_ = steering;
}

double Explanation::deviation(std::size_t candidate) const {
  return deviation_cost(steering_, evaluated_.candidates().sample(candidate));
}

void Explanation::list_terms(std::size_t candidate, std::vector<CriticTerm>& terms) const {
  for (std::size_t i = 0; i < critics_.size(); ++i) {
    terms.push_back({critics_[i].name, evaluated_.scores().raw(i, candidate), critics_[i].weight});
  }
  terms.push_back({kDeviation, deviation(candidate), 1.0});
}

void Explanation::describe_choice(Decision& decision) const {
  const auto best = static_cast<std::size_t>(marked_.best);
  const Rollout& rollout = evaluated_.candidates().rollout();
  decision.total = evaluated_.scores().total(best);
  list_terms(best, decision.terms);
  const Tile tile = rollout.tile(rollout.tile_of(best));
  decision.step = tile.dt;
  for (std::size_t k = 0; k <= tile.steps; ++k) decision.trajectory.push_back(tile.pose(k, best - tile.first));
}

void Explanation::judge_operator(const Cycle& cycle, const Twist2& chosen, Decision& decision) {
  if (cycle.intent.influence == Influence::none) return;
  const Twist2& u_h = cycle.intent.u_h;
  const double v_span = std::max(cycle.start.limits.x.max - cycle.start.limits.x.min, 1e-6);
  const double omega_span = std::max(cycle.start.limits.theta.max - cycle.start.limits.theta.min, 1e-6);
  decision.agreement =
      std::max(0.0, 1.0 - std::abs(u_h.v - chosen.v) / v_span - std::abs(u_h.omega - chosen.omega) / omega_span);
  marked_.operator_command = evaluated_.candidates().operator_command(u_h);
  if (marked_.operator_command < 0) return;
  const auto candidate = static_cast<std::size_t>(marked_.operator_command);
  evaluated_.checks().legal(candidate);  // so that what rejects it is known
  const Rejecter rejecter = evaluated_.scores().rejected_by()[candidate];
  if (rejecter != kNobody) decision.operator_rejected_by = critics_.name_of(rejecter);
  // As it was meant: the window brought it to a speed that is allowed.
  if (rejecter == kNobody && !cycle.blind.allows(u_h)) decision.operator_rejected_by = critics_.name_of(kBlind);
  if (rejecter == kCollision && meets_unknown(candidate)) decision.operator_rejected_by = kUnknownCells;
}

// The first pose of the rollout that collides, and what it overlaps.
bool Explanation::meets_unknown(std::size_t candidate) const {
  const CollisionChecker& collision = evaluated_.obstacles().collision();
  const Rollout& rollout = evaluated_.candidates().rollout();
  const Tile tile = rollout.tile(rollout.tile_of(candidate));
  for (std::size_t k = 0; k <= tile.steps; ++k) {
    const Pose2 pose = tile.pose(k, candidate - tile.first);
    const Rotation heading = Rotation::of(pose.theta);
    if (collision.collides(pose, heading)) return collision.meets_unknown_only(pose, heading);
  }
  return false;
}

bool Explanation::mostly_meet_unknown() const {
  const std::vector<Rejecter>& rejected_by = evaluated_.scores().rejected_by();
  const auto all = static_cast<std::size_t>(std::count(rejected_by.begin(), rejected_by.end(), kCollision));
  const std::size_t stride = 1 + all / kLookedAt;
  std::size_t seen = 0, looked_at = 0, unknown = 0;
  for (std::size_t c = 0; c < rejected_by.size(); ++c) {
    if (rejected_by[c] != kCollision || seen++ % stride != 0) continue;
    ++looked_at;
    unknown += meets_unknown(c) ? 1 : 0;
  }
  return 2 * unknown > looked_at;
}

void Explanation::count_rejections(bool why, Decision& decision) const {
  const std::vector<Rejecter>& rejected_by = evaluated_.scores().rejected_by();
  const auto count = [&rejected_by](Rejecter rejecter) {
    return static_cast<std::size_t>(std::count(rejected_by.begin(), rejected_by.end(), rejecter));
  };
  decision.legal = count(kNobody);
  std::size_t left = rejected_by.size() - decision.legal;
  for (Rejecter rejecter = kCollision; left > 0; ++rejecter) {
    const std::size_t rejected = count(rejecter);
    const bool unknown = why && rejecter == kCollision && rejected > 0 && mostly_meet_unknown();
    if (rejected > 0) decision.rejections.push_back({unknown ? kUnknownCells : critics_.name_of(rejecter), rejected});
    left -= rejected;
  }
}

CandidateReport Explanation::report_of(const Tile& tile, std::size_t c) const {
  const std::size_t candidate = tile.first + c;
  CandidateReport report;
  report.sample = tile.sample(c);
  report.operator_command = evaluated_.candidates().is_operator_command(candidate);
  report.step = tile.dt;
  for (std::size_t k = 0; k <= tile.steps; ++k) report.poses.push_back(tile.pose(k, c));
  list_terms(candidate, report.terms);
  report.total = evaluated_.scores().total(candidate);
  const Rejecter rejecter = evaluated_.scores().rejected_by()[candidate];
  if (rejecter != kNobody) {
    report.rejections.push_back({critics_.name_of(rejecter), evaluated_.scores().reasons()[candidate]});
  }
  return report;
}

std::vector<CandidateReport> Explanation::candidates() const {
  if (!full_.empty() || evaluated_.scores().count() == 0) return full_;
  std::vector<CandidateReport> reports;
  for (std::size_t t = 0; t < evaluated_.candidates().rollout().tile_count(); ++t) {
    const Tile tile = evaluated_.candidates().rollout().tile(t);
    for (std::size_t c = 0; c < tile.count; ++c) reports.push_back(report_of(tile, c));
  }
  return reports;
}

Planner::Marked Explanation::marked() const {
  Planner::Marked marked = marked_;
  double worst = -std::numeric_limits<double>::infinity();
  for (std::size_t c = 0; c < evaluated_.scores().count(); ++c) {
    if (!evaluated_.scores().legal(c) || evaluated_.scores().total(c) <= worst) continue;
    worst = evaluated_.scores().total(c);
    marked.worst = static_cast<int>(c);
  }
  return marked;
}

void Explanation::ask_all_critics(const CycleView& view) {
  full_ = candidates();
  for (std::size_t t = 0; t < evaluated_.candidates().rollout().tile_count(); ++t) {
    const Tile tile = evaluated_.checks().tile(t);
    check_all(tile);
    ask_critics(view, tile);
  }
}

// All checks of every candidate, those of braking without gaps.
void Explanation::check_all(const Tile& tile) {
  AdmissibilityCheck& admissibility = evaluated_.obstacles().admissibility();
  std::vector<const char*> collides(tile.count, nullptr);
  admissibility.check_rollouts(tile, collides.data());
  for (std::size_t c = 0; c < tile.count; ++c) {
    CandidateReport& report = full_[tile.first + c];
    const Rejecter by = evaluated_.scores().rejected_by()[tile.first + c];
    const bool checked = admissibility.checks_braking();
    const bool brakes = !checked || (by != kBraking && admissibility.confirm_braking(report.sample));
    const bool rests = !checked || (by != kMovingObstacle && admissibility.confirm_rest(report.sample));
    const bool unhidden = !checked || (by != kOcclusion && admissibility.confirm_hidden(report.sample));
    std::vector<Rejection> rejections;
    if (collides[c] != nullptr) rejections.push_back({critics_.name_of(kCollision), collides[c]});
    if (!brakes) rejections.push_back({critics_.name_of(kBraking), kCannotBrake});
    if (!evaluated_.checks().slow_where_blind(report.sample)) {
      rejections.push_back({critics_.name_of(kBlind), kUnseen});
    }
    if (!rests) rejections.push_back({critics_.name_of(kMovingObstacle), kMayBeTouched});
    if (!unhidden) rejections.push_back({critics_.name_of(kOcclusion), kHidden});
    if (!rejections.empty()) report.total = std::numeric_limits<double>::infinity();
    // A total that is not a number has no critic that says so.
    const bool no_number = evaluated_.scores().reasons()[tile.first + c] == kNotANumber;
    if (rejections.empty() && no_number) rejections = report.rejections;
    report.rejections = std::move(rejections);
  }
}

void Explanation::ask_critics(const CycleView& view, const Tile& tile) {
  for (std::size_t c = 0; c < tile.count; ++c) full_[tile.first + c].terms.clear();
  for (const CriticSet::Entry& entry : critics_) {
    std::vector<double> raw(tile.count, 0.0);
    std::vector<const char*> reasons(tile.count, nullptr);
    TileScores scores(raw.data(), reasons.data(), tile.count);
    if (entry.weight != 0.0) entry.critic->score(view, tile, scores);
    for (std::size_t c = 0; c < tile.count; ++c) {
      CandidateReport& report = full_[tile.first + c];
      report.terms.push_back({entry.name, raw[c], entry.weight});
      if (reasons[c] != nullptr) report.rejections.push_back({entry.name, reasons[c]});
    }
  }
  for (std::size_t c = 0; c < tile.count; ++c) {
    full_[tile.first + c].terms.push_back({kDeviation, deviation(tile.first + c), 1.0});
  }
}

}  // namespace hidwa_local_planner
