// SPDX-License-Identifier: BSD-3-Clause
#include "tracking/track.hpp"

#include <gtest/gtest.h>

#include "support/random.hpp"
#include "support/scan_world.hpp"

namespace hidwa_local_planner::tracking {
namespace {

using test::normal;
using test::Random;

// A body of 0.4 m at rest, whole in view, placed to 5 mm.
Sighting sighting_at(double time) {
  Sighting s;
  s.whole = true;
  s.body.centre = Point(3.0, 0.0);
  s.body.covariance = 25e-6 * Eigen::Matrix2d::Identity();
  s.body.radius = 0.4;
  s.body.radius_seen = true;
  s.body.radius_deviation = 0.001;
  s.body.unevenness = 0.015;
  s.body.wider_noise = 0.004;
  s.body.time = time;
  return s;
}

// What is known of its radius after 60 sightings, in each of which its edges show it wider by `change` (deviation) and
// by the noise of the beams.
double radius_deviation(bool confirmed, double change) {
  Random random(4);
  const TrackerSettings settings;
  Track track = begin_track(sighting_at(0.0), Travel(), settings);
  track.confirmed = confirmed;
  for (int i = 1; i <= 60; ++i) {
    Sighting s = sighting_at(0.05 * i);
    s.body.wider = std::hypot(change, s.body.wider_noise) * normal(random);
    correct_track(track, s, settings);
  }
  return track.radius_deviation;
}

TEST(Track, KnowsTheRadiusOfWhatKeepsIt) {
  EXPECT_LT(radius_deviation(true, 0.0), 0.005);
  // Squares are clipped at 0.03 m: arms and coats change a radius by as much.
  EXPECT_GT(radius_deviation(true, 0.03), 0.015);
  EXPECT_LE(radius_deviation(true, 0.3), 0.03);
}

// The first sighting as one body moves the mean square from 0.03^2 by a fifth only: sqrt(0.8 x 0.0009 m^2) = 0.027 m.
TEST(Track, LegsThatAreOneBodyNowTellLittleOfItsRadius) {
  Sighting legs = sighting_at(0.0);
  legs.legs = true;
  Track track = begin_track(legs, Travel(), TrackerSettings());
  track.confirmed = true;
  correct_track(track, sighting_at(0.05), TrackerSettings());
  EXPECT_GT(track.radius_deviation, 0.025);
}

// What is told of the velocity of who stands, after 3 s. Once legs are one wide body, it is a body's acceleration.
double velocity_deviation(bool legs, double then_radius) {
  const TrackerSettings settings;
  Sighting s = sighting_at(0.0);
  s.legs = legs;
  Track track = begin_track(s, Travel(), settings);
  for (int i = 1; i <= 60; ++i) {
    s = sighting_at(0.05 * i);
    s.legs = legs && i < 20;
    s.body.radius = then_radius;
    correct_track(track, s, settings);
  }
  return track.filter.velocity_deviation();
}

TEST(Track, LegsMayChangeTheirSpeedFaster) {
  const double body = velocity_deviation(false, 0.4);
  EXPECT_GT(velocity_deviation(true, 0.2), 1.3 * body);
  EXPECT_LT(velocity_deviation(true, 0.4), 1.05 * body);
}

// Who is not confirmed yet is judged as ever: what errs by little seems to move.
TEST(Track, ACandidatesShapeIsTheUsualOne) {
  EXPECT_DOUBLE_EQ(radius_deviation(false, 0.0), 0.03);
  Track track = begin_track(sighting_at(0.0), Travel(), TrackerSettings());
  track.unevenness = 0.001;
  EXPECT_DOUBLE_EQ(known_shape(track).unevenness, KnownShape::kUnevenness);
  track.confirmed = true;
  EXPECT_DOUBLE_EQ(known_shape(track).unevenness, 0.001);
}

}  // namespace
}  // namespace hidwa_local_planner::tracking
