// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include "drive/gentleness.hpp"
#include "hidwa_local_planner/core/decision.hpp"
#include "hidwa_local_planner/core/operator_intent.hpp"
#include "hidwa_local_planner/core/types.hpp"
#include "sim/people_watch.hpp"
#include "sim/polygon.hpp"

namespace hidwa_local_planner {
namespace drive {

/// How a drive ended.
enum class Ending { arrived, given_up, no_plan, out_of_time, contact };
const char* to_string(Ending ending);

/// One control cycle of a drive.
struct DriveSample {
  double time = 0.0;  // [s], since the start
  sim::Pose pose;     // map frame
  Twist2 command;     // [m/s, rad/s], as sent
  Twist2 wanted;      // [m/s, rad/s], by the person
  OperatorStateId state = OperatorStateId::autonomy;
  Outcome outcome = Outcome::drive;
  std::string problem;  // as the decision has it
};

constexpr double kFarClearance = 1.0;  // [m], up to here clearances are measured

/// How a drive went among people, see sim::PeopleWatch.
struct PeopleResult {
  int contacts_moving = 0;                                   // touches that began while the robot moved
  int contacts_at_rest = 0;                                  // while it stood
  int encounters = 0;                                        // with somebody within 1 m of the moving robot
  double closest = std::numeric_limits<double>::infinity();  // [m], of anybody's disc to the robot itself
  double personal_space = 0.0;                               // [s], moving within 0.5 m of somebody
  double standing = 0.0;                                     // [s], the robot stood
  std::vector<sim::Touch> touches;
};

/// A drive in figures.
struct DriveResult {
  Ending ending = Ending::out_of_time;
  bool arrived = false;
  double duration = 0.0;  // [s]
  double length = 0.0;    // [m], driven
  int contacts = 0;       // with what does not move
  PeopleResult people;
  int regions_crossed = 0;
  double clearance = kFarClearance;  // [m], of the robot itself at its control cycles, the smallest
  double mean_clearance = 0.0;       // [m], their mean, each at most kFarClearance
  std::size_t cycles = 0;
  std::size_t failures = 0;   // cycles without a command
  std::size_t brakes = 0;     // cycles that braked for want of anything legal
  double v_change = 0.0;      // [m/s], mean absolute change from command to command
  double omega_change = 0.0;  // [rad/s], likewise
  Gentleness gentleness;
  int interventions = 0;         // how often the person began to steer
  double operator_active = 0.0;  // [s], steered
  double agreement = 1.0;        // mean over the steered cycles; 1 where there are none
  double planning_time = 0.0;    // [s], computing time in Planner::plan by the wall clock
  std::vector<DriveSample> samples;
};

}  // namespace drive
}  // namespace hidwa_local_planner
