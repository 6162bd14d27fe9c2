// SPDX-License-Identifier: BSD-3-Clause
#include "core/motion/rollout.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/util/rotation.hpp"
#include "hidwa_local_planner/core/util/vector_clones.hpp"

namespace hidwa_local_planner {
namespace {

// Columns of a tile: 64 candidates of 20 poses take 21 kB, half a first cache.
constexpr std::size_t kMostColumns = 64;

// Faster than any robot, so that only the accelerations bind.
constexpr double kUnbounded = 1e6;

// Numbers a row of a tile is padded to: whole registers, no remainder loop.
constexpr std::size_t kLaneMultiple = 4;

std::size_t padded(std::size_t count) { return (count + kLaneMultiple - 1) / kLaneMultiple * kLaneMultiple; }

// The least and the largest, where there are any.
std::pair<double, double> speeds(const std::vector<Sample>& samples, double where_none) {
  if (samples.empty()) return {where_none, where_none};
  double least = samples.front().u.v, most = least;
  for (const Sample& sample : samples) {
    least = std::min(least, sample.u.v);
    most = std::max(most, sample.u.v);
  }
  return {least, most};
}

// Positions of a tile, step by step: rows 1 to `steps` of x and y, `stride` long, follow from row 0.
struct RollRequest {
  std::size_t steps = 0;
  std::size_t ramp_steps = 0;       // from here on every candidate has its own speed
  std::size_t stride = 0;           // a multiple of kLaneMultiple
  const double* v = nullptr;        // [stride] the samples' speeds [m/s]
  const double* slowest = nullptr;  // [ramp_steps + 1] as far as the ramp allows [m/s]
  const double* fastest = nullptr;  // [ramp_steps + 1]
  const double* step_x = nullptr;   // [steps] metres along x a step at 1 m/s
  const double* step_y = nullptr;   // [steps]
};

inline double within(double value, double lo, double hi) {
  const double raised = value < lo ? lo : value;
  return raised > hi ? hi : raised;
}

// The steps in which speeds still ramp; w0 and w1 weigh the speeds at the start and end of each.
HIDWA_VECTOR_CLONES
void ramp_rows(const RollRequest& q, double w0, double w1, double* __restrict x, double* __restrict y) {
  const double* __restrict v = q.v;
  const std::size_t n = q.stride;
  for (std::size_t k = 0; k < q.ramp_steps; ++k) {
    const double lo0 = q.slowest[k], hi0 = q.fastest[k], lo1 = q.slowest[k + 1], hi1 = q.fastest[k + 1];
    const double dx = q.step_x[k], dy = q.step_y[k];
    const double* __restrict x0 = x + k * n;
    const double* __restrict y0 = y + k * n;
    double* __restrict x1 = x + (k + 1) * n;
    double* __restrict y1 = y + (k + 1) * n;
    for (std::size_t c = 0; c < n; ++c) {
      const double speed = w0 * within(v[c], lo0, hi0) + w1 * within(v[c], lo1, hi1);
      x1[c] = x0[c] + speed * dx;
      y1[c] = y0[c] + speed * dy;
    }
  }
}

// The steps after them, at the samples' own speeds.
HIDWA_VECTOR_CLONES
void steady_rows(const RollRequest& q, double* __restrict x, double* __restrict y) {
  const double* __restrict v = q.v;
  const std::size_t n = q.stride;
  for (std::size_t k = q.ramp_steps; k < q.steps; ++k) {
    const double dx = q.step_x[k], dy = q.step_y[k];
    const double* __restrict x0 = x + k * n;
    const double* __restrict y0 = y + k * n;
    double* __restrict x1 = x + (k + 1) * n;
    double* __restrict y1 = y + (k + 1) * n;
    for (std::size_t c = 0; c < n; ++c) {
      x1[c] = x0[c] + v[c] * dx;
      y1[c] = y0[c] + v[c] * dy;
    }
  }
}

}  // namespace

// Nav2's number: neither the distance nor the turn between two poses exceeds its granularity.
std::size_t Rollout::Settings::steps(double v, double omega) const {
  const double number = std::ceil(
      std::max(std::abs(v) * sim_time / linear_granularity, std::abs(omega) * sim_time / angular_granularity));
  return static_cast<std::size_t>(std::max(1.0, number));
}

void Rollout::run(const Parameters& p, const CycleStart& start, const std::vector<Sample>& samples,
                  const ComfortTurn& comfort, double sim_time) {
  settings_ = {sim_time, p.linear_granularity, p.angular_granularity, p.method == Method::paper,
               p.generator == Generator::standard};
  comfort_ = comfort;
  start_ = start;
  start_cosine_ = std::cos(start.pose.theta);
  start_sine_ = std::sin(start.pose.theta);
  turn_.known = 0;
  const auto [least, most] = speeds(samples, start.reference.v);
  fastest_ = std::max(-least, most);
  least_v_ = std::min(least, start.reference.v);
  most_v_ = std::max(most, start.reference.v);
  make_tiles(samples);
}

void Rollout::make_tiles(const std::vector<Sample>& samples) {
  tiles_.clear();
  if (v_.capacity() < samples.size()) v_.reserve(samples.size() + samples.size() / 8 + 16);
  v_.resize(samples.size());
  if (tiles_.capacity() < 128) tiles_.reserve(128);
  longest_step_ = 0.0;
  const double top_speed = std::max(-least_v_, most_v_);
  std::size_t turns = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const Sample& sample = samples[i];
    const bool brake = sample.kind == SampleKind::brake;
    const bool ramped = brake || settings_.standard;
    // An Euler rollout's end depends on its number of steps, so each candidate has Nav2's own; a midpoint rollout's
    // hardly does, so all candidates of one omega share the largest number.
    const bool as_before = i > 0 && !brake && !settings_.euler && samples[i - 1].u.omega == sample.u.omega &&
                           samples[i - 1].kind == SampleKind::grid;
    std::size_t steps =
        as_before ? tiles_.back().steps : settings_.steps(settings_.euler ? sample.u.v : fastest_, sample.u.omega);
    // A brake candidate turns and drives on at first: its steps are those of the fastest.
    if (brake) steps = std::max(steps, settings_.steps(fastest_, 0.0));
    const bool same_turn = !tiles_.empty() && tiles_.back().omega == sample.u.omega && tiles_.back().steps == steps &&
                           tiles_.back().ramped == ramped && tiles_.back().brake == brake;
    if (!same_turn || tiles_.back().count == kMostColumns) {
      Block block;
      block.omega = sample.u.omega;
      block.steps = steps;
      block.dt = settings_.sim_time / static_cast<double>(steps);
      block.first = i;
      block.v = v_.data() + i;
      block.turn = same_turn ? turns : ++turns;
      block.ramped = ramped;
      block.brake = brake;
      tiles_.push_back(block);
      longest_step_ = std::max(longest_step_, top_speed * block.dt);
    }
    Block& block = tiles_.back();
    block.stride = padded(++block.count);
    v_[i] = sample.u.v;
  }
}

void Rollout::roll_turn(const Block& block) const {
  Turn& t = turn_;
  t.known = block.turn;
  for (std::vector<double>* table : {&t.heading, &t.cosine, &t.sine, &t.omega, &t.step_x, &t.step_y}) {
    if (table->size() <= block.steps) table->resize(block.steps + 1);
  }
  const bool euler = settings_.euler;
  const AxisLimits limits = block.brake ? comfort_.to_rest(start_.limits.theta, start_.reference.omega)
                                        : comfort_.towards(start_.limits.theta, start_.reference.omega, block.omega);
  double turn = 0.0;  // since the start: what rotated scenes share to the last bit
  double omega = block.ramped ? start_.reference.omega : block.omega;
  Rotation direction{start_cosine_, start_sine_};
  std::size_t k = 0;
  for (; k < block.steps && omega != block.omega; ++k) {
    const double next = limits.ramp(omega, block.omega, block.dt);
    const double by = euler ? next * block.dt : 0.5 * (omega + next) * block.dt;
    const Rotation half = Rotation::of(0.5 * by);
    const Rotation middle = direction.turned(half);
    t.heading[k] = start_.pose.theta + turn;
    t.omega[k] = omega;
    t.cosine[k] = direction.c;
    t.sine[k] = direction.s;
    t.step_x[k] = (euler ? direction.c : middle.c) * block.dt;
    t.step_y[k] = (euler ? direction.s : middle.s) * block.dt;
    direction = middle.turned(half);
    turn += by;
    omega = next;
  }
  roll_steady_turn(block, k, turn, direction);
  t.omega[k] = omega;  // the ramp may be longer than the rollout
  roll_speed(block);
}

// From step `first` on the turn is the same in every step: every second direction follows from the one two before, so
// that four chains run side by side.
void Rollout::roll_steady_turn(const Block& block, std::size_t first, double turn, const Rotation& direction) const {
  Turn& t = turn_;
  const double by = block.omega * block.dt;
  const Rotation half = Rotation::of(0.5 * by), whole = half.turned(half), twice = whole.turned(whole);
  Rotation here[2] = {direction, direction.turned(whole)};
  Rotation middle[2] = {here[0].turned(half), here[1].turned(half)};
  for (std::size_t k = first; k <= block.steps; ++k) {
    const std::size_t side = (k - first) % 2;
    const Rotation& step = settings_.euler ? here[side] : middle[side];
    t.cosine[k] = here[side].c;
    t.sine[k] = here[side].s;
    t.step_x[k] = step.c * block.dt;
    t.step_y[k] = step.s * block.dt;
    here[side] = here[side].turned(twice);
    middle[side] = middle[side].turned(twice);
  }
  for (std::size_t k = first; k <= block.steps; ++k) {
    t.heading[k] = start_.pose.theta + (turn + static_cast<double>(k - first) * by);
    t.omega[k] = block.omega;
  }
}

// A candidate's speed is its sample, as far as the ramp from the reference allows: all share the two ramps that go on
// for ever.
void Rollout::roll_speed(const Block& block) const {
  Turn& t = turn_;
  t.ramp_steps = 0;
  if (!block.ramped) return;
  for (std::vector<double>* table : {&t.slowest, &t.fastest}) {
    if (table->size() <= block.steps) table->resize(block.steps + 1);
  }
  double slowest = start_.reference.v, fastest = start_.reference.v;
  for (std::size_t k = 0; k <= block.steps; ++k) {
    t.slowest[k] = slowest;
    t.fastest[k] = fastest;
    t.ramp_steps = k;
    if (slowest <= least_v_ && fastest >= most_v_) return;
    slowest = start_.limits.x.ramp(slowest, -kUnbounded, block.dt);
    fastest = start_.limits.x.ramp(fastest, kUnbounded, block.dt);
  }
}

Tile Rollout::tile(std::size_t index) const {
  const Block& block = tiles_[index];
  if (turn_.known != block.turn) roll_turn(block);
  Tile tile = extent(index);
  const std::size_t size = (block.steps + 1) * tile.stride;
  if (x_.size() < size) {
    x_.resize(size);
    y_.resize(size);
  }
  lane_v_.assign(tile.stride, v_[block.first]);  // padding repeats the first candidate
  std::copy_n(v_.begin() + static_cast<std::ptrdiff_t>(block.first), block.count, lane_v_.begin());
  std::fill_n(x_.begin(), tile.stride, start_.pose.x);
  std::fill_n(y_.begin(), tile.stride, start_.pose.y);

  RollRequest request;
  request.steps = block.steps;
  request.ramp_steps = std::min(turn_.ramp_steps, block.steps);
  request.stride = tile.stride;
  request.v = lane_v_.data();
  request.slowest = turn_.slowest.data();
  request.fastest = turn_.fastest.data();
  request.step_x = turn_.step_x.data();
  request.step_y = turn_.step_y.data();
  const double at_start = settings_.euler ? 0.0 : 0.5;  // of a step: it goes on at the mean, or at the speed reached
  ramp_rows(request, at_start, 1.0 - at_start, x_.data(), y_.data());
  steady_rows(request, x_.data(), y_.data());

  tile.x = x_.data();
  tile.y = y_.data();
  tile.heading = turn_.heading.data();
  tile.cos_heading = turn_.cosine.data();
  tile.sin_heading = turn_.sine.data();
  tile.omega_at = turn_.omega.data();
  return tile;
}

std::size_t Rollout::tile_of(std::size_t candidate) const {
  const auto next = std::upper_bound(tiles_.begin(), tiles_.end(), candidate,
                                     [](std::size_t c, const Block& block) { return c < block.first; });
  return static_cast<std::size_t>(next - tiles_.begin()) - 1;
}

}  // namespace hidwa_local_planner
