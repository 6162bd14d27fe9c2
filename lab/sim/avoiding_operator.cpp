// SPDX-License-Identifier: BSD-3-Clause
#include "sim/avoiding_operator.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace hidwa_local_planner {
namespace sim {
namespace {

// What the person thinks of: a few stick positions, held one after the other for these times. The smallest
// goes nearly straight yet counts as input, which keeps the robot from returning to its plan.
constexpr std::array<double, 12> kSticks{0.2, -0.2, 0.4, -0.4, 0.55, -0.55, 0.7, -0.7, 0.85, -0.85, 1.0, -1.0};
constexpr std::array<double, 3> kDurations{1.0, 1.5, 2.0};  // [s]

// What the person minds, for each second, metre or radian of it.
constexpr double kInsideRegion = 1000.0;  // [1/s]
constexpr double kNearRegion = 200.0;     // [1/s], at no distance; falls to 0 at the margin
constexpr double kNearWall = 5.0;         // [1/s], likewise
constexpr double kWallMargin = 0.15;      // [m]
constexpr double kEffort = 0.3;           // [s/rad^2]
constexpr double kRestless = 1.0;         // [s/rad], for each change of the turning speed
constexpr double kOffPlan = 1.5;          // [1/m]
constexpr double kAcrossPlan = 0.5;       // [1/rad]
constexpr double kProgress = 1.0;         // [1/m]

constexpr double kPlanSpacing = 0.1;  // [m]
constexpr double kPlanReach = 5.0;    // [m], how much of the plan ahead is looked at

}  // namespace

AvoidingOperator::AvoidingOperator(const OperatorTraits& traits, const RobotHabits& habits, const OccupancyMap& map,
                                   const std::vector<Region>& regions, std::uint64_t seed)
    : traits_(traits),
      habits_(habits),
      prediction_(habits, map, regions),
      anything_to_avoid_(!regions.empty()),
      random_(seed),
      seed_(seed) {}

void AvoidingOperator::set_plan(const Route& plan) {
  plan_ = resampled(plan, kPlanSpacing);
  plan_position_ = 0;
}

void AvoidingOperator::reset() {
  random_ = Random(seed_);
  pending_.clear();
  left_ = 0.0;
  released_ = next_decision_ = -std::numeric_limits<double>::infinity();
}

Stick AvoidingOperator::update(const Observation& observation) {
  if (observation.time < last_time_) reset();
  last_time_ = observation.time;
  take_effect(observation.time);
  if (anything_to_avoid_ && !plan_.empty() && observation.time >= next_decision_) {
    next_decision_ = observation.time + traits_.decision_period;
    decide(observation);
  }
  return {left_, 0.0};
}

void AvoidingOperator::take_effect(double now) {
  while (!pending_.empty() && pending_.front().effective <= now) {
    const double before = asked_omega(left_, habits_);
    left_ = pending_.front().left;
    if (before != 0.0 && asked_omega(left_, habits_) == 0.0) released_ = pending_.front().effective;
    pending_.pop_front();
  }
}

AvoidingOperator::State AvoidingOperator::anticipated(const Observation& now, double& hold_left) {
  State state{now.pose, now.velocity.omega};
  double left = left_;
  double released = released_;
  plan_position_ = nearest_index(plan_, 0, kPlanReach, state.pose.x, state.pose.y);
  auto next = pending_.begin();
  const double end = now.time + traits_.reaction_time;
  for (double t = now.time; t < end - 0.5 * DrivePrediction::kStep; t += DrivePrediction::kStep) {
    for (; next != pending_.end() && next->effective <= t; ++next) {
      if (asked_omega(left, habits_) != 0.0 && asked_omega(next->left, habits_) == 0.0) released = t;
      left = next->left;
    }
    const double omega = asked_omega(left, habits_);
    const bool alone = omega == 0.0 && t >= released + habits_.hold_time;
    state = alone ? prediction_.following(state, plan_, plan_position_) : prediction_.steered(state, omega);
  }
  const bool steering = asked_omega(left, habits_) != 0.0;
  hold_left = steering ? habits_.hold_time : std::max(0.0, released + habits_.hold_time - end);
  return state;
}

bool AvoidingOperator::safe_alone(State state, double hold_left, double margin) const {
  std::size_t position = plan_position_;
  bool holding = hold_left > 0.0;
  const int steps = static_cast<int>(std::lround(traits_.look_ahead / DrivePrediction::kStep));
  for (int i = 0; i < steps; ++i) {
    holding = holding && i * DrivePrediction::kStep < hold_left && !prediction_.refuses(state, 0.0);
    state = holding ? prediction_.steered(state, 0.0) : prediction_.following(state, plan_, position);
    if (prediction_.region_gap(state.pose) < margin) return false;
  }
  return true;
}

double AvoidingOperator::segment_cost(State& state, double omega, double duration) const {
  const int steps = static_cast<int>(std::lround(duration / DrivePrediction::kStep));
  double rate = 0.0;
  for (int i = 0; i < steps; ++i) {
    state = prediction_.steered(state, omega);
    const double wall = prediction_.wall_gap(state.pose);
    if (wall < 0.0) return std::numeric_limits<double>::infinity();
    const double region = prediction_.region_gap(state.pose);
    if (region < 0.0) rate += kInsideRegion;
    rate += kNearRegion * std::clamp(1.0 - region / traits_.region_margin, 0.0, 1.0);
    rate += kNearWall * std::clamp(1.0 - wall / kWallMargin, 0.0, 1.0);
    rate += kEffort * omega * omega;
  }
  return rate * DrivePrediction::kStep;
}

double AvoidingOperator::end_cost(const State& state) const {
  const std::size_t i = nearest_index(plan_, plan_position_, kPlanReach, state.pose.x, state.pose.y);
  const Eigen::Vector2d off = plan_[i] - Eigen::Vector2d(state.pose.x, state.pose.y);
  const Eigen::Vector2d along = plan_[std::min(i + 3, plan_.size() - 1)] - plan_[i];
  const double across =
      along.norm() > 0.0 ? std::abs(normalized(std::atan2(along.y(), along.x()) - state.pose.theta)) : 0.0;
  const double progress = static_cast<double>(i - plan_position_) * kPlanSpacing;
  return kOffPlan * off.norm() + kAcrossPlan * across - kProgress * progress;
}

AvoidingOperator::Choice AvoidingOperator::search(const State& state, std::size_t depth) const {
  Choice best;
  for (const double left : kSticks) {
    const double omega = asked_omega(left, habits_);
    if (depth == 0 && prediction_.refuses(state, omega)) continue;
    State end = state;
    double cost = kRestless * std::abs(omega - state.omega) + segment_cost(end, omega, kDurations[depth]);
    // What follows can lower the cost by no more than the progress that is looked at.
    if (!(cost - kProgress * kPlanReach < best.cost)) continue;
    cost += depth + 1 < kDurations.size() ? search(end, depth + 1).cost : end_cost(end);
    if (cost < best.cost) best = {cost, left};
  }
  return best;
}

double AvoidingOperator::set_by_hand(double left) {
  if (left == 0.0) return 0.0;  // letting go is exact: the stick springs back
  const double inexact = left + traits_.stick_noise * random_.normal();
  return std::clamp(std::round(inexact / traits_.stick_step) * traits_.stick_step, -1.0, 1.0);
}

void AvoidingOperator::decide(const Observation& observation) {
  double hold_left = 0.0;
  const State state = anticipated(observation, hold_left);
  const double margin = traits_.region_margin + (hold_left > 0.0 ? traits_.release_margin : 0.0);
  const double wanted = safe_alone(state, hold_left, margin) ? 0.0 : search(state, 0).left;
  pending_.push_back({observation.time + traits_.reaction_time, set_by_hand(wanted)});
}

}  // namespace sim
}  // namespace hidwa_local_planner
