// SPDX-License-Identifier: BSD-3-Clause
#include "hidwa_local_planner/core/rollout.hpp"

#include <algorithm>
#include <cmath>

namespace hidwa_local_planner {
namespace {

// Nav2's number of steps: neither the distance nor the turn between two poses exceeds its granularity.
std::size_t step_count(const Parameters& p, double v, double omega) {
  const double steps = std::ceil(std::max(std::abs(v) * p.sim_time / p.linear_granularity,
                                          std::abs(omega) * p.sim_time / p.angular_granularity));
  return static_cast<std::size_t>(std::max(1.0, steps));
}

}  // namespace

void Rollout::run(const Parameters& p, const VelocityLimits& limits, const Pose2& start, const Twist2& reference,
                  const std::vector<Sample>& samples) {
  make_tiles(p, samples);
  for (const Block& block : tiles_) {
    roll_heading(p, limits, start, reference, block);
    roll_positions(p, limits, start, reference, block);
  }
}

void Rollout::make_tiles(const Parameters& p, const std::vector<Sample>& samples) {
  tiles_.clear();
  kinds_.clear();
  v_.clear();
  double fastest = 0.0;
  for (const Sample& sample : samples) fastest = std::max(fastest, std::abs(sample.u.v));
  std::size_t positions = 0, headings = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const Sample& sample = samples[i];
    const bool brake = sample.kind == SampleKind::brake;
    const bool ramped = brake || p.generator == Generator::standard;
    // An Euler rollout's end depends on its number of steps, so each candidate has Nav2's own; a midpoint rollout's
    // hardly does, so all candidates of one omega share the largest number.
    std::size_t steps = step_count(p, p.integration == Integration::euler ? sample.u.v : fastest, sample.u.omega);
    // A brake candidate turns and drives on at first: its steps are those of the fastest.
    if (brake) steps = std::max(steps, step_count(p, fastest, 0.0));
    if (tiles_.empty() || tiles_.back().omega != sample.u.omega || tiles_.back().steps != steps ||
        tiles_.back().ramped != ramped) {
      Block block;
      block.omega = sample.u.omega;
      block.steps = steps;
      block.dt = p.sim_time / static_cast<double>(steps);
      block.first = i;
      block.ramped = ramped;
      tiles_.push_back(block);
    }
    ++tiles_.back().count;
    kinds_.push_back(sample.kind);
    v_.push_back(sample.u.v);
  }
  for (Block& block : tiles_) {
    block.positions = positions;
    block.headings = headings;
    positions += (block.steps + 1) * block.count;
    headings += block.steps + 1;
  }
  x_.resize(positions);
  y_.resize(positions);
  for (std::vector<double>* table : {&heading_, &cos_, &sin_, &omega_at_, &step_cos_, &step_sin_}) {
    table->resize(headings);
  }
}

void Rollout::roll_heading(const Parameters& p, const VelocityLimits& limits, const Pose2& start,
                           const Twist2& reference, const Block& block) {
  double turn = 0.0;  // since the start: what rotated scenes share to the last bit
  double omega = block.ramped ? reference.omega : block.omega;
  const double cos_start = std::cos(start.theta);
  const double sin_start = std::sin(start.theta);
  for (std::size_t k = 0; k <= block.steps; ++k) {
    const std::size_t at = block.headings + k;
    heading_[at] = start.theta + turn;
    omega_at_[at] = omega;
    cos_[at] = cos_start * std::cos(turn) - sin_start * std::sin(turn);
    sin_[at] = sin_start * std::cos(turn) + cos_start * std::sin(turn);
    const double next = block.ramped ? limits.theta.ramp(omega, block.omega, block.dt) : block.omega;
    if (p.integration == Integration::euler) {
      step_cos_[at] = cos_[at];
      step_sin_[at] = sin_[at];
      turn += next * block.dt;
    } else {
      const double middle = turn + 0.25 * (omega + next) * block.dt;
      step_cos_[at] = cos_start * std::cos(middle) - sin_start * std::sin(middle);
      step_sin_[at] = sin_start * std::cos(middle) + cos_start * std::sin(middle);
      turn += 0.5 * (omega + next) * block.dt;
    }
    omega = next;
  }
}

void Rollout::roll_positions(const Parameters& p, const VelocityLimits& limits, const Pose2& start,
                             const Twist2& reference, const Block& block) {
  const std::size_t n = block.count;
  const double* target = v_.data() + block.first;
  double* x = x_.data() + block.positions;
  double* y = y_.data() + block.positions;
  std::fill(x, x + n, start.x);
  std::fill(y, y + n, start.y);
  speed_.resize(std::max(speed_.size(), n));
  for (std::size_t c = 0; c < n; ++c) speed_[c] = block.ramped ? reference.v : target[c];
  const bool euler = p.integration == Integration::euler;
  for (std::size_t k = 0; k < block.steps; ++k) {
    const double step_x = step_cos_[block.headings + k] * block.dt;
    const double step_y = step_sin_[block.headings + k] * block.dt;
    for (std::size_t c = 0; c < n; ++c) {
      const double next = block.ramped ? limits.x.ramp(speed_[c], target[c], block.dt) : target[c];
      const double mean = euler ? next : 0.5 * (speed_[c] + next);
      x[(k + 1) * n + c] = x[k * n + c] + mean * step_x;
      y[(k + 1) * n + c] = y[k * n + c] + mean * step_y;
      speed_[c] = next;
    }
  }
}

Tile Rollout::tile(std::size_t index) const {
  const Block& block = tiles_[index];
  Tile tile;
  tile.omega = block.omega;
  tile.dt = block.dt;
  tile.steps = block.steps;
  tile.first = block.first;
  tile.count = block.count;
  tile.v = v_.data() + block.first;
  tile.x = x_.data() + block.positions;
  tile.y = y_.data() + block.positions;
  tile.heading = heading_.data() + block.headings;
  tile.cos_heading = cos_.data() + block.headings;
  tile.sin_heading = sin_.data() + block.headings;
  tile.omega_at = omega_at_.data() + block.headings;
  return tile;
}

}  // namespace hidwa_local_planner
