// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "hidwa_local_planner/core/moving_obstacle.hpp"
#include "hidwa_local_planner/core/sensor_sector.hpp"
#include "hidwa_local_planner/core/types.hpp"

namespace hidwa_local_planner {

/// What a cycle starts from. Poses are in the costmap frame.
struct Situation {
  Pose2 pose;                   // of the robot, as it was measured `pose_age` ago
  Twist2 velocity;              // measured by odometry [m/s, rad/s]
  double velocity_time = 0.0;   // when that was heard [s]; 0: in this cycle
  Twist2 last_command;          // what was sent last, in the cycle before [m/s, rad/s]
  std::vector<Pose2> plan;      // the window of the global plan around the robot, see PlanWindow
  Pose2 goal;                   // the last pose of the full plan
  bool goal_latched = false;    // the position of the goal was reached, see GoalChecker
  bool goal_next = true;        // false: more of the plan is to be driven before the goal counts, however near it is
  bool goalless = false;        // the operator drives without a goal: there is no plan, and `goal` is the pose
  bool turns_back = false;      // the window ends where the plan turns back: the robot is to get there first
  double period = 0.05;         // nominal, of the control cycle [s]
  double longest_period = 0.0;  // in the last seconds, see PeriodWatch: the next cycle comes no later [s]; 0: period
  double pose_age = 0.0;        // how old the pose is [s]; the planner adds the motion since then
  bool resumed = false;         // the host paused and others may have driven: last_command is the velocity of now
  double time = 0.0;            // [s]
  MovingObstacleEstimates moving_obstacles;
  SensorSectors sensor_sectors;  // as the tracker tells them; the parameter of this name goes before
};

/// How much a cycle finds out about its candidates. Each level includes the one before. All levels give the same
/// command, to the bit.
enum class Report : std::uint8_t {
  chosen = 0,  // collision and braking are checked only as far as the choice needs it
  legality,    // they are checked for every candidate: what is said of who rejects it is complete
  full         // every critic is asked about every candidate, whoever has rejected it; takes several times as long, and
               // allocates
};

/// How much a cycle computes. It is an input of plan(), so that a recorded cycle can be repeated.
struct Sampling {
  int vx_samples = 0;    // 0: as in the parameters
  int vth_samples = 0;   // 0: as in the parameters
  int search_poses = 0;  // of a search for a way; 0: as in the parameters
  Report report = Report::chosen;
};

}  // namespace hidwa_local_planner
