// SPDX-License-Identifier: BSD-3-Clause
#include "core/cycle/input_fault.hpp"

#include <algorithm>
#include <cmath>

namespace hidwa_local_planner {
namespace {

// Beyond these a number is no measurement but a fault: no robot this planner serves is so fast or so far away.
constexpr double kFastest = 20.0;      // [m/s]
constexpr double kFastestTurn = 50.0;  // [rad/s]
constexpr double kFarthest = 1e6;      // [m, rad]

constexpr double kLatest = 1e12;          // [s], some 30,000 years
constexpr double kOldestPose = 10.0;      // [s]
constexpr double kShortestPeriod = 1e-3;  // [s]
constexpr double kLongestPeriod = 10.0;   // [s]

// So that the cells up to kFarthest away can be counted by an int.
constexpr double kFinestCell = 1e-3;   // [m]
constexpr double kCoarsestCell = 1e3;  // [m]

// Of what moves: bullets are none of our business.
constexpr double kFastestMover = 100.0;  // [m/s]
constexpr double kLargestMover = 100.0;  // [m]

}  // namespace

bool plausible(const Twist2& u) { return std::abs(u.v) <= kFastest && std::abs(u.omega) <= kFastestTurn; }
bool plausible(const Pose2& q) {
  return std::abs(q.x) <= kFarthest && std::abs(q.y) <= kFarthest && std::abs(q.theta) <= kFarthest;
}

bool plausible(const MovingObstacleEstimate& mover) {
  const auto within = [](double value, double most) { return value >= 0.0 && value <= most; };
  return mover.position.norm() <= kFarthest && mover.velocity.norm() <= kFastestMover &&
         within(mover.radius, kLargestMover) && within(mover.position_deviation, kLargestMover) &&
         within(mover.velocity_deviation, kFastestMover) && within(mover.age, kOldestPose);
}

bool plausible(const GridView& grid) {
  return grid.valid() && grid.resolution >= kFinestCell && grid.resolution <= kCoarsestCell &&
         std::abs(grid.origin_x) <= kFarthest && std::abs(grid.origin_y) <= kFarthest;
}

bool plausible_time(double time) { return std::abs(time) <= kLatest; }
bool plausible_age(double age) { return age >= 0.0 && age <= kOldestPose; }
bool plausible_period(double period) { return period >= kShortestPeriod && period <= kLongestPeriod; }

const char* input_fault(const Cycle& cycle) {
  const GridView& grid = cycle.grid;
  const Situation& situation = cycle.situation;
  if (!grid.valid()) return "the costmap is empty";
  if (!plausible(grid)) {
    return "the costmap's resolution is below 1 mm or above 1 km, or its origin is no place: check its parameters";
  }
  if (!plausible_age(situation.pose_age)) return "the pose is too old: check tf";
  if (const char* fault = cycle.footprint.fault()) return fault;
  if (cycle.footprint.circumscribed_radius() > grid.resolution * std::hypot(grid.size_x, grid.size_y)) {
    return "the footprint is larger than the local map: give it in metres, or make the map larger";
  }
  if (!plausible(situation.pose) || !plausible(situation.velocity) || !plausible(situation.last_command)) {
    return "the pose or the velocity is not a number, or impossibly large: check odometry and tf";
  }
  if (!plausible_time(situation.time)) return "the time is not a number: check the clock";
  if (!plausible_period(situation.period)) {
    return "the control period is below 1 ms or above 10 s: set controller_frequency";
  }
  if (situation.plan.empty() && !situation.goalless) return "the plan is empty";
  const MovingObstacleEstimates& movers = situation.moving_obstacles;
  if (!std::all_of(movers.begin(), movers.end(),
                   [](const MovingObstacleEstimate& mover) { return plausible(mover); })) {
    return "a moving obstacle is not a number, or impossible: check what publishes moving_obstacles_topic";
  }
  const auto bad = [](const Pose2& pose) { return !plausible(pose); };
  if (bad(situation.goal) || std::any_of(situation.plan.begin(), situation.plan.end(), bad)) {
    return "a pose of the plan is not a number, or impossibly large: check the global planner";
  }
  if (cycle.intent.influence != Influence::none && !is_finite(cycle.intent.u_h)) {
    return "the operator command is not a number: check the input device";
  }
  return nullptr;
}

}  // namespace hidwa_local_planner
