// SPDX-License-Identifier: BSD-3-Clause
#include "hidwa_local_planner/core/admissibility.hpp"

#include <algorithm>
#include <cmath>

namespace hidwa_local_planner {
namespace {

// Clearances closer than this are equal [m].
constexpr double kSameClearance = 1e-6;

}  // namespace

void AdmissibilityCheck::prepare(const Parameters& parameters, const VelocityLimits& limits,
                                 const CollisionChecker& checker, const Footprint& footprint, double resolution,
                                 const Setup& setup) {
  parameters_ = &parameters;
  limits_ = &limits;
  checker_ = &checker;
  footprint_ = &footprint;
  resolution_ = resolution;
  setup_ = setup;
  memo_.clear();
  escaping_ = parameters.escape && checker.collides(setup.start);
  if (escaping_) stance_ = {checker.penetration(setup.start), checker.clearance(setup.start)};
  // A robot that stands within the growth of an obstacle would find every manoeuvre refused: it goes without.
  grown_ = footprint.padded(resolution / 32.0);
  if (!escaping_ && checker.collides(setup.start, grown_)) grown_ = footprint;
}

Twist2 AdmissibilityCheck::command_for(const Twist2& sample) const {
  if (parameters_->command == CommandPolicy::target) return sample;
  return limits_->step(setup_.reference, sample, setup_.period);
}

void AdmissibilityCheck::check_rollouts(const Tile& tile, const char** reasons) {
  for (std::size_t c = 0; c < tile.count; ++c) {
    if (escaping_) {
      if (!rollout_escapes(tile, c)) reasons[c] = "would go deeper into collision, or not out of it";
    } else if (!rollout_free(tile, c)) {
      reasons[c] = "rollout hits an obstacle";
    }
  }
}

bool AdmissibilityCheck::rollout_free(const Tile& tile, std::size_t c) const {
  const double radius = footprint_->circumscribed_radius();
  for (std::size_t k = 1; k <= tile.steps; ++k) {
    const Pose2 from = tile.pose(k - 1, c);
    const Pose2 to = tile.pose(k, c);
    const double dx = to.x - from.x, dy = to.y - from.y;
    const double straight = std::sqrt(dx * dx + dy * dy);
    // Around a clear pose everything within a cell's side is free at any heading.
    if (straight <= resolution_ && checker_->clear(to.x, to.y)) continue;
    const double moved = straight + std::abs(to.theta - from.theta) * radius;
    const int parts = std::max(1, static_cast<int>(std::ceil(moved / (0.5 * resolution_) - 1e-9)));
    for (int part = 1; part <= parts; ++part) {
      const double t = static_cast<double>(part) / parts;
      const Pose2 pose = part == parts ? to
                                       : Pose2{from.x + t * (to.x - from.x), from.y + t * (to.y - from.y),
                                               from.theta + t * (to.theta - from.theta)};
      if (checker_->collides(pose)) return false;
    }
  }
  return true;
}

bool AdmissibilityCheck::rollout_escapes(const Tile& tile, std::size_t c) const {
  int before = stance_.penetration;
  for (std::size_t k = 1; k <= tile.steps; ++k) {
    const int now = checker_->penetration(tile.pose(k, c));
    if (now > before) return false;
    before = now;
  }
  if (before < stance_.penetration) return true;
  return checker_->clearance(tile.last_pose(c)) > stance_.clearance + kSameClearance;
}

bool AdmissibilityCheck::can_brake(const Twist2& sample, std::size_t column) {
  const Twist2 command = command_for(sample);
  if (memo_.size() <= column) memo_.resize(column + 1);
  Memo& memo = memo_[column];
  const Memo* before = column > 0 ? &memo_[column - 1] : nullptr;
  if (memo.known && memo.command == command) return memo.free;
  if (before != nullptr && before->known && before->command == command) {
    memo = *before;
    return memo.free;
  }
  memo = {command, true,
          escaping_ ? !manoeuvre_deeper(command) : manoeuvre_free(command, 0.5 * resolution_, *footprint_)};
  return memo.free;
}

bool AdmissibilityCheck::can_brake_surely(const Twist2& sample) {
  return escaping_ || manoeuvre_free(command_for(sample), resolution_ / 16.0, grown_);
}

bool AdmissibilityCheck::manoeuvre_free(const Twist2& command, double spacing, const Footprint& outline) {
  roll_out({setup_.start, setup_.reference, command, parameters_->control_latency, setup_.period}, *limits_,
           footprint_->circumscribed_radius(), spacing, poses_);
  return std::none_of(poses_.begin(), poses_.end(),
                      [&](const Pose2& pose) { return checker_->collides(pose, outline); });
}

bool AdmissibilityCheck::manoeuvre_deeper(const Twist2& command) {
  roll_out({setup_.start, setup_.reference, command, parameters_->control_latency, setup_.period}, *limits_,
           footprint_->circumscribed_radius(), 0.5 * resolution_, poses_);
  int before = stance_.penetration;
  for (const Pose2& pose : poses_) {
    const int now = checker_->penetration(pose);
    if (now > before) return true;
    before = now;
  }
  return false;
}

}  // namespace hidwa_local_planner
