// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace hidwa_local_planner {

/// How the tracker judges; docs/understand/tracker.md explains each.
struct TrackerSettings {
  double reach = 12.0;            // what is farther from the sensor is not looked at [m]
  double range_noise = 0.02;      // standard deviation of a range [m]
  bool no_return_is_free = true;  // a beam that met nothing saw free space up to `reach`
  double odometry_slip = 0.05;    // error of odometry, as a share of what was driven and turned
  double free_memory = 8.0;       // how long seen free space counts [s]
  double settle_time = 1.0;       // what has stood so long belongs to the costmap [s]
  double stand_time = 10.0;       // a track that stood so long is dropped [s]
  double coast_time = 2.0;        // a track that was not seen so long is dropped [s]
  double min_speed = 0.2;         // of what becomes a track [m/s]
  double min_radius = 0.3;        // of what is published [m]
  double max_radius = 0.65;       // what is larger is no mover [m]
  double acceleration = 0.8;      // a mover's usual one, for the filter [m/s^2]
  double leg_acceleration = 1.6;  // the same of who is seen by two legs [m/s^2]
};

/// Why the settings cannot be used, naming the value and its range; empty: they can.
std::string fault_of(const TrackerSettings& settings);

}  // namespace hidwa_local_planner
