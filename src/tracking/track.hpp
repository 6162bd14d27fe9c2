// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "hidwa_local_planner/core/moving_obstacle.hpp"
#include "tracking/beams.hpp"
#include "tracking/body_fit.hpp"
#include "tracking/motion_filter.hpp"
#include "tracking/segments.hpp"
#include "tracking/travel.hpp"

namespace hidwa_local_planner {
namespace tracking {

/// What was seen of a track in a scan: of one body, or of two legs.
struct Sighting {
  BodyFit body;
  bool legs = false;         // the body is the middle of two legs
  bool mixed = false;        // the legs may be those of two people
  bool small = false;        // as small as a leg
  bool free_before = false;  // a third of it lies where space was seen free
  bool whole = false;        // nothing hides a part of it
};

/// Something that is followed from scan to scan, whether or not it is known to move yet.
struct Track {
  std::uint32_t id = 0;    // from when it is confirmed
  bool confirmed = false;  // it moves
  ManoeuvreFilter filter;
  double radius = 0.0;            // of the body; 0: not known [m]
  double radius_deviation = 0.0;  // [m]
  double radius_variance = 0.0;   // of its changes from scan to scan, of late [m^2]
  double unevenness = 0.0;        // of its surface, of late [m]
  bool two_legs = false;          // they were seen apart once
  int sightings = 0;
  int free_sightings = 0;     // the last ones, where space was seen free
  int vacated_sightings = 0;  // the last ones, when its first place was seen through
  int whole_sightings = 0;    // with nothing that hides a part of it
  double begin = 0.0;         // [s]
  double seen = 0.0;          // last [s]
  double through = 0.0;       // for how long beams passed through where it should be [s]
  Point began_at{0.0, 0.0};   // [m]
  Travel began_after;
  Point stood_at{0.0, 0.0};             // it has not left the surroundings of this place [m]
  double stood_since = 0.0;             // [s]
  double surprise = 2.0;                // mean mismatch of late; 2: as expected
  std::array<Point, 8> first_points{};  // where it was seen first [m]
  int first_count = 0;
  std::array<std::size_t, 4> segments{};  // in this scan
  int segment_count = 0;

  double distance_from_start() const { return (filter.position() - began_at).norm(); }
};

/// What a track knows of its body, or what is usual.
KnownShape known_shape(const Track& track);

/// What a track's segments in this scan amount to. There must be one at least.
Sighting look(const Beams& beams, const std::vector<Segment>& segments, const Track& track,
              const TrackerSettings& settings);

/// A track that begins with a sighting.
Track begin_track(const Sighting& sighting, const Travel& travel, const TrackerSettings& settings);

void correct_track(Track& track, const Sighting& sighting, const TrackerSettings& settings);

/// Counts the scans in a row in which the place where it was seen first is seen through. For each sighting of a track
/// that is not confirmed.
void look_back(Track& track, const Beams& beams);

/// True once a track is known to move: it left its place faster and farther than noise and odometry explain, and it
/// either stands where space was seen free, or its first place is seen through now; in three scans in a row where it is
/// not seen whole. What shows few points must be near. It has segments in this scan.
bool known_to_move(const Track& track, const Beams& beams, const std::vector<Segment>& segments, const Travel& travel,
                   const TrackerSettings& settings);

/// Whether it goes faster now than noise explains. Who has just begun to walk is still near where he stood.
bool walks(const Track& track, const TrackerSettings& settings);

/// The track as others see it at a time [s], without its points.
MovingObstacleEstimate to_obstacle(const Track& track, double time, const TrackerSettings& settings);

}  // namespace tracking
}  // namespace hidwa_local_planner
