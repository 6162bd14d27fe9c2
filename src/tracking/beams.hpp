// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "tracking/range_scan.hpp"
#include "tracking/tracker_settings.hpp"

namespace hidwa_local_planner {
namespace tracking {

/// What is known of a place: whether something stands there, or space was seen free.
enum class PlaceKind : std::uint8_t { unknown, standing, was_free };

/// One beam in the fixed frame.
struct Beam {
  Point origin{0.0, 0.0};               // [m]
  Point direction{1.0, 0.0};            // unit vector
  double bearing = 0.0;                 // of the direction, fixed frame [rad]
  double length = 0.0;                  // seen free; 0: it says nothing [m]
  bool hit = false;                     // it ends at something
  PlaceKind kind = PlaceKind::unknown;  // of where it ends, before this scan
  std::int32_t track = -1;              // index of the track that it was taken for

  Point tip() const { return origin + length * direction; }
};

/// A scan as beams in the fixed frame.
struct Beams {
  std::vector<Beam> all;
  double stamp = 0.0;           // of the first [s]
  double time_increment = 0.0;  // [s]
  double increment = 0.0;       // between neighbours, not signed [rad]
  double end = 0.0;             // when the last one was measured [s]
  bool whole_turn = false;      // the first one is the last one's neighbour
  Point centre{0.0, 0.0};       // of the sensor, in the middle of the scan [m]

  double time_of(std::size_t i) const { return stamp + time_increment * static_cast<double>(i); }
};

/// Up to this many beams without a reading may lie between two points of one surface.
inline constexpr std::size_t kSilentBeams = 2;

/// Where the laser loses returns (two of a hundred beams have none although those beside them lie on one surface), such
/// beams say nothing: they saw no free space.
void to_beams(const RangeScan& scan, const TrackerSettings& settings, Beams& out);

/// Whether two hits, `steps` beams apart, may lie on one surface. `noise`: standard deviation of a range [m].
bool same_surface(const Beams& beams, std::size_t a, std::size_t b, std::size_t steps, double noise);

/// True where the beams nearest to the place, one on each side, end more than `beyond` [m] behind it.
bool seen_through(const Beams& beams, const Point& place, double beyond);

}  // namespace tracking
}  // namespace hidwa_local_planner
