// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "sim/mover.hpp"

namespace hidwa_local_planner {
namespace sim {

/// What a laser sees of all movers at one moment: a disc each, or two legs each, which hide one another and what is
/// behind them.
class Silhouettes {
 public:
  Silhouettes() = default;
  explicit Silhouettes(const std::vector<Mover>& movers);

  /// What a ray meets first.
  struct Hit {
    double range;       // [m]; infinite where it meets nobody within the range asked for
    std::size_t mover;  // index among the movers; counts where the range is finite only
  };

  /// From (x, y) in direction `angle` [rad], at most `range_max` [m] far; 0 inside a body.
  Hit cast(double x, double y, double angle, double range_max) const;

  struct Disc {
    Eigen::Vector2d centre;  // [m]
    double radius;           // [m]
    std::size_t mover;       // index
  };
  const std::vector<Disc>& discs() const { return discs_; }

 private:
  std::vector<Disc> discs_;
};

/// Where a person's legs are: two discs of kLegRadius [m] beside the centre, each swinging to and fro along the
/// heading, against the other; standing still they stand side by side.
constexpr double kLegRadius = 0.07;   // [m]
constexpr double kLegSpacing = 0.20;  // [m], between the legs' centres, across
constexpr double kLegSwing = 0.18;    // [m], of a leg's centre to the front and to the back at a brisk walk
constexpr double kStride = 1.4;       // [m], walked in one period of the gait: two steps

}  // namespace sim
}  // namespace hidwa_local_planner
