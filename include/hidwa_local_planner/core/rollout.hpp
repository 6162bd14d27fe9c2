// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "hidwa_local_planner/core/parameters.hpp"
#include "hidwa_local_planner/core/samples.hpp"
#include "hidwa_local_planner/core/trajectory_batch.hpp"
#include "hidwa_local_planner/core/types.hpp"
#include "hidwa_local_planner/core/velocity_limits.hpp"

namespace hidwa_local_planner {

/// Rolls all samples out with the unicycle model (Kalliokoski 2022, Eq. 1) into tiles of equal omega: heading, sine and
/// cosine are computed once a tile, positions by multiplication and addition only. Keeps its memory between cycles.
class Rollout {
 public:
  /// Samples grouped by omega, as Sampler makes them. `start` is the pose, `reference` the velocity at the start.
  void run(const Parameters& parameters, const VelocityLimits& limits, const Pose2& start, const Twist2& reference,
           const std::vector<Sample>& samples);

  std::size_t tile_count() const { return tiles_.size(); }
  /// A view of a tile, valid until the next run().
  Tile tile(std::size_t index) const;
  /// Kinds in the order of the candidates.
  const std::vector<SampleKind>& kinds() const { return kinds_; }
  std::size_t candidate_count() const { return kinds_.size(); }

 private:
  struct Block {
    double omega = 0.0, dt = 0.0;
    std::size_t steps = 0, first = 0, count = 0;
    std::size_t positions = 0;  // offset into x_ and y_
    std::size_t headings = 0;   // offset into heading_
    bool ramped = true;         // velocities ramp from the reference; else they are the sample's from the start
  };
  void make_tiles(const Parameters& parameters, const std::vector<Sample>& samples);
  void roll_heading(const Parameters& parameters, const VelocityLimits& limits, const Pose2& start,
                    const Twist2& reference, const Block& block);
  void roll_positions(const Parameters& parameters, const VelocityLimits& limits, const Pose2& start,
                      const Twist2& reference, const Block& block);

  std::vector<Block> tiles_;
  std::vector<SampleKind> kinds_;
  std::vector<double> v_;                                // [candidates]
  std::vector<double> x_, y_;                            // blocks of (steps + 1) x count
  std::vector<double> heading_, cos_, sin_, omega_at_;   // blocks of steps + 1
  std::vector<double> step_cos_, step_sin_;              // direction of each step
  std::vector<double> speed_;                            // [count] scratch
};

}  // namespace hidwa_local_planner
