// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "drive/beams.hpp"
#include "drive/inflation.hpp"
#include "drive/rolling_grid.hpp"
#include "hidwa_local_planner/core/grid_view.hpp"
#include "hidwa_local_planner/core/types.hpp"
#include "sim/polygon.hpp"

namespace hidwa_local_planner {
namespace drive {

/// A local costmap, in the words of costmap_2d; the defaults are those of launch/params.
struct CostmapSettings {
  double width = 4.0;           // [m], and its height
  double resolution = 0.05;     // [m]
  double obstacle_range = 3.0;  // [m], beam ends farther away are not marked
  double raytrace_range = 3.5;  // [m], beams clear so far
  InflationSettings inflation;
};

/// The rolling local costmap that costmap_2d's obstacle and inflation layers make of laser scans. Unknown
/// space is not tracked: what was never seen is free.
class LocalCostmap {
 public:
  /// `outline`: the robot's padded footprint [m], robot frame.
  LocalCostmap(const CostmapSettings& settings, Polygon outline);

  /// One update round the robot's pose (costmap frame): beams clear, then mark, then the robot clears where
  /// it stands.
  void update(const sim::Pose& robot, const Beams& beams);

  GridView view() const { return costs_.view(); }

 private:
  CostmapSettings settings_;
  Polygon outline_;
  RollingGrid obstacles_;
  RollingGrid costs_;
  Inflation inflation_;
};

}  // namespace drive
}  // namespace hidwa_local_planner
