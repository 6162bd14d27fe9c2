// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "hidwa_local_planner/core/types.hpp"

namespace hidwa_local_planner {

/// Where one planar frame lies in another: its origin and its heading there.
struct FrameTransform {
  Pose2 origin;
  /// A pose of the inner frame, in the outer one.
  Pose2 apply(const Pose2& inner) const {
    const double c = std::cos(origin.theta), s = std::sin(origin.theta);
    return {origin.x + c * inner.x - s * inner.y, origin.y + s * inner.x + c * inner.y,
            wrap_angle(origin.theta + inner.theta)};
  }
  /// A pose of the outer frame, in the inner one.
  Pose2 apply_inverse(const Pose2& outer) const {
    const double c = std::cos(origin.theta), s = std::sin(origin.theta);
    const double dx = outer.x - origin.x, dy = outer.y - origin.y;
    return {c * dx + s * dy, -s * dx + c * dy, wrap_angle(outer.theta - origin.theta)};
  }
};

}  // namespace hidwa_local_planner
