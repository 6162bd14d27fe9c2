// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "hidwa_local_planner/core/sensor_sector.hpp"
#include "tracking/beams.hpp"
#include "tracking/range_scan.hpp"

namespace hidwa_local_planner {
namespace tracking {

/// What the laser looks at: all beams that have ever said anything. Beams that a mast or the driver masks never do.
class FieldOfView {
 public:
  void add(const RangeScan& scan, const Beams& beams);
  /// In the sensor's frame, up to its range or `reach` [m]. Gaps that are narrower than 10 degrees count as looked at.
  SensorSectors sectors(double reach) const;

 private:
  std::vector<std::uint8_t> answered_;  // [beams]
  double first_ = 0.0;                  // bearing of the first beam, sensor frame [rad]
  double increment_ = 0.0;              // from beam to beam [rad]
  double range_ = 0.0;                  // of the laser [m]
  bool whole_turn_ = false;
};

}  // namespace tracking
}  // namespace hidwa_local_planner
