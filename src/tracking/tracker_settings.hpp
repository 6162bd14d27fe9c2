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

/// One of the numbers among them, and the range that it must lie in.
struct TrackerSetting {
  const char* name;
  double TrackerSettings::*value;
  double low, high;
  const char* unit;
};

inline constexpr TrackerSetting kTrackerSettings[] = {
    {"reach", &TrackerSettings::reach, 1.0, 30.0, " m"},
    {"range_noise", &TrackerSettings::range_noise, 0.001, 0.2, " m"},
    {"odometry_slip", &TrackerSettings::odometry_slip, 0.0, 0.5, ""},
    {"free_memory", &TrackerSettings::free_memory, 0.5, 60.0, " s"},
    {"settle_time", &TrackerSettings::settle_time, 0.2, 10.0, " s"},
    {"stand_time", &TrackerSettings::stand_time, 0.5, 30.0, " s"},
    {"coast_time", &TrackerSettings::coast_time, 0.1, 5.0, " s"},
    {"min_speed", &TrackerSettings::min_speed, 0.05, 2.0, " m/s"},
    {"min_radius", &TrackerSettings::min_radius, 0.0, 1.5, " m"},
    {"max_radius", &TrackerSettings::max_radius, 0.1, 1.5, " m"},
    {"acceleration", &TrackerSettings::acceleration, 0.1, 20.0, " m/s^2"},
    {"leg_acceleration", &TrackerSettings::leg_acceleration, 0.1, 20.0, " m/s^2"},
};

/// Why the settings cannot be used, naming the value and its range; empty: they can.
std::string fault_of(const TrackerSettings& settings);

}  // namespace hidwa_local_planner
