// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include <Eigen/Core>

#include "sim/floor_ways.hpp"
#include "sim/mover.hpp"
#include "sim/random.hpp"

namespace hidwa_local_planner {
namespace sim {

/// What a crowd depends on: equal setups, robots and times give the same crowd.
struct CrowdSetup {
  std::shared_ptr<const FloorWays> ways;
  int people = 4;
  std::uint64_t seed = 1;
  double speed = 1.1;            // [m/s], at which people like to walk, on average
  double speed_deviation = 0.2;  // [m/s], from person to person
  double max_speed = 1.5;        // [m/s], never exceeded
  double max_acc = 1.5;          // [m/s^2], likewise
  double radius = 0.30;          // [m], of the disc that holds a person with both legs
  Body body = Body::legs;
  double yielding = 1.0;    // share of people who keep away from the robot; the others do not mind it
  double in_groups = 0.3;   // share of people who walk in groups of two or three
  double mean_stroll = 20;  // [s], after which people stop on their way, for 1 to 3 s, on average
  double longest_stay = 6;  // [s], at a place
  RobotSeen robot;          // at the start, when everybody keeps kClear away
  /// Tours through the places by their index, over and over again, begun at the first one, person by person; who has
  /// none goes from one place to another at random.
  std::vector<std::vector<std::size_t>> tours;

  static constexpr double kClear = 3.0;  // [m]
};

/// People who walk from place to place, stop, turn and wait, alone and in groups, and who keep clear of walls and of
/// one another by social forces (social_force.hpp). Neither speed nor acceleration exceeds its bound, and nobody walks
/// into a wall: a step is taken only if braking from there ends in front of it.
class Crowd : public People {
 public:
  /// Throws std::invalid_argument where the setup makes no sense, or there is no room.
  explicit Crowd(const CrowdSetup& setup);

  void advance(double time, const RobotSeen& robot) override;

 private:
  // Who walk together.
  struct Group {
    std::vector<std::size_t> members;
    std::vector<std::size_t> tour;
    std::size_t stop = 0;        // of the tour: where they go
    std::size_t place = 0;       // where they go
    double waits_until = 0.0;    // [s]
    double strolls_until = 0.0;  // [s]
  };
  struct Walker {
    std::size_t group = 0;
    double speed = 0.0;  // [m/s], that they like
    bool yields = true;
    Route way;
    std::size_t next = 0;   // of the way: up to here they have come
    double progress = 0.0;  // [s], when they last came further
    double faces = 0.0;     // [rad], while they stand
  };

  void make_groups();
  void place(std::size_t person);
  void set_out(Group& group, double now);
  void find_way(std::size_t person, double now);
  void step(double now, double dt, const RobotSeen& robot);
  void plan(Group& group, double now);
  Eigen::Vector2d wanted_velocity(std::size_t person, double now);
  Eigen::Vector2d forces(std::size_t person, const Eigen::Vector2d& wanted, const RobotSeen& robot) const;
  Eigen::Vector2d wall_force_on(std::size_t person, const Eigen::Vector2d& wanted) const;
  Eigen::Vector2d towards_group(std::size_t person) const;
  Eigen::Vector2d within_bounds(const Eigen::Vector2d& velocity, const Eigen::Vector2d& acceleration, double dt) const;
  bool can_stop(const Eigen::Vector2d& from, const Eigen::Vector2d& velocity, double dt) const;
  void turn(Mover& mover, const Walker& walker, double dt) const;

  CrowdSetup setup_;
  Random random_;
  std::vector<Group> groups_;
  std::vector<Walker> walkers_;  // as movers_
  double time_ = 0.0;            // [s]
};

}  // namespace sim
}  // namespace hidwa_local_planner
