// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "core/util/rotation.hpp"
#include "hidwa_local_planner/core/footprint.hpp"
#include "hidwa_local_planner/core/types.hpp"

namespace hidwa_local_planner {

/// The sides of a convex outline and of its box, turned and each moved outwards by a cell's reach: n . p - offset is
/// how far a cell with the centre p lies beyond one. Two convex shapes share area unless a side of one has the other
/// beyond it.
class OutlinePlanes {
 public:
  /// Room for a usual outline.
  void reserve();
  /// Of `outline` at `pose`; `half` [m] is half a cell's side.
  void turn(const Footprint& outline, const Pose2& pose, const Rotation& heading, double half);

  std::size_t count() const { return offset_.size(); }
  const double* normal_x() const { return normal_x_.data(); }
  const double* normal_y() const { return normal_y_.data(); }
  const double* offset() const { return offset_.data(); }  // [m]

 private:
  std::vector<double> normal_x_, normal_y_, offset_;
};

}  // namespace hidwa_local_planner
