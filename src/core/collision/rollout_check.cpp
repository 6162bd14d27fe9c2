// SPDX-License-Identifier: BSD-3-Clause
#include "core/collision/rollout_check.hpp"

#include <algorithm>
#include <cmath>

#include "core/collision/cell_classes.hpp"

namespace hidwa_local_planner {
namespace {

constexpr const char* kHits = "rollout hits an obstacle";
constexpr const char* kDeeper = "would go deeper into collision, or not out of it";
constexpr const char* kTooFast = "too fast in collision: could not stop within half a cell";

// Of a pose that is free without clearance [m].
constexpr double kTouching = 1e-12;

}  // namespace

void RolloutCheck::prepare(const CheckSetup& setup, ClearanceLookup& clearances, double radius, double resolution) {
  setup_ = &setup;
  clearances_ = &clearances;
  radius_ = radius;
  resolution_ = resolution;
  margin_ = clearances.checker().margin();
}

bool RolloutCheck::decide_by_cells(const Tile& tile, const char** reasons) const {
  if (setup_->escape != nullptr) return false;  // the cells count what the robot may overlap, too
  if ((tile.cells.touched_any & (cell_class::kHit | cell_class::kNear)) == 0) return true;
  unsigned undecided = 0;
  for (std::size_t c = 0; c < tile.count; ++c) {
    const bool hit = (tile.cells.touched[c] & cell_class::kHit) != 0;
    if (hit) reasons[c] = kHits;
    undecided |= hit ? 0U : tile.cells.touched[c] & cell_class::kNear;
  }
  return undecided == 0;
}

void RolloutCheck::check(const Tile& tile, const char** reasons) {
  last_hit_ = 0;
  most_turn_ = std::max(std::abs(tile.omega), std::abs(setup_->start->reference.omega)) * tile.dt;
  for (std::size_t c = 0; c < tile.count; ++c) {
    if (const char* fault = fault_of(tile, c)) reasons[c] = fault;
  }
}

const char* RolloutCheck::fault_of(const Tile& tile, std::size_t c) {
  const bool escaping = setup_->escaping();
  if (escaping && !setup_->escape->slow_enough(tile.sample(c))) return kTooFast;
  if (escaping && !escapes(tile, c)) return kDeeper;
  return free(tile, c) ? nullptr : kHits;
}

bool RolloutCheck::free(const Tile& tile, std::size_t c) {
  const bool cells_count = setup_->escape == nullptr;  // else they count what the robot may overlap, too
  if (cells_count) {
    if ((tile.cells.touched[c] & cell_class::kHit) != 0) return false;
    if ((tile.cells.touched[c] & cell_class::kNear) == 0) return true;
  }
  // Where its neighbour hit something, a candidate mostly does too.
  if (last_hit_ > 0 && clearance_at(tile, c, last_hit_) <= 0.0) return false;
  // No point of the robot moves farther in a step: its centre at the faster of two speeds, its rim by the turn.
  const double step =
      std::max(std::abs(tile.v[c]), std::abs(setup_->start->reference.v)) * tile.dt + most_turn_ * radius_;
  double clearance = clearance_at(tile, c, 0);
  const std::uint8_t* classes = cells_count ? tile.cells.classes + c : nullptr;
  for (std::size_t k = 0; k < tile.steps;) {
    if (classes != nullptr && ((classes[k * tile.stride] | classes[(k + 1) * tile.stride]) & cell_class::kNear) ==
                                  0) {  // so is what lies between, whatever the heading
      clearance = margin_;
      ++k;
      continue;
    }
    if (clearance >= step) {  // all poses within the clearance are free
      k = std::min(tile.steps, k + static_cast<std::size_t>(step > 0.0 ? std::min(clearance / step, 1e6) : 1e6));
      if (k < tile.steps) clearance = std::max(clearance_at(tile, c, k), kTouching);
      continue;
    }
    const double next = clearance_at(tile, c, k + 1);
    if (next <= 0.0 || (clearance + next < step && !free_between(tile, c, k + 1, clearance, next))) {
      last_hit_ = k + 1;
      return false;
    }
    clearance = next;
    ++k;
  }
  return true;
}

// Of a pose of a rollout [m].
double RolloutCheck::clearance_at(const Tile& tile, std::size_t c, std::size_t k) {
  const bool cells_count = setup_->escape == nullptr;
  if (cells_count && (tile.cells.classes[k * tile.stride + c] & cell_class::kNear) == 0) return margin_;
  return clearances_->at(tile.pose(k, c), {tile.cos_heading[k], tile.sin_heading[k]});
}

// The poses between step k - 1 and step k, at most half a cell apart; `before` and `after` are the clearances there
// [m].
bool RolloutCheck::free_between(const Tile& tile, std::size_t c, std::size_t k, double before, double after) {
  const Pose2 from = tile.pose(k - 1, c);
  const Pose2 to = tile.pose(k, c);
  const double dx = to.x - from.x, dy = to.y - from.y, turn = to.theta - from.theta;
  const double moved = std::sqrt(dx * dx + dy * dy) + std::abs(turn) * radius_;
  const int parts = static_cast<int>(std::ceil(moved / (0.5 * resolution_) - 1e-9));
  const Rotation heading{tile.cos_heading[k - 1], tile.sin_heading[k - 1]};
  for (int part = 1; part < parts; ++part) {
    const double t = static_cast<double>(part) / parts;
    if (t * moved <= before || (1.0 - t) * moved <= after) continue;
    const Pose2 pose{from.x + t * dx, from.y + t * dy, from.theta + t * turn};
    if (clearances_->at(pose, heading.turned(Rotation::of(t * turn))) <= 0.0) return false;
  }
  return true;
}

bool RolloutCheck::escapes(const Tile& tile, std::size_t c) const {
  EscapeRule& rule = *setup_->escape;
  EscapeRule::Descent descent = rule.start();
  if (!rule.descends(tile, c, descent)) return false;
  const bool drives_on = rule.grazes() && !(tile.sample(c) == Twist2{});
  return drives_on || may_stay(tile, c) || rule.ends_better(tile.last_pose(c), descent);
}

// Without getting out: the operator may always stand or turn, autonomy may turn first.
bool RolloutCheck::may_stay(const Tile& tile, std::size_t c) const {
  if (tile.v[c] != 0.0) return false;
  return setup_->steered || (setup_->turn_out && tile.omega != 0.0 && setup_->start->reference.v == 0.0);
}

}  // namespace hidwa_local_planner
