// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "core/motion/comfort_turn.hpp"
#include "core/motion/samples.hpp"
#include "core/util/rotation.hpp"
#include "hidwa_local_planner/core/parameters.hpp"
#include "hidwa_local_planner/core/tile.hpp"
#include "hidwa_local_planner/core/types.hpp"

namespace hidwa_local_planner {

/// Rolls all samples out with the unicycle model (Kalliokoski 2022, Eq. 1) in tiles of equal omega: headings are
/// turned on step by step, once for all candidates of an omega, and positions need multiplication and addition only.
/// A tile is rolled out when it is first needed. Keeps its memory between cycles.
class Rollout {
 public:
  Rollout() = default;
  Rollout(Rollout&&) = default;  // tiles point into it: it is not copied
  Rollout& operator=(Rollout&&) = default;

  /// Samples grouped by omega, as Sampler makes them, from the pose and the reference of `start` on. `comfort` binds
  /// the brake sample as ComfortTurn::to_rest() says. They are rolled out for `sim_time` [s].
  void run(const Parameters& parameters, const CycleStart& start, const std::vector<Sample>& samples,
           const ComfortTurn& comfort, double sim_time);

  std::size_t tile_count() const { return tiles_.size(); }
  /// Rolls a tile out. Valid until the next tile() or run(); quickest in ascending order.
  Tile tile(std::size_t index) const;
  /// Which candidates a tile holds, and their turn: without poses, at no cost. Valid until the next run().
  const Tile& extent(std::size_t index) const { return tiles_[index]; }
  /// The tile that holds a candidate.
  std::size_t tile_of(std::size_t candidate) const;
  std::size_t candidate_count() const { return v_.size(); }
  double sim_time() const { return settings_.sim_time; }  // of the rollouts [s]
  /// No two consecutive poses of a rollout are farther apart than this [m].
  double longest_step() const { return longest_step_; }
  /// The largest speed of the samples [m/s].
  double fastest() const { return fastest_; }

 private:
  // A tile without poses.
  struct Block : Tile {
    std::size_t turn = 0;  // blocks of the same turn share their headings
    bool ramped = true;    // velocities ramp from the reference; else they are the sample's from the start
    bool brake = false;
  };
  // One turn's headings and bounds of speed, at each step.
  struct Turn {
    std::vector<double> heading, cosine, sine, omega;
    std::vector<double> step_x, step_y;    // direction of each step times its length in time
    std::vector<double> slowest, fastest;  // what the reference can have become
    std::size_t ramp_steps = 0;            // after so many steps every candidate has its own speed
    std::size_t known = 0;                 // 1 + number of the turn that is in here
  };
  // What of the parameters counts here; a copy, since a tile may be asked for after they changed.
  struct Settings {
    double sim_time = 0.0, linear_granularity = 0.0, angular_granularity = 0.0;
    bool euler = false, standard = true;
    std::size_t steps(double v, double omega) const;
  };
  void make_tiles(const std::vector<Sample>& samples);
  void roll_turn(const Block& block) const;
  void roll_steady_turn(const Block& block, std::size_t first, double turn, const Rotation& direction) const;
  void roll_speed(const Block& block) const;

  Settings settings_;
  CycleStart start_;
  ComfortTurn comfort_;
  double start_cosine_ = 1.0, start_sine_ = 0.0;
  double fastest_ = 0.0;  // of the samples [m/s]
  double least_v_ = 0.0, most_v_ = 0.0;
  double longest_step_ = 0.0;
  std::vector<Block> tiles_;
  std::vector<double> v_;  // [candidates]
  mutable Turn turn_;
  mutable std::vector<double> lane_v_;  // [stride] of the tile
  mutable std::vector<double> x_, y_;   // of the tile
};

}  // namespace hidwa_local_planner
