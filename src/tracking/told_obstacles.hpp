// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "hidwa_local_planner/tracking/range_scan.hpp"
#include "hidwa_local_planner/tracking/tracker_settings.hpp"

namespace hidwa_local_planner {
namespace tracking {

/// A moving obstacle as the node tells it. The messages' types bear the names of the core's, so no source can include
/// both.
struct ToldObstacle {
  std::uint32_t id = 0;
  Point position{0.0, 0.0};         // fixed frame [m]
  Point velocity{0.0, 0.0};         // [m/s]
  double radius = 0.0;              // [m]
  double position_deviation = 0.0;  // [m]
  double velocity_deviation = 0.0;  // [m/s]
  std::vector<Point> points;        // [m]
};

/// A Tracker, without the core's types.
class TellingTracker {
 public:
  explicit TellingTracker(const TrackerSettings& settings);
  ~TellingTracker();
  TellingTracker(const TellingTracker&) = delete;
  TellingTracker& operator=(const TellingTracker&) = delete;

  ScanUse update(const RangeScan& scan);
  std::vector<ToldObstacle> obstacles() const;
  double stamp() const;            // of obstacles() [s]
  std::size_t candidates() const;  // not yet known to move

 private:
  struct Held;
  std::unique_ptr<Held> held_;
};

}  // namespace tracking
}  // namespace hidwa_local_planner
