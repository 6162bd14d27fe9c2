// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <hidwa_local_planner/MovingObstacles.h>
#include <ros/node_handle.h>
#include <ros/publisher.h>

#include "sim/crowd.hpp"
#include "sim/laser.hpp"
#include "sim/people_watch.hpp"
#include "sim/world.hpp"

namespace hidwa_local_planner {
namespace sim {

/// The crowd that hidwa_sim_node's private parameters ask for, in this world; null where ~people is 0. Throws
/// std::runtime_error or std::invalid_argument naming the parameter at fault.
std::shared_ptr<People> read_people(const ros::NodeHandle& node, const WorldSetup& world);

/// What the robot's scan sees of people, and what the node says of them: moving_obstacles_truth (with the beams' end
/// points on them), also as moving_obstacles where ~tell_truth is set, people as markers, and the latched counts
/// contacts_moving and contacts_at_rest.
class NodePeople {
 public:
  /// `frame`: the map's.
  NodePeople(ros::NodeHandle& node, std::string frame, bool tell_truth);

  /// A scan of the map and of everybody in it.
  void scan(const OccupancyMap& map, const LaserSpec& spec, const Pose& sensor, const std::vector<Mover>& movers,
            Random& random, std::vector<float>& ranges);

  /// Where everybody is now, with what the last scan saw of them.
  void publish(const ros::Time& stamp, const std::vector<Mover>& movers);

  /// The counts, where they have changed.
  void publish_touches(const PeopleWatch& watch);

 private:
  std::string frame_;
  ros::Publisher truth_, told_, markers_, moving_, at_rest_;
  std::vector<std::vector<Eigen::Vector2d>> points_;  // of the last scan, by mover [m]
  int known_moving_ = -1, known_at_rest_ = -1;
};

}  // namespace sim
}  // namespace hidwa_local_planner
