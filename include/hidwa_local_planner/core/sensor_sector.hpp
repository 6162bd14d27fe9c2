// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "hidwa_local_planner/core/types.hpp"

namespace hidwa_local_planner {

/// Of somebody whom no sensor sees [m]; nobody is thinner.
constexpr double kBodyRadius = 0.2;

/// What a sensor on the robot looks at.
struct SensorSector {
  Pose2 pose;          // of the sensor; it faces the middle of its field of view; robot frame
  double width = 0.0;  // of its field of view; from 2 pi on it looks all round [rad]
  double range = 0.0;  // [m]

  /// Whether a point of the robot frame [m] lies in it.
  bool contains(const Point& point) const;

  template <typename Self, typename Archive>
  static void archive(Self& self, Archive& io) {
    io(self.pose, self.width, self.range);
  }
};

bool operator==(const SensorSector& a, const SensorSector& b);

/// Of all sensors; empty where it is not known what the robot sees.
using SensorSectors = std::vector<SensorSector>;

/// The parameter `sensor_sectors`: "x y direction width range" of each sensor in m and degrees, with ';' between two of
/// them; "all": one that sees all round from the robot's centre. On a fault `fault` says it in words.
SensorSectors parse_sensor_sectors(const std::string& text, std::string& fault);

}  // namespace hidwa_local_planner
