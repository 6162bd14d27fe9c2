// SPDX-License-Identifier: BSD-3-Clause
#include "core/search/evasion_search.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <initializer_list>
#include <limits>

namespace hidwa_local_planner {
namespace {

constexpr double kFirstMotion = 0.4;    // [s]
constexpr double kFading = 2.0;         // what comes later by this counts 1/e as much [s]
constexpr double kTurning = 0.04;       // what a change of omega costs [s per rad/s]
constexpr double kSpeeding = 0.2;       // what a change of v costs [s per m/s]
constexpr double kTouchedSooner = 100;  // each second sooner costs so many

// Ways that end so near to each other are alike [m], cosine, [m/s].
constexpr double kAlikePlace = 0.15;
constexpr double kAlikeHeading = 0.955;
constexpr double kAlikeSpeed = 0.8;

constexpr std::size_t kMoversInReach = 256;
constexpr std::size_t kMotions = 64;

// Room for so many own motions.
constexpr std::size_t kMostOwn = 2;

constexpr double kEver = std::numeric_limits<double>::infinity();

}  // namespace

EvasionSearch::EvasionSearch() {
  movers_.reserve(kMoversInReach);
  near_.reserve(kMoversInReach);
  first_motions_.reserve(kMotions);
  next_motions_.reserve(kMotions);
  branches_.reserve(kMotions);
  beam_.reserve(kBeam + kMostOwn);
  next_.reserve(kMotions * (kBeam + kMostOwn));
  queue_.reserve(kMotions * (kBeam + kMostOwn));
}

double EvasionSearch::reach(const Parameters& parameters, const VelocityLimits& limits) {
  return parameters.evasion_time * limits.x.fastest();
}

void EvasionSearch::plan_spans(const Start& scene) {
  const double first = std::min(kFirstMotion, horizon_ / kLevels);
  const double other = (horizon_ - first) / (kLevels - 1);
  double from = scene.delay;
  for (int level = 0; level < kLevels; ++level) {
    const double length = level > 0 ? other : first;
    Span& span = spans_[static_cast<std::size_t>(level)];
    span.from = from;
    span.step = length / static_cast<double>(kSteps);
    for (std::size_t k = 0; k < kSteps; ++k) {
      span.share[k] = scene.cycle.parameters.evasion_scale * span.step * std::exp(-span.time(k) / kFading);
    }
    from += length;
  }
}

// What lies beyond the map is not known, and is free.
bool EvasionSearch::blocked(const Start& scene, const State& state) const {
  if (!walls_ || scene.checker.clear(state.x, state.y)) return false;
  const GridView& grid = scene.cycle.grid;
  const double margin = scene.cycle.footprint.circumscribed_radius() + grid.resolution;
  if (!grid.contains(grid.cell_at(state.x - margin, state.y - margin)) ||
      !grid.contains(grid.cell_at(state.x + margin, state.y + margin)) ||
      !scene.checker.in_reach(grid.cell_at(state.x, state.y))) {
    return false;
  }
  return scene.checker.collides({state.x, state.y, 0.0}, state.heading);
}

// A step of a motion of the speed `v`, that ends at `time`. Where passive safety would not let the robot drive on, it
// brakes instead: false. `half_turn`: half of what it turns in the step.
bool EvasionSearch::drive_on(const Start& scene, double v, const Rotation& half_turn, double step, double time,
                             State& state) const {
  State next = state;
  next.v = scene.limits.x.ramp(state.v, v, step);
  const double driven = 0.5 * (state.v + next.v) * step;
  const Rotation middle = state.heading.turned(half_turn);
  next.x += driven * middle.c;
  next.y += driven * middle.s;
  next.heading = middle.turned(half_turn);
  if (!must_stop(scene, next, time)) {
    state = next;
    return true;
  }
  const double way = 0.5 * state.v * std::abs(state.v) / scene.limits.x.braking;
  state.x += way * state.heading.c;
  state.y += way * state.heading.s;
  state.v = 0.0;
  return false;
}

// Along a motion: the robot goes to its velocity within the limits, and keeps it. A robot that has to brake rests until
// the motion ends. False where it is touched: then `until` says when.
bool EvasionSearch::go(const Start& scene, const Twist2& motion, const Span& span, State& state) const {
  double omega = state.omega;
  bool drives = true;
  for (std::size_t k = 0; k < kSteps; ++k) {
    const double time = span.time(k), next_omega = scene.limits.theta.ramp(omega, motion.omega, span.step);
    const Rotation half_turn = Rotation::of(0.25 * (omega + next_omega) * span.step);
    omega = next_omega;
    drives = drives && drive_on(scene, motion.v, half_turn, span.step, time, state);
    bool touched = false;
    if (!near_.empty()) state.nearness += span.share[k] * nearness(scene, state, time, touched);
    if (!touched && !blocked(scene, state)) continue;
    state.until = time;
    return false;
  }
  state.omega = drives ? omega : 0.0;
  return true;
}

EvasionSearch::ConstantMotion EvasionSearch::keep(const Start& scene, const Twist2& motion) {
  State state{scene.from.pose.x, scene.from.pose.y, scene.from.heading, scene.velocity.v, scene.velocity.omega};
  double unhindered = scene.velocity.v;  // its speed if nothing stops it [m/s]
  ConstantMotion kept;
  kept.untouched = kept.untroubled = true;
  for (const Span& span : spans_) {
    const State from = state;
    find_near(scene, from, span);
    kept.untouched = go(scene, motion, span, state);
    state.unrest += unrest(from, state);
    for (std::size_t k = 0; k < kSteps; ++k) unhindered = scene.limits.x.ramp(unhindered, motion.v, span.step);
    const bool stopped = state.v != unhindered;
    kept.untroubled = kept.untroubled && kept.untouched && !stopped && state.nearness <= 0.0;
    if (!kept.untouched) break;
  }
  kept.spent = state.nearness + state.unrest;
  kept.x = state.x;
  kept.y = state.y;
  kept.heading = state.heading;
  return kept;
}

double EvasionSearch::least(const Start& scene, const PlanGuide& guide) const {
  const double slower = std::max(0.0, fastest_ - std::abs(scene.velocity.v));
  const double speeds_up = std::min(horizon_, slower / scene.limits.x.acc);
  const double lost = slower * speeds_up - 0.5 * scene.limits.x.acc * speeds_up * speeds_up;
  return guide.least_left(scene.from.pose.x, scene.from.pose.y, fastest_ * horizon_ - lost);
}

// The own ones first. All within what the wheels allow, and slow where nobody sees.
void EvasionSearch::list_motions(const Start& scene, const std::vector<Twist2>& own) {
  const VelocityLimits& limits = scene.limits;
  const double back = limits.x.min, ahead = limits.x.max;
  const auto add = [&](std::vector<Twist2>& motions, double v, std::initializer_list<double> turns) {
    for (const double turn : turns) {
      motions.push_back(scene.cycle.blind.slowed(limits.clamp({v, turn * limits.theta.max})));
    }
  };
  const auto add_speed = [&](double v) {
    add(first_motions_, v, {-1.0, -0.5, 0.0, 0.5, 1.0});
    add(next_motions_, v, {-1.0, 0.0, 1.0});
  };
  first_motions_ = own;
  next_motions_.clear();
  own_ = own.size();
  for (const double v : {ahead, ahead * (2.0 / 3.0), ahead * (1.0 / 3.0), 0.0}) add_speed(v);
  if (back >= 0.0) return;
  for (const double v : {0.5 * back, back}) add_speed(v);
}

bool EvasionSearch::may_begin(const Start& scene, const Twist2& motion) {
  return scene.cycle.movers == nullptr ||
         scene.cycle.movers->can_rest(scene.limits.step(scene.cycle.start.reference, motion, scene.cycle.start.period));
}

void EvasionSearch::run(const Start& scene, const PlanGuide& guide, const std::vector<Twist2>& own) {
  list_motions(scene, own);
  branches_.clear();
  for (const Twist2& motion : first_motions_) branches_.push_back({motion, kEver});
  beam_.clear();
  beam_.push_back({scene.from.pose.x, scene.from.pose.y, scene.from.heading, scene.velocity.v, scene.velocity.omega});
  for (int level = 0; level < kLevels && !beam_.empty(); ++level) {
    next_.clear();
    const Span& span = spans_[static_cast<std::size_t>(level)];
    for (const State& from : beam_) extend(scene, guide, from, level == 0 ? first_motions_ : next_motions_, span);
    if (level + 1 < kLevels) keep_best();
  }
  for (const State& state : next_) {
    Branch& branch = branches_[state.first];
    branch.cost = std::min(branch.cost, state.cost);
  }
}

double EvasionSearch::cheapest() const {
  double least = kEver;
  for (const Branch& branch : branches_) least = std::min(least, branch.cost);
  return least;
}

// By all of these motions. What is touched goes no farther.
void EvasionSearch::extend(const Start& scene, const PlanGuide& guide, const State& from,
                           const std::vector<Twist2>& motions, const Span& span) {
  const bool begins = &motions == &first_motions_;
  find_near(scene, from, span);
  for (std::size_t i = 0; i < motions.size(); ++i) {
    if (begins && i > 0 && !may_begin(scene, motions[i])) continue;
    State state = from;
    if (begins) state.first = static_cast<std::uint32_t>(i);
    const bool free = go(scene, motions[i], span, state);
    state.unrest += unrest(from, state);
    state.cost = state.nearness + state.unrest + guide.time_left(state.x, state.y, state.heading);
    if (free) {
      state.promise = state.cost + touched_early(scene, state, span.end());
      next_.push_back(state);
    } else {
      note_touched(state);
    }
  }
}

double EvasionSearch::unrest(const State& from, const State& to) {
  return kTurning * std::abs(to.omega - from.omega) + kSpeeding * std::abs(to.v - from.v);
}

void EvasionSearch::note_touched(const State& state) {
  const double sooner = spans_.back().end() - state.until;
  const double cost = kTouched + state.cost + kTouchedSooner * sooner * std::exp(-state.until / kFading);
  Branch& branch = branches_[state.first];
  branch.cost = std::min(branch.cost, cost);
}

bool EvasionSearch::alike(const State& a, const State& b) {
  return std::abs(a.x - b.x) < kAlikePlace && std::abs(a.y - b.y) < kAlikePlace &&
         a.heading.c * b.heading.c + a.heading.s * b.heading.s > kAlikeHeading && std::abs(a.v - b.v) < kAlikeSpeed;
}

// The cheapest go into the beam, of those that end nearly alike one; and in any case the cheapest of those that begin
// with each of the own motions.
void EvasionSearch::keep_best() {
  queue_.clear();
  for (std::size_t i = 0; i < next_.size(); ++i) queue_.emplace_back(next_[i].promise, static_cast<std::uint32_t>(i));
  std::make_heap(queue_.begin(), queue_.end(), std::greater<>());
  beam_.clear();
  while (!queue_.empty() && beam_.size() < kBeam) {
    const State& best = next_[queue_.front().second];
    if (std::none_of(beam_.begin(), beam_.end(), [&](const State& kept) { return alike(kept, best); })) {
      beam_.push_back(best);
    }
    std::pop_heap(queue_.begin(), queue_.end(), std::greater<>());
    queue_.pop_back();
  }
  for (std::size_t first = 0; first < own_; ++first) {
    if (std::any_of(beam_.begin(), beam_.end(), [&](const State& kept) { return kept.first == first; })) continue;
    if (const State* best = best_of(first)) beam_.push_back(*best);
  }
}

// Null where no way is left that begins with this motion.
const EvasionSearch::State* EvasionSearch::best_of(std::size_t first) const {
  const State* best = nullptr;
  for (const State& state : next_) {
    if (state.first == first && (best == nullptr || state.promise < best->promise)) best = &state;
  }
  return best;
}

}  // namespace hidwa_local_planner
