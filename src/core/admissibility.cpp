// SPDX-License-Identifier: BSD-3-Clause
#include "hidwa_local_planner/core/admissibility.hpp"

#include <algorithm>
#include <cmath>

#include "hidwa_local_planner/core/cell_classes.hpp"

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
  for (Memo& memo : memo_) memo.known = false;
  start_ = {setup.start, {std::cos(setup.start.theta), std::sin(setup.start.theta)}};
  escaping_ = parameters.escape && checker.collides(setup.start);
  if (escaping_) stance_ = {checker.penetration(setup.start), checker.clearance(setup.start)};
  grow_outline();
  // A robot that stands within the growth of an obstacle would find every manoeuvre refused: it goes without.
  sure_outline_ = !escaping_ && checker.collides(setup.start, start_.heading, grown_) ? &footprint : &grown_;
}

// Made anew only when the outline changes.
void AdmissibilityCheck::grow_outline() {
  const double by = resolution_ / 32.0;
  if (grown_by_ == by && grown_from_.radius() == footprint_->radius() && grown_from_.outline() == footprint_->outline()) {
    return;
  }
  grown_from_ = *footprint_;
  grown_by_ = by;
  grown_ = footprint_->padded(by);
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
  if (tile.touched != nullptr) {
    if ((tile.touched[c] & cell_class::kHit) != 0) return false;
    if ((tile.touched[c] & cell_class::kNear) == 0) return true;
  }
  for (std::size_t k = 1; k <= tile.steps; ++k) {
    // Between two poses that are clear everything is: they are at most twice the checker's margin apart.
    if (tile.classes != nullptr &&
        ((tile.classes[(k - 1) * tile.stride + c] | tile.classes[k * tile.stride + c]) & cell_class::kNear) == 0) {
      continue;
    }
    if (!segment_free(tile, c, k)) return false;
  }
  return true;
}

// The poses from step k - 1 to step k, at most half a cell apart.
bool AdmissibilityCheck::segment_free(const Tile& tile, std::size_t c, std::size_t k) const {
  const Pose2 from = tile.pose(k - 1, c);
  const Pose2 to = tile.pose(k, c);
  const double dx = to.x - from.x, dy = to.y - from.y, turn = to.theta - from.theta;
  const double moved = std::sqrt(dx * dx + dy * dy) + std::abs(turn) * footprint_->circumscribed_radius();
  const int parts = static_cast<int>(std::ceil(moved / (0.5 * resolution_) - 1e-9));
  for (int part = 1; part < parts; ++part) {
    const double t = static_cast<double>(part) / parts;
    const Pose2 pose{from.x + t * dx, from.y + t * dy, from.theta + t * turn};
    const Rotation heading{tile.cos_heading[k - 1], tile.sin_heading[k - 1]};
    if (checker_->collides(pose, heading.turned(Rotation::of(t * turn)))) return false;
  }
  return !checker_->collides(to, Rotation{tile.cos_heading[k], tile.sin_heading[k]});
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
  return escaping_ || manoeuvre_free(command_for(sample), resolution_ / 16.0, *sure_outline_);
}

BrakeManoeuvre AdmissibilityCheck::manoeuvre(const Twist2& command) const {
  return {setup_.start, setup_.reference, command, parameters_->control_latency, setup_.period};
}

bool AdmissibilityCheck::manoeuvre_free(const Twist2& command, double spacing, const Footprint& outline) const {
  const BrakeManoeuvre way = manoeuvre(command);
  if (checker_->clear_around(setup_.start.x, setup_.start.y, way.reach(*limits_))) return true;
  ManoeuvreRoller roller(*limits_, footprint_->circumscribed_radius(), spacing, start_);
  return roller.roll(way, [&](const TurnedPose& at) { return !checker_->collides(at.pose, at.heading, outline); });
}

bool AdmissibilityCheck::manoeuvre_deeper(const Twist2& command) {
  roll_out(manoeuvre(command), *limits_, footprint_->circumscribed_radius(), 0.5 * resolution_, poses_);
  int before = stance_.penetration;
  for (const Pose2& pose : poses_) {
    const int now = checker_->penetration(pose);
    if (now > before) return true;
    before = now;
  }
  return false;
}

}  // namespace hidwa_local_planner
