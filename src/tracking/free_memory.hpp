// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "tracking/beams.hpp"
#include "tracking/travel.hpp"

namespace hidwa_local_planner {
namespace tracking {

/// Which places were seen free, when, and where something stands: a grid in the fixed frame that rolls with the sensor.
///
/// Free space is the inside of the polygon of all beams' ends, less a margin of one to two cells along it. So a beam
/// that grazes a wall says nothing of the cells at the wall, and neither does one that passes an edge.
class FreeMemory {
 public:
  explicit FreeMemory(const TrackerSettings& settings);

  void clear();

  /// Forgets what is out of reach of the sensor.
  void centre_on(const Point& sensor);

  /// Sets the kind of each beam's end by what is known before this scan. A place was free if all of its surroundings
  /// were, as far as odometry may have shifted things since.
  void judge(Beams& beams, const Travel& now) const;

  /// Takes a scan that comes `elapsed` [s] after the one before. Ends of beams that belong to a track (`Beam::track`)
  /// are not remembered as standing.
  void take(const Beams& beams, const Travel& now, double elapsed);

 private:
  struct Cell {
    double free_at = -1e18;    // when it was last seen free [s]
    float free_driven = 0.0F;  // after which travel that was [m]
    float free_turned = 0.0F;  // [rad]
    float standing = 0.0F;     // for how long something stands there; 1: as long as settles
    std::uint32_t looked = 0;  // scan in which it was seen free or hit
    std::uint32_t edge = 0;    // scan in which it lay at the edge of what was seen
    std::uint16_t sights = 0;  // scans that saw it free
  };

  template <typename Visit>
  void walk(const Point& from, const Point& to, Visit visit) const;
  bool inside(std::int64_t ix, std::int64_t iy) const;
  Cell& at(std::int64_t ix, std::int64_t iy);
  const Cell& at(std::int64_t ix, std::int64_t iy) const;
  void mark_edge(std::int64_t ix, std::int64_t iy);
  void mark_edges(const Beams& beams);
  void mark_hits(const Beams& beams, float gain);
  void mark_free(const Beams& beams, const Travel& now, float loss);
  PlaceKind kind(const Point& place, double distance, double time, const Travel& now) const;
  bool was_free(const Cell& cell, double time) const;

  TrackerSettings settings_;
  std::int64_t size_ = 0;      // cells in a row
  std::int64_t corner_x_ = 0;  // lowest cell of the window
  std::int64_t corner_y_ = 0;
  bool placed_ = false;
  std::uint32_t scan_ = 0;
  std::vector<Cell> cells_;
};

}  // namespace tracking
}  // namespace hidwa_local_planner
