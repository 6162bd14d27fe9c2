// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "drive/people_sight.hpp"
#include "drive/seen_map.hpp"
#include "drive/setup.hpp"
#include "sim/random.hpp"
#include "sim/silhouettes.hpp"
#include "sim/world.hpp"
#include "tracking/tracker.hpp"

namespace hidwa_local_planner {
namespace drive {

/// The robot's laser and the local costmap that its scans make, in the odometry's frame.
class Sensing {
 public:
  /// `setup` must outlive it.
  explicit Sensing(const DriveSetup& setup);

  /// The laser scans, from where the robot is. Only scans that are taken are cast: without a tracker the
  /// newest at each update of the costmap.
  void scan(const sim::World& world);

  /// The costmap takes the last scan, around where the robot is now.
  void update_costmap(const sim::World& world);

  /// What the planner is told of people, as the setup's tracking has it, where they are now; costmap frame.
  MovingObstacleEstimates moving_obstacles(const sim::World& world, const sim::Pose& map_in_odometry) const;

  /// What the laser looks at, robot frame; empty without a tracker.
  SensorSectors sensor_sectors() const;

  GridView costmap() const { return costmap_.view(); }

  /// What was seen so far; only where the setup explores.
  const SeenMap& seen() const { return *seen_; }

 private:
  void cast();
  void track(double now);
  void remember_people(const sim::Pose& sensor);

  const DriveSetup& setup_;
  LocalCostmap costmap_;
  std::optional<SeenMap> seen_;
  PeopleSight people_;
  std::optional<Tracker> tracker_;
  sim::Random noise_;
  sim::Pose true_pose_;             // of the robot at the last scan, map frame
  sim::Pose odometry_pose_;         // the same in the odometry's frame
  bool is_new_ = false;             // the last scan
  sim::Silhouettes silhouettes_;    // at the last scan
  std::vector<std::uint32_t> ids_;  // of the movers, likewise
  std::vector<float> ranges_;       // [m]
  std::vector<std::uint32_t> met_;  // whom each beam meets; 0: nobody
  Beams beams_;
};

}  // namespace drive
}  // namespace hidwa_local_planner
