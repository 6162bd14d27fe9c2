// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "sim/diff_drive.hpp"
#include "sim/disc_field.hpp"
#include "sim/mover.hpp"
#include "sim/occupancy_map.hpp"
#include "sim/odometry.hpp"
#include "sim/people_watch.hpp"
#include "sim/regions.hpp"

namespace hidwa_local_planner {
namespace sim {

/// What a simulated drive needs.
struct WorldSetup {
  std::shared_ptr<const OccupancyMap> map;
  std::shared_ptr<const DiscField> discs;  // obstacles besides the map's; null: none
  std::shared_ptr<People> people;          // who walks around in it; of this world alone; null: nobody
  std::vector<Region> regions;
  Polygon footprint;  // [m], unpadded, robot frame
  DriveLimits limits;
  OdometryNoise odometry_noise;
  Pose start;              // map frame
  std::uint64_t seed = 1;  // of the odometry noise
};

/// The robot in its true map. Every 10 ms or finer its unpadded footprint is tested against the map
/// and the discs. A
/// contact is one uninterrupted overlap: the robot is stopped where it first touches, at most a few
/// micrometres deep, so that the recorded poses show the contact too, and stays until it moves to a pose that
/// is free. People do not stop the robot; that they and it touch is what watch() counts, at the same times.
class World {
 public:
  /// Throws std::invalid_argument where the start overlaps an obstacle or the setup makes no sense.
  explicit World(WorldSetup setup);

  /// A velocity command that arrives now.
  void command(const Velocity& velocity) { drive_.command(velocity, time_); }

  /// Advances by `dt` [s], in steps of 10 ms or less.
  void advance(double dt);

  double time() const { return time_; }  // [s], since the start
  const Pose& pose() const { return pose_; }
  const Velocity& velocity() const { return drive_.velocity(); }
  const Odometry& odometry() const { return odometry_; }
  const RegionCounter& regions() const { return regions_; }
  const OccupancyMap& map() const { return *setup_.map; }
  const Polygon& footprint() const { return setup_.footprint; }
  int contacts() const { return contacts_; }
  bool in_contact() const { return in_contact_; }
  /// Who is around; empty where there is nobody.
  const std::vector<Mover>& movers() const;
  const PeopleWatch& watch() const { return watch_; }
  double distance() const { return distance_; }  // [m], driven so far

 private:
  void step(double dt);
  void people_step(double dt);
  RobotSeen seen() const;
  bool is_free(const Pose& pose) const;
  // Both move the robot and return what was moved.
  Motion stop_at_obstacle(const Motion& motion);
  Motion leave_obstacle(const Motion& motion);

  WorldSetup setup_;
  DiffDrive drive_;
  Odometry odometry_;
  RegionCounter regions_;
  PeopleWatch watch_;
  Pose pose_;
  Pose last_free_;         // while in contact: the free pose just before it
  double time_ = 0.0;      // [s]
  double distance_ = 0.0;  // [m]
  int contacts_ = 0;
  bool in_contact_ = false;
};

}  // namespace sim
}  // namespace hidwa_local_planner
