// SPDX-License-Identifier: BSD-3-Clause
#include "tracking/body_fit.hpp"

#include <algorithm>
#include <cmath>

namespace hidwa_local_planner {
namespace tracking {
namespace {

constexpr double kSmallestBody = 0.03;  // radius [m]
constexpr double kNotRound = 0.015;     // how far a real surface is from a circle [m]

// A segment in polar coordinates about the sensor, bearings relative to that of its first beam and growing.
struct Polar {
  Point origin{0.0, 0.0};
  double reference = 0.0;  // bearing of the first beam [rad]
  double low = 0.0;        // least bearing, half a beam's width beyond the outermost beam [rad]
  double high = 0.0;
  bool hidden_low = false;
  bool hidden_high = false;
};

Polar polar_of(const Beams& beams, const Segment& segment) {
  Polar p;
  const Beam& first = beams.all[segment.first];
  p.origin = first.origin;
  p.reference = first.bearing;
  double other = 0.0;
  for_points(beams, segment, [&](std::size_t i) { other = wrap_angle(beams.all[i].bearing - p.reference); });
  const double half = 0.5 * beams.increment;
  const bool growing = other >= 0.0;
  p.low = std::min(0.0, other) - half;
  p.high = std::max(0.0, other) + half;
  p.hidden_low = growing ? segment.hidden_first : segment.hidden_last;
  p.hidden_high = growing ? segment.hidden_last : segment.hidden_first;
  return p;
}

// Distance of the centre of a circle that fills 2 `half` [rad] of view: a beam at angle a off its centre has the range
// D (cos a - sqrt(sin^2 half - sin^2 a)). Least squares over the beams.
double centre_distance(const Beams& beams, const Segment& segment, const Polar& polar, double middle, double half) {
  const double s = std::sin(half);
  double above = 0.0;
  double below = 0.0;
  for_points(beams, segment, [&](std::size_t i) {
    const Beam& beam = beams.all[i];
    const double a = wrap_angle(beam.bearing - polar.reference) - middle;
    const double off = std::min(std::abs(std::sin(a)), 0.95 * s);
    const double factor = std::cos(a) - std::sqrt(s * s - off * off);
    const double weight = 1.0 - 0.9 * off / s;  // a small error of the width moves the outermost beams most
    above += weight * beam.length * factor;
    below += weight * factor * factor;
  });
  return above / below;
}

// Bearing of the centre: from the edges that are in view.
double middle_of(const Polar& p, double half) {
  if (p.hidden_low && !p.hidden_high) return std::max(p.high - half, p.low);
  if (p.hidden_high && !p.hidden_low) return std::min(p.low + half, p.high);
  return 0.5 * (p.low + p.high);
}

}  // namespace

BodyFit fit_body(const Beams& beams, const Segment& segment, double known_radius, bool insist, double range_noise) {
  const Polar p = polar_of(beams, segment);
  BodyFit fit;
  fit.radius_seen = !p.hidden_low && !p.hidden_high;
  const double seen_half = 0.5 * (p.high - p.low);
  double half = std::min(seen_half, 1.4);
  double middle = 0.5 * (p.low + p.high);
  double d = centre_distance(beams, segment, p, middle, half);
  fit.radius = std::max(d * std::sin(half), kSmallestBody);
  if (insist || (!fit.radius_seen && fit.radius < known_radius)) {
    const double measured = fit.radius;
    fit.radius = known_radius;
    for (int i = 0; i < 3; ++i) {
      half = std::asin(std::min(fit.radius / std::max(d, fit.radius), 0.98));
      middle = middle_of(p, half);
      d = centre_distance(beams, segment, p, middle, half);
    }
    if (fit.radius_seen) fit.radius = measured;
  }
  const double bearing = p.reference + middle;
  fit.centre = p.origin + d * Point(std::cos(bearing), std::sin(bearing));
  fit.distance = d;
  const double across = 0.3 * beams.increment * d;
  const double along = range_noise / std::sqrt(static_cast<double>(segment.points));
  const double hidden = fit.radius_seen ? 0.0 : 0.3 * fit.radius;
  fit.deviation = std::sqrt(across * across + along * along + hidden * hidden + kNotRound * kNotRound);
  double sum = 0.0;
  for_points(beams, segment, [&](std::size_t i) { sum += beams.time_of(i); });
  fit.time = sum / static_cast<double>(segment.points);
  return fit;
}

}  // namespace tracking
}  // namespace hidwa_local_planner
