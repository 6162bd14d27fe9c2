// SPDX-License-Identifier: BSD-3-Clause
#include "tracking/track.hpp"

#include <algorithm>
#include <cmath>

namespace hidwa_local_planner {
namespace tracking {
namespace {

constexpr double kFirstSpeed = 1.2;      // standard deviation of a velocity that nobody knows yet [m/s]
constexpr double kLegRadius = 0.13;      // bodies below may be legs [m]
constexpr double kStride = 0.05;         // deviation of the middle of two legs from that of the person [m]
constexpr double kOneLeg = 0.12;         // deviation of one leg from the person's middle [m]
constexpr double kThinBody = 0.04;       // deviation of a body that may be a leg [m]
constexpr double kBias = 0.005;          // what is the same from scan to scan: bodies are not round [m]
constexpr double kUnevenShare = 0.1;     // of the newest unevenness in the mean
constexpr double kSurprised = 3.5;       // mean mismatch of what jumps about
constexpr double kSurpriseShare = 0.3;   // of the newest mismatch in the mean
constexpr double kStandingRange = 0.25;  // what stays within stands [m]
constexpr double kSignificant = 2.0;     // deviations
constexpr double kSettledSpeed = 0.3;    // deviation of a velocity that is known well [m/s]
constexpr double kLeft = 0.12;           // how far from its start a mover must have come [m]
constexpr double kVacated = 0.3;         // the same where nothing was known of the space [m]
constexpr double kVacatedBySmall = 0.6;  // and where it may be a table's legs [m]
constexpr int kFreeSightings = 2;        // in a row, that tell a mover
constexpr int kVacatedSightings = 3;     // likewise, of a body that something hides in part
constexpr double kNear = 6.5;            // farther away a wall's few points seem to move [m]
constexpr std::size_t kFarPoints = 6;    // so many make a body there
constexpr std::size_t kPoints = 3;       // and so many where nothing was known of the space
constexpr double kVacatedWithin = 5.5;   // distance within which that is tried [m]
constexpr double kFastest = 5.0;         // whatever seems faster is none [m/s]
constexpr double kUsualRadius = 0.25;    // of a body that nobody knows yet [m]
constexpr double kUsualRange = 0.15;     // and its deviation [m]
constexpr double kUsualChange = 0.03;    // of a radius from scan to scan: arms, legs, coats [m]
constexpr double kLeastChange = 0.002;   // of anything [m]
constexpr double kChangeShare = 0.2;     // of the newest change in the mean square
constexpr double kArcFloor = 0.1;        // the same by arcs alone [m]
constexpr double kMixedLegs = 0.1;       // deviation of the middle of two people's legs from either of them [m]
constexpr double kAlikeFor = 1.0;        // errors of what is hidden in part, and of mixed legs, last for this [s]
constexpr double kLegsTogether = 0.3;    // what is larger and in one piece is no pair of legs [m]

bool is_small(const BodyFit& fit) { return fit.radius < kLegRadius; }

bool lies_in_free(const Segment& segment) { return 3 * segment.free_before >= segment.points; }

// The largest of a body's pieces stands for it: the others say on which side it goes on.
Segment largest_piece(const std::vector<Segment>& segments, const Track& track) {
  Segment best = segments[track.segments[0]];
  for (int i = 1; i < track.segment_count; ++i) {
    const Segment& s = segments[track.segments[static_cast<std::size_t>(i)]];
    if (s.points > best.points) best = s;
  }
  for (int i = 0; i < track.segment_count; ++i) {
    const Segment& s = segments[track.segments[static_cast<std::size_t>(i)]];
    if (s.first < best.first) best.hidden_first = true;
    if (s.first > best.first) best.hidden_last = true;
  }
  return best;
}

Sighting one_body(const Beams& beams, const Segment& segment, const Track& track, const TrackerSettings& settings) {
  Sighting s;
  s.body = fit_body(beams, segment, known_shape(track), settings.range_noise);
  s.small = is_small(s.body);
  s.free_before = lies_in_free(segment);
  s.whole = s.body.radius_seen;
  const double more = !s.small ? 0.0 : track.two_legs ? kOneLeg : kThinBody;
  s.body.blur(track.two_legs ? std::max(more, kStride) : more);
  return s;
}

bool all_small(const Beams& beams, const std::vector<Segment>& segments, const Track& track, double noise) {
  for (int i = 0; i < track.segment_count; ++i) {
    const Segment& s = segments[track.segments[static_cast<std::size_t>(i)]];
    if (!is_small(fit_body(beams, s, noise))) return false;
  }
  return true;
}

Sighting two_legs(const Beams& beams, const std::vector<Segment>& segments, const Track& track, double noise) {
  Sighting s;
  s.legs = s.small = true;
  int free = 0;
  const double n = track.segment_count;
  for (int i = 0; i < track.segment_count; ++i) {
    const Segment& segment = segments[track.segments[static_cast<std::size_t>(i)]];
    const BodyFit leg = fit_body(beams, segment, noise);
    s.body.centre += leg.centre / n;
    s.body.time += leg.time / n;
    s.body.radius += leg.radius / n;
    s.body.distance += leg.distance / n;
    s.body.covariance += leg.covariance / (n * n);
    if (lies_in_free(segment)) ++free;
  }
  s.body.blur(kStride);
  s.free_before = 2 * free >= track.segment_count;
  s.whole = true;
  return s;
}

// The fit has taken what was known of the radius into account. A radius is known no better than it changes from scan to
// scan. Arcs err alike from scan to scan: they say less.
void learn_radius(const Sighting& sighting, const TrackerSettings& settings, Track& track) {
  if (sighting.legs) return;
  const BodyFit& b = sighting.body;
  const double known = track.sightings > 0 ? track.radius_deviation : kUsualRange;
  if (track.confirmed && b.radius_seen) {
    const double change = std::min(b.wider * b.wider, kUsualChange * kUsualChange) - b.wider_noise * b.wider_noise;
    track.radius_variance += kChangeShare * (change - track.radius_variance);
  }
  const double floor = b.radius_seen ? std::max(std::sqrt(std::max(track.radius_variance, 0.0)), kLeastChange)
                                     : std::min(known, kArcFloor);
  track.radius = std::min(b.radius, settings.max_radius);
  track.radius_deviation = std::max(b.radius_deviation, floor);
}

// Of the place, `elapsed` [s] after the sighting before. What hides a part of somebody, and whose legs are taken for a
// pair, is the same from scan to scan: all readings of that time together tell no more than one.
Eigen::Matrix2d covariance_of(const Sighting& sighting, double elapsed) {
  Eigen::Matrix2d covariance = sighting.body.covariance;
  if (sighting.mixed) covariance.diagonal().array() += kMixedLegs * kMixedLegs;
  const bool alike = sighting.mixed || (!sighting.legs && !sighting.body.radius_seen);
  return alike ? covariance * std::max(1.0, kAlikeFor / std::max(elapsed, 1e-3)) : covariance;
}

// Who walks changes speed at each step. Of a body the readings tell it, those of legs are too vague.
double usual_acceleration(bool legs, const TrackerSettings& settings) {
  return legs ? settings.leg_acceleration : settings.acceleration;
}

bool left_behind(const Track& track, const Beams& beams) {
  int through = 0;
  for (int i = 0; i < track.first_count; ++i) {
    if (seen_through(beams, track.first_points[static_cast<std::size_t>(i)], 0.15)) ++through;
  }
  return track.first_count > 0 && 10 * through >= 6 * track.first_count;
}

}  // namespace

KnownShape known_shape(const Track& track) {
  if (track.radius > 0.0 && !track.two_legs) {
    return {track.radius, track.radius_deviation, track.confirmed ? track.unevenness : KnownShape::kUnevenness};
  }
  return {kUsualRadius, kUsualRange};
}

Sighting look(const Beams& beams, const std::vector<Segment>& segments, const Track& track,
              const TrackerSettings& settings) {
  if (track.segment_count > 1 && all_small(beams, segments, track, settings.range_noise)) {
    return two_legs(beams, segments, track, settings.range_noise);
  }
  return one_body(beams, largest_piece(segments, track), track, settings);
}

Track begin_track(const Sighting& sighting, const Travel& travel, const TrackerSettings& settings) {
  Track t;
  const BodyFit& b = sighting.body;
  t.filter = ManoeuvreFilter(b.centre, b.covariance, kFirstSpeed, b.time, usual_acceleration(sighting.legs, settings));
  t.unevenness = b.unevenness;
  t.radius_variance = kUsualChange * kUsualChange;
  t.begin = t.seen = t.stood_since = b.time;
  t.began_at = t.stood_at = b.centre;
  t.began_after = travel;
  learn_radius(sighting, settings, t);
  t.sightings = 1;
  t.free_sightings = sighting.free_before ? 1 : 0;
  t.whole_sightings = sighting.whole ? 1 : 0;
  t.two_legs = sighting.legs;
  return t;
}

void correct_track(Track& track, const Sighting& sighting, const TrackerSettings& settings) {
  const BodyFit& b = sighting.body;
  if (sighting.legs) track.two_legs = true;
  if (!sighting.legs && b.radius_seen && b.radius > kLegsTogether) track.two_legs = false;
  track.filter.expect(usual_acceleration(track.two_legs, settings));
  track.filter.predict(b.time);
  const double mismatch = track.filter.correct(b.centre, covariance_of(sighting, b.time - track.seen));
  track.surprise += kSurpriseShare * (std::min(mismatch, 20.0) - track.surprise);
  learn_radius(sighting, settings, track);
  track.unevenness += kUnevenShare * (b.unevenness - track.unevenness);
  ++track.sightings;
  track.free_sightings = sighting.free_before ? track.free_sightings + 1 : 0;
  if (sighting.whole) ++track.whole_sightings;
  track.seen = b.time;
  track.through = 0.0;
  if ((track.filter.position() - track.stood_at).norm() > kStandingRange) {
    track.stood_at = track.filter.position();
    track.stood_since = b.time;
  }
}

void look_back(Track& track, const Beams& beams) {
  track.vacated_sightings = left_behind(track, beams) ? track.vacated_sightings + 1 : 0;
}

bool known_to_move(const Track& track, const Beams& beams, const std::vector<Segment>& segments, const Travel& travel,
                   const TrackerSettings& settings) {
  const double age = track.seen - track.begin;
  if (track.sightings < 3 || age < 0.14 || (track.sightings < 4 && age < 0.3)) return false;
  const double distance = (track.filter.position() - beams.centre).norm();
  const double moved = shift(track.began_after, travel, distance, settings.odometry_slip);
  const double speed = track.filter.velocity().norm();
  if (speed < settings.min_speed + moved / age || speed > kFastest) return false;
  if (track.surprise > kSurprised) return false;  // it jumps, as what is none does
  const std::size_t points = largest_piece(segments, track).points;
  if (distance > kNear && points < kFarPoints) return false;
  const double way = track.distance_from_start() - moved;
  const bool certain = speed > kSignificant * track.filter.velocity_deviation() + moved / age ||
                       (way > kVacated && track.filter.velocity_deviation() < kSettledSpeed);
  if (!certain) return false;
  if (track.free_sightings >= std::min(track.sightings - 1, kFreeSightings)) return way > kLeft;
  if (distance > kVacatedWithin || points < kPoints) return false;
  const bool small = track.two_legs || track.radius < kLegRadius;  // beams pass beside what is thin, too
  const bool whole = 10 * track.whole_sightings >= 8 * track.sightings;
  if (!whole && small) return false;
  return track.vacated_sightings >= (whole ? 1 : kVacatedSightings) && way > (small ? kVacatedBySmall : kVacated);
}

bool walks(const Track& track, const TrackerSettings& settings) {
  return track.filter.velocity().norm() >
         std::max(settings.min_speed, kSignificant * track.filter.velocity_deviation());
}

MovingObstacleEstimate to_obstacle(const Track& track, double time, const TrackerSettings& settings) {
  ManoeuvreFilter now = track.filter;
  now.predict(time);
  MovingObstacleEstimate o;
  o.id = track.id;
  o.position = now.position();
  o.velocity = now.velocity();
  o.radius = std::max(settings.min_radius, track.two_legs ? 0.0 : track.radius);
  o.position_deviation = std::hypot(now.position_deviation(), std::max(track.unevenness, kBias));
  o.velocity_deviation = now.velocity_deviation();
  return o;
}

}  // namespace tracking
}  // namespace hidwa_local_planner
