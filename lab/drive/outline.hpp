// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "hidwa_local_planner/core/types.hpp"
#include "sim/polygon.hpp"

namespace hidwa_local_planner {
namespace drive {

/// The demo's robot itself, an octagon in a circle of 0.30 m: launch/params/telepresence_footprint.yaml [m].
sim::Polygon telepresence_footprint();

/// The outline that costmap_2d makes of `robot_radius` and `footprint_padding` [m]: 16 corners, padded.
Polygon circle_outline(double robot_radius, double padding);

/// An outline as costmap_2d pads it: each coordinate that is not 0 moves away from the origin by `padding`
/// [m].
Polygon padded_outline(Polygon outline, double padding);

}  // namespace drive
}  // namespace hidwa_local_planner
