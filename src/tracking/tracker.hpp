// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <memory>

#include "hidwa_local_planner/core/moving_obstacle.hpp"
#include "hidwa_local_planner/core/sensor_sector.hpp"
#include "tracking/range_scan.hpp"
#include "tracking/tracker_settings.hpp"

namespace hidwa_local_planner {

/// Moving obstacles out of laser scans. A point that lies where space was seen free a moment ago belongs to something
/// that moves. Points become bodies, bodies are associated with tracks, and each track is a Kalman filter of constant
/// velocity. The same scans give the same tracks. docs/understand/tracker.md explains it.
class Tracker {
 public:
  /// Throws std::invalid_argument with fault_of(settings).
  explicit Tracker(const TrackerSettings& settings = TrackerSettings());
  ~Tracker();
  Tracker(Tracker&&) noexcept;
  Tracker& operator=(Tracker&&) noexcept;

  /// Takes the next scan. The fixed frame must not jump: odometry's.
  ScanUse update(const RangeScan& scan);

  /// What moves, at `stamp()`, in the fixed frame; `age` is 0. In order of id.
  const MovingObstacleEstimates& obstacles() const;

  /// What the laser looks at, in its own frame; known from the first scan on.
  SensorSectors field_of_view() const;

  /// The time of obstacles(): the end of the last scan that was used [s].
  double stamp() const;

  /// Forgets everything but the count of ids.
  void reset();

  /// Tracks that are followed, but not yet known to move.
  std::size_t candidates() const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace hidwa_local_planner
