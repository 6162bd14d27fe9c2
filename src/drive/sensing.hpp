// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "drive/seen_map.hpp"
#include "drive/setup.hpp"
#include "sim/random.hpp"
#include "sim/world.hpp"

namespace hidwa_local_planner {
namespace drive {

/// The robot's laser and the local costmap that its scans make, in the odometry's frame.
class Sensing {
 public:
  /// `setup` must outlive it.
  explicit Sensing(const DriveSetup& setup);

  /// The laser scans, from where the robot is. Only scans that the costmap takes are cast: the newest at each
  /// update.
  void scan(const sim::World& world);

  /// The costmap takes the last scan, around where the robot is now.
  void update_costmap(const sim::World& world);

  GridView costmap() const { return costmap_.view(); }

  /// What was seen so far; only where the setup explores.
  const SeenMap& seen() const { return *seen_; }

 private:
  const DriveSetup& setup_;
  LocalCostmap costmap_;
  std::optional<SeenMap> seen_;
  sim::Random noise_;
  sim::Pose true_pose_;        // of the robot at the last scan, map frame
  sim::Pose odometry_pose_;    // the same in the odometry's frame
  bool is_new_ = false;        // the last scan
  std::vector<float> ranges_;  // [m]
  Beams beams_;
};

}  // namespace drive
}  // namespace hidwa_local_planner
