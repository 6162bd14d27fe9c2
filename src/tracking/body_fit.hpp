// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tracking/beams.hpp"
#include "tracking/segments.hpp"

namespace hidwa_local_planner {
namespace tracking {

/// A round body, of which beams see one side.
struct BodyFit {
  Point centre{0.0, 0.0};    // fixed frame [m]
  double radius = 0.0;       // [m]
  bool radius_seen = false;  // both sides were in view: the radius is measured, not assumed
  double deviation = 0.0;    // standard deviation of the centre, along any axis [m]
  double time = 0.0;         // when it was measured [s]
  double distance = 0.0;     // of the centre from the sensor [m]
};

/// Fits a circle to a segment. `known_radius` [m] is used where the segment does not show the body's width; with
/// `insist` it is used anyway.
BodyFit fit_body(const Beams& beams, const Segment& segment, double known_radius, bool insist, double range_noise);

}  // namespace tracking
}  // namespace hidwa_local_planner
