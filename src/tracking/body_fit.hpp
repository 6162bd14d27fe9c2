// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "tracking/beams.hpp"
#include "tracking/segments.hpp"

namespace hidwa_local_planner {
namespace tracking {

/// A round body, of which beams see one side.
struct BodyFit {
  Point centre{0.0, 0.0};                                // fixed frame [m]
  double radius = 0.0;                                   // [m]
  bool radius_seen = false;                              // both sides were in view: the radius is measured, not assumed
  double radius_deviation = 0.0;                         // [m]
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();  // of the centre [m^2]
  double unevenness = 0.0;   // how far its surface is from the circle (rms), beyond the noise [m]
  double wider = 0.0;        // radius by the edges alone, less what was known; where radius_seen [m]
  double wider_noise = 0.0;  // deviation of that, from the spacing of the beams [m]
  double time = 0.0;         // when it was measured [s]
  double distance = 0.0;     // of the centre from the sensor [m]

  /// Adds an error that has this deviation along any axis [m].
  void blur(double deviation) { covariance.diagonal().array() += deviation * deviation; }
};

/// What is known of a body before it is seen.
struct KnownShape {
  double radius = 0.0;              // [m]
  double deviation = 0.0;           // of the radius [m]
  double unevenness = kUnevenness;  // of its surface, rms [m]

  static constexpr double kUnevenness = 0.015;  // usual [m]
};

/// Fits a circle to a segment, by its edges alone.
BodyFit fit_body(const Beams& beams, const Segment& segment, double range_noise);

/// The same of a body of which something is known. Where something hides an edge, the circle is fitted to the arc in
/// view.
BodyFit fit_body(const Beams& beams, const Segment& segment, const KnownShape& shape, double range_noise);

}  // namespace tracking
}  // namespace hidwa_local_planner
