// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/util/rotation.hpp"
#include "hidwa_local_planner/core/types.hpp"

namespace hidwa_local_planner {

/// Where one planar frame lies in another: its origin and its heading there.
struct FrameTransform {
  Pose2 origin;
  /// A pose of the inner frame, in the outer one.
  Pose2 apply(const Pose2& inner) const {
    const Point at = Rotation::direction(origin.theta).placed(origin.x, origin.y, inner.x, inner.y);
    return {at.x(), at.y(), wrap_angle(origin.theta + inner.theta)};
  }
  /// A pose of the outer frame, in the inner one.
  Pose2 apply_inverse(const Pose2& outer) const {
    const Point at = TurnedPose::of(origin).seen({outer.x, outer.y});
    return {at.x(), at.y(), wrap_angle(outer.theta - origin.theta)};
  }
};

}  // namespace hidwa_local_planner
