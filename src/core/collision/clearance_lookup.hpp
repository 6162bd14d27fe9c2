// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/collision/clearance_memo.hpp"
#include "core/collision/collision.hpp"

namespace hidwa_local_planner {

/// The clearance of poses of one cycle: how far every point of the robot may move from a pose without colliding, at
/// least. What was found once answers for the poses around it.
class ClearanceLookup {
 public:
  /// Once per evaluation. `checker` is prepared and outlives the questions; `radius` [m] as of ClearanceMemo;
  /// `resolution` of the map [m].
  void prepare(const CollisionChecker& checker, double radius, double resolution) {
    checker_ = &checker;
    extra_ = kExtra * resolution;
    memo_.clear(radius, 0.5 * resolution);
  }
  /// [m]; 0 where the robot collides. Once it is known to be more than `needed` [m], the search ends.
  double at(const Pose2& pose, const Rotation& heading, double needed = 0.0) {
    const double known = memo_.at(pose);
    if (known > needed) return known;
    const double clearance = measure(pose, heading, needed);
    if (clearance > 0.0) memo_.note(pose, clearance);
    return clearance;
  }
  /// Likewise, but always measured: poses around it do not count.
  double measure(const Pose2& pose, const Rotation& heading, double needed) const {
    return checker_->clearance(pose, heading, needed + extra_);
  }
  const CollisionChecker& checker() const { return *checker_; }

 private:
  // The search goes on for so many cells beyond what is needed: what it finds also answers for the next poses.
  static constexpr double kExtra = 2.0;

  const CollisionChecker* checker_ = nullptr;
  double extra_ = 0.0;  // [m]
  ClearanceMemo memo_;
};

}  // namespace hidwa_local_planner
