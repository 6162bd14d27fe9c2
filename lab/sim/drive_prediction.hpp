// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "sim/diff_drive.hpp"
#include "sim/distance_field.hpp"
#include "sim/grid_route.hpp"
#include "sim/occupancy_map.hpp"
#include "sim/regions.hpp"

namespace hidwa_local_planner {
namespace sim {

/// What a person has learnt of the robot by driving it.
struct RobotHabits {
  double max_vel_x = 0.5;      // [m/s]
  double max_vel_theta = 1.0;  // [rad/s]
  double acc_lim_theta = 3.2;  // [rad/s2]
  double radius = 0.30;        // [m], of the circle that holds it
  double dead_zone = 0.1;      // of the stick
  double hold_time = 2.0;      // [s], after a release it goes straight on for this time
  double refusal_time = 1.7;   // [s], it refuses arcs that hit a wall within this time
  double pursuit = 0.6;        // [m], how far ahead on its plan it aims
};

/// Turning speed that a stick position asks for [rad/s]: none in the dead zone, else squared (Kalliokoski
/// 2022).
double asked_omega(double left, const RobotHabits& habits);

/// Predicts, roughly as a person would, where the robot goes: a disc at full speed.
class DrivePrediction {
 public:
  static constexpr double kStep = 0.1;  // [s]

  /// Where the robot is and how fast it turns.
  struct State {
    Pose pose;           // map frame
    double omega = 0.0;  // [rad/s]
  };

  DrivePrediction(const RobotHabits& habits, const OccupancyMap& map, const std::vector<Region>& regions);

  /// One step on, turning towards `omega` [rad/s].
  State steered(const State& state, double omega) const;

  /// One step on, following the plan. `nearest`: index of the plan's point nearest to the robot, kept up to
  /// date.
  State following(const State& state, const Route& plan, std::size_t& nearest) const;

  /// Whether the robot would refuse to turn with `omega` from here.
  bool refuses(State state, double omega) const;

  /// Free space between the robot and the nearest region or wall; negative inside [m].
  double region_gap(const Pose& pose) const;
  double wall_gap(const Pose& pose) const;

 private:
  RobotHabits habits_;
  DistanceField regions_;
  DistanceField walls_;
  double half_cell_;  // [m]
};

/// Index of the point nearest to (x, y) among plan[first] and those within the next `reach` [m].
std::size_t nearest_index(const Route& plan, std::size_t first, double reach, double x, double y);

}  // namespace sim
}  // namespace hidwa_local_planner
