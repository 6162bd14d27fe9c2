// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "hidwa_local_planner/core/types.hpp"

namespace hidwa_local_planner {

/// One scan of a planar laser, as sensor_msgs/LaserScan means it, and where the sensor was.
/// A range that is infinite or not below range_max is a beam that met nothing. One that is not a number or below
/// range_min says nothing.
struct RangeScan {
  double stamp = 0.0;            // of the first beam [s]
  double time_increment = 0.0;   // from beam to beam; 0: all at once [s]
  double angle_min = 0.0;        // of the first beam, sensor frame, counter-clockwise [rad]
  double angle_increment = 0.0;  // from beam to beam; negative: clockwise [rad]
  double range_min = 0.0;        // [m]
  double range_max = 0.0;        // [m]
  std::vector<float> ranges;     // [m]
  Pose2 sensor;                  // at the first beam, fixed frame
  Pose2 sensor_end;              // at the last beam, fixed frame

  /// When the last beam was measured [s].
  double end() const {
    return ranges.size() < 2 ? stamp : stamp + time_increment * static_cast<double>(ranges.size() - 1);
  }
};

/// What became of a scan.
enum class ScanUse {
  used,
  repeated,    // not later than the one before: nothing changed
  after_jump,  // used; time went back or stood still for long, so all that was remembered is forgotten
  refused,     // fault_of(scan) says why: nothing changed
};

/// Why a scan cannot be used, in words; empty: it can.
std::string fault_of(const RangeScan& scan);

}  // namespace hidwa_local_planner
