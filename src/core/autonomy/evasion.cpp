// SPDX-License-Identifier: BSD-3-Clause
#include "core/autonomy/evasion.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace hidwa_local_planner {
namespace {

// A way is clearly better if it costs less by this [s]; if the robot is on its way there already, by that. Else what a
// turn has gained so far ends it, and it begins anew.
constexpr double kClearlyBetter = 0.3;
constexpr double kStillBetter = 0.1;

// The motion that it has chosen counts as so much better [s]: of two that are nearly as good it keeps to one.
constexpr double kKeeps = 0.1;

// The first motions of this many better ways are looked for among the candidates.
constexpr std::size_t kMostWays = 4;

// A candidate is like a motion if each axis differs by no more than this share of its limit.
constexpr double kLike = 0.2;

}  // namespace

bool Evasion::wanted(const Cycle& cycle, const CollisionChecker& checker, const Twist2& own, const ComfortTurn& comfort,
                     bool goes_back) {
  VelocityLimits limits = cycle.start.limits;  // of the search: gentle ones first
  limits.theta = comfort.widest(cycle.start.limits.theta, cycle.start.reference.omega);
  gently_ = comfort.binds();
  const CommandStart from = cycle.start.command_start(cycle.footprint.circumscribed_radius());
  const EvasionSearch::Start scene{cycle, limits, checker, from.at, from.velocity, from.delay};
  better_.clear();
  better_.reserve(64);
  own_.reserve(2);
  if (!search_.look(scene, cycle.situation.moving_obstacles) || stays(scene, own, goes_back)) return false;
  own_.assign(1, own);
  if (goes_on_ && is_finite(motion_))
    own_.push_back(cycle.start.limits.clamp(motion_));  // not where it was loaded damaged
  search_.run(scene, guide_, own_);
  if (gently_ && search_.cheapest() >= EvasionSearch::kTouched) {
    gently_ = false;
    limits = cycle.start.limits;
    search_.run(scene, guide_, own_);
  }
  const std::vector<EvasionSearch::Branch>& branches = search_.branches();
  if (goes_back && branches[0].cost < EvasionSearch::kTouched) return false;
  for (std::size_t i = 1; i < branches.size(); ++i) {
    if (!(branches[i].cost < branches[0].cost - better_by())) continue;
    better_.push_back(branches[i]);
    if (i < own_.size()) better_.back().cost -= kKeeps;
  }
  std::sort(better_.begin(), better_.end(), [](const auto& a, const auto& b) {
    return std::tie(a.cost, a.motion.v, a.motion.omega) < std::tie(b.cost, b.motion.v, b.motion.omega);
  });
  return !better_.empty();
}

double Evasion::better_by() const { return goes_on_ ? kStillBetter : kClearlyBetter; }

// Without a search: where the own motion, kept, is about as good as any way can be.
bool Evasion::stays(const EvasionSearch::Start& scene, const Twist2& own, bool goes_back) {
  const Cycle& cycle = scene.cycle;
  const EvasionSearch::ConstantMotion kept = search_.keep(scene, own);
  if (kept.untroubled || (goes_back && kept.untouched)) return true;
  guide_.prepare(cycle.situation.plan, cycle.situation.goal, scene.from.pose, cycle.start.limits,
                 EvasionSearch::reach(cycle.parameters, cycle.start.limits));
  if (!guide_.any()) return true;
  return kept.untouched && kept.cost(guide_) - better_by() <= search_.least(scene, guide_);
}

Evasion::Step Evasion::propose(const Cycle& cycle, Evaluation& evaluated) {
  for (std::size_t i = 0; i < std::min(kMostWays, better_.size()); ++i) {
    const int candidate = nearest_legal(cycle, evaluated, better_[i].motion);
    if (candidate >= 0) return {candidate, better_[i].motion};
  }
  return {};
}

void Evasion::commit(const Step& step) {
  goes_on_ = step.candidate >= 0;
  if (goes_on_) motion_ = step.motion;
}

int Evasion::nearest_legal(const Cycle& cycle, Evaluation& evaluated, const Twist2& motion) {
  const Candidates& candidates = evaluated.candidates();
  LazyChecks& checks = evaluated.checks();
  near_.clear();
  reserve_with_spare(near_, candidates.count());
  const double per_v = 1.0 / cycle.start.limits.x.fastest(), per_omega = 1.0 / cycle.start.limits.theta.fastest();
  for (std::size_t c = 0; c < candidates.count(); ++c) {
    const Twist2& u = candidates.sample(c);
    const double off_v = std::abs(u.v - motion.v) * per_v, off_omega = std::abs(u.omega - motion.omega) * per_omega;
    if (off_v <= kLike && off_omega <= kLike) near_.emplace_back(off_v + off_omega, static_cast<std::uint32_t>(c));
  }
  std::sort(near_.begin(), near_.end());
  for (const auto& [off, c] : near_) {
    if (checks.legal(c) && checks.confirm(c)) return static_cast<int>(c);
  }
  return -1;
}

}  // namespace hidwa_local_planner
