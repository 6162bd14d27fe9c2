// SPDX-License-Identifier: BSD-3-Clause
#include "tracking/body_fit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <Eigen/LU>

namespace hidwa_local_planner {
namespace tracking {
namespace {

constexpr double kSmallestBody = 0.03;  // radius [m]
constexpr double kEdge = 0.3;           // deviation of an edge [beams]; 1 / sqrt(12) of what lies between two
constexpr double kUnevenSights = 5.0;   // so many points' worth of the known one
constexpr double kHiddenShare = 0.1;    // of the noise: what is less uneven cannot be told from even
constexpr double kWrongRadius = 0.15;   // deviation of a radius that does not fit what is seen [m]
constexpr double kThin = 0.13;          // too few beams meet what is thinner to tell its curve [m]
constexpr double kGrazing = 0.9;        // what hits a body farther from its middle says little [radii]
constexpr double kContradicts = 3.0;    // deviations, by which a width is not what it was

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

// The middle of the beams' times.
double time_of(const Beams& beams, const Segment& segment) {
  double sum = 0.0;
  for_points(beams, segment, [&](std::size_t i) { sum += beams.time_of(i); });
  return sum / static_cast<double>(segment.points);
}

// A circle about a centre in polar coordinates, fitted to the arc in view: maximum a posteriori by Gauss-Newton.
class ArcFit {
 public:
  using Unknowns = Eigen::Vector3d;  // bearing of the centre from the first beam [rad], its distance, the radius [m]

  ArcFit(const Beams& beams, const Segment& segment, const Polar& polar, const KnownShape& known, double range_noise)
      : beams_(beams), segment_(segment), polar_(polar), known_(known) {
    // What a real surface is off is much the same in neighbouring beams: it counts as so many errors only.
    const double alike = std::max(1.0, static_cast<double>(segment.points) / kBumps);
    range_variance_ = range_noise * range_noise + known.unevenness * known.unevenness * alike;
  }

  // From a circle that touches the nearest point.
  bool run(double nearest) {
    first_ = x_ = Unknowns(0.5 * (polar_.low + polar_.high), nearest + known_.radius, known_.radius);
    for (int i = 0; i < kSteps; ++i) {
      collect();
      Unknowns step = information_.ldlt().solve(right_);
      if (!step.allFinite()) return false;
      step = step.cwiseMax(-kLongest).cwiseMin(kLongest);
      x_ += step;
      x_.z() = std::min(std::max(x_.z(), kSmallestBody), kLargest);
      x_.y() = std::max(x_.y(), x_.z() + kSmallestBody);
    }
    collect();
    covariance_ = information_.inverse();
    return covariance_.allFinite();
  }

  double middle() const { return x_(0); }
  double distance() const { return x_(1); }
  double radius() const { return x_(2); }
  double radius_deviation() const { return std::sqrt(covariance_(2, 2)); }

  // Of the centre, along the line of sight and across.
  Eigen::Matrix2d covariance() const {
    Eigen::Matrix2d c;
    c << covariance_(1, 1), x_(1) * covariance_(0, 1), x_(1) * covariance_(0, 1), x_(1) * x_(1) * covariance_(0, 0);
    return c;
  }

 private:
  static constexpr int kSteps = 6;
  static constexpr double kBumps = 5.0;    // independent errors of a surface
  static constexpr double kLongest = 0.2;  // step [rad], [m]
  static constexpr double kLargest = 1.5;  // radius [m]

  void take(double residual, const Unknowns& slope, double variance) {
    information_ += slope * slope.transpose() / variance;
    right_ += slope * (residual / variance);
  }

  void collect() {
    information_.setZero();
    right_.setZero();
    const double r = x_(2), d = x_(1);
    take(known_.radius - r, {0.0, 0.0, 1.0}, known_.deviation * known_.deviation);
    const double half = std::asin(std::min(r / d, 0.98));
    take(first_(0) - x_(0), {1.0, 0.0, 0.0}, half * half);  // some of it was hit
    take_points();
    take_edge(polar_.low, half, -1.0, polar_.hidden_low);
    take_edge(polar_.high, half, 1.0, polar_.hidden_high);
  }

  void take_points() {
    const double r = x_(2), d = x_(1);
    for_points(beams_, segment_, [&](std::size_t i) {
      const Beam& beam = beams_.all[i];
      const double a = wrap_angle(beam.bearing - polar_.reference) - x_(0);
      const double s = std::sin(a), c = std::cos(a), off = d * s;
      if (std::abs(off) > kGrazing * r || c <= 0.0) return;
      const double q = std::sqrt(r * r - off * off);
      take(beam.length - (d * c - q), {off * (1.0 - d * c / q), c + d * s * s / q, -r / q}, range_variance_);
    });
  }

  // The circle ends at an edge, or beyond one that is hidden.
  void take_edge(double edge, double half, double side, bool hidden) {
    const double residual = edge - (x_(0) + side * half);
    if (hidden && side * residual <= 0.0) return;
    const double d = x_(1), c = d * std::cos(half);
    const double deviation = kEdge * beams_.increment + known_.unevenness / d;
    take(residual, {1.0, -side * std::tan(half) / d, side / c}, deviation * deviation);
  }

  const Beams& beams_;
  const Segment& segment_;
  const Polar& polar_;
  const KnownShape& known_;
  double range_variance_ = 0.0;  // [m^2]
  Unknowns first_, x_, right_;
  Eigen::Matrix3d information_, covariance_;
};

Eigen::Matrix2d turned(const Eigen::Matrix2d& covariance, double angle) {
  const Eigen::Matrix2d turn = Eigen::Rotation2Dd(angle).toRotationMatrix();
  return turn * covariance * turn.transpose();
}

Point along(double bearing, double length) { return length * Point(std::cos(bearing), std::sin(bearing)); }

double nearest_range(const Beams& beams, const Segment& segment) {
  double nearest = std::numeric_limits<double>::infinity();
  for_points(beams, segment, [&](std::size_t i) { nearest = std::min(nearest, beams.all[i].length); });
  return nearest;
}

// How far the points are from the circle: the variance of their ranges beyond that of the noise, with a few points'
// worth of what is known.
double unevenness(const Beams& beams, const Segment& segment, const BodyFit& fit, double known, double range_noise) {
  double sum = kUnevenSights * known * known;
  double count = kUnevenSights;
  for_points(beams, segment, [&](std::size_t i) {
    const Beam& beam = beams.all[i];
    const Point to = fit.centre - beam.origin;
    const double off = beam.direction.x() * to.y() - beam.direction.y() * to.x();
    if (std::abs(off) > kGrazing * fit.radius) return;
    const double short_of = beam.length - (beam.direction.dot(to) - std::sqrt(fit.radius * fit.radius - off * off));
    sum += short_of * short_of - range_noise * range_noise;
    count += 1.0;
  });
  return std::max(std::sqrt(std::max(sum, 0.0) / count), kHiddenShare * range_noise);
}

BodyFit fit_edges(const Beams& beams, const Segment& segment, const Polar& p) {
  BodyFit fit;
  fit.radius_seen = !p.hidden_low && !p.hidden_high;
  const double half = std::min(0.5 * (p.high - p.low), 1.4);
  const double middle = 0.5 * (p.low + p.high);
  fit.distance = centre_distance(beams, segment, p, middle, half);
  fit.radius = std::max(fit.distance * std::sin(half), kSmallestBody);
  fit.centre = p.origin + along(p.reference + middle, fit.distance);
  fit.time = time_of(beams, segment);
  return fit;
}

void judge_edges(const Beams& beams, const Segment& segment, double range_noise, BodyFit& fit) {
  const double across = kEdge * beams.increment * fit.distance;
  const double ahead = range_noise / std::sqrt(static_cast<double>(segment.points));
  const double hidden = fit.radius_seen ? 0.0 : 0.3 * fit.radius;
  fit.unevenness = unevenness(beams, segment, fit, KnownShape::kUnevenness, range_noise);
  fit.blur(std::sqrt(across * across + ahead * ahead + hidden * hidden + fit.unevenness * fit.unevenness));
  fit.radius_deviation = std::sqrt(across * across + hidden * hidden + fit.unevenness * fit.unevenness);
}

}  // namespace

BodyFit fit_body(const Beams& beams, const Segment& segment, double range_noise) {
  BodyFit fit = fit_edges(beams, segment, polar_of(beams, segment));
  judge_edges(beams, segment, range_noise, fit);
  return fit;
}

BodyFit fit_body(const Beams& beams, const Segment& segment, const KnownShape& shape, double range_noise) {
  BodyFit fit = fit_body(beams, segment, range_noise);
  Polar p = polar_of(beams, segment);
  KnownShape known = shape;
  const double wider = fit.radius - known.radius,
               doubt = kContradicts * std::hypot(known.deviation, fit.radius_deviation);
  fit.wider = wider;
  fit.wider_noise = std::sqrt(0.5) * kEdge * beams.increment * fit.distance;  // the edges err apart
  if (fit.radius_seen && wider < -doubt) {
    // Something hides it that is not seen to be nearer, or the radius is wrong: the arc says which.
    p.hidden_low = p.hidden_high = true;
    fit.radius_seen = false;
    known.deviation = std::max(known.deviation, kWrongRadius);
  }
  if (fit.radius_seen && fit.radius < kThin) return fit;
  ArcFit arc(beams, segment, p, known, range_noise);
  if (!arc.run(nearest_range(beams, segment))) return fit;
  const double bearing = p.reference + arc.middle();
  fit.centre = p.origin + along(bearing, arc.distance());
  fit.distance = arc.distance();
  fit.radius = arc.radius();
  fit.radius_deviation = arc.radius_deviation();
  fit.covariance = turned(arc.covariance(), bearing);
  fit.unevenness = unevenness(beams, segment, fit, known.unevenness, range_noise);
  fit.blur(std::max(fit.unevenness, wider > doubt ? wider : 0.0));  // somebody else may be a part of it
  return fit;
}

}  // namespace tracking
}  // namespace hidwa_local_planner
