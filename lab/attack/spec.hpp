// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "base.hpp"
#include "hidwa_local_planner/core/parameters.hpp"
#include "shape.hpp"
#include "walkers.hpp"
#include "world.hpp"
#include "world_building.hpp"

namespace hidwa_attack {

using hidwa_local_planner::Parameters;

enum class Odometry {
  exact,
  noisy,     // some per cent off
  outliers,  // 1 % of the readings are up to 10 m/s and 20 rad/s
  slips,     // 2 % of the readings are zero, of the other sign, or a part of the true one
  delayed,   // by the base's latency
  silent,    // for 0.3 to 1.5 s, now and then
  flickers,  // silent for one to three cycles, again and again
  dead       // 0, now and then for good
};

enum class Start {
  free,
  stray,     // with cells under the outline
  grazing,   // in the edge of an obstacle
  appearing  // free; later the map adds cells under the outline
};

/// How the stick's messages come to the planner.
enum class Link {
  prompt,
  late,      // now and then a second late; then all at once
  frozen,    // now and then the same message again and again
  silent,    // now and then not at all
  nonsense,  // not a number, beyond bounds, axes missing, stamps of any time
};

/// In which way the person has the robot; with `nobody` autonomy drives.
enum class Steering { either, nobody, shared, manual };

/// What one drive is. Times of the host and of the base in whole milliseconds.
struct Spec {
  Outline outline = Outline::octagon;
  Parameters parameters;
  int period = 50;   // of the control cycle [ms]
  int seconds = 20;  // [s]

  Place place = Place::posts;
  std::shared_ptr<const World> ground;  // a part of it instead of a place that is made up; its cells count
  double resolution = 0.05;             // [m]
  Start start = Start::free;

  int latency = 100;            // the base's own; the planner is told parameters.control_latency [ms]
  bool latency_varies = false;  // from command to command, from 0 on; none overtakes another
  Reaching reaching = Reaching::evenly;
  double brakes = 1.0;  // the base's deceleration limits, as a share of those told

  double late_share = 0.0;  // of the cycles
  double late_most = 0.0;   // [periods]
  bool catches_up = false;  // after a late cycle, as ros::Rate does
  bool surprises = false;   // later than any of the last 3 s, also while the robot moves
  bool late_again = false;  // as late as it may be, each time when the last such cycle is about to be forgotten

  bool clock_set = false;  // the clock is set back again and again

  Odometry odometry = Odometry::exact;
  int pose_age = 0;      // [ms]
  bool age_told = true;  // the pose's stamp is known
  double flicker = 0.0;  // probability that a free cell beside a lethal one is seen as lethal, in each cycle
  int map_delay = -1;    // of what is seen [ms]; negative: the whole window is known
  bool limits_change = false;
  double slip = 0.0;  // what the base drives is off from its wheels by up to this share, drawn anew twice a second

  Link link = Link::prompt;
  Steering steering = Steering::either;
  bool relentless = false;  // the person hardly ever rests
  double goalless = 0.0;    // the share of time in which the host has no goal
  int walkers = 0;
  Bounds bounds;  // of walkers
  bool walkers_told = true;
  bool points_told = false;  // also which points of the map are theirs
};

}  // namespace hidwa_attack
