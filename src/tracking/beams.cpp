// SPDX-License-Identifier: BSD-3-Clause
#include "tracking/beams.hpp"

#include <algorithm>
#include <cmath>

namespace hidwa_local_planner {
namespace tracking {
namespace {

constexpr double kStep = 0.12;            // between neighbouring points of a surface, at no distance [m]
constexpr double kStepsPerSpacing = 2.5;  // more at a distance: so many times the distance between beams
constexpr double kWidestStep = 0.35;      // [m]
constexpr double kLostShare = 0.02;       // of the beams; a laser that loses so many returns is known for that

Pose2 pose_between(const Pose2& a, const Pose2& b, double share) {
  return {a.x + share * (b.x - a.x), a.y + share * (b.y - a.y), a.theta + share * wrap_angle(b.theta - a.theta)};
}

// Length and hit of a beam; what lies beyond `reach` is free space up to there.
void set_length(float range, const RangeScan& scan, const TrackerSettings& settings, Beam& beam) {
  const double r = range;
  beam.hit = false;
  beam.length = 0.0;
  if (std::isnan(r) || r < scan.range_min || r <= 0.0) return;
  const bool returned = std::isfinite(r) && r < scan.range_max;
  if (!returned && !settings.no_return_is_free) return;
  beam.hit = returned && r < settings.reach;
  beam.length = std::min({r, settings.reach, scan.range_max});
}

// Calls `visit` with each beam without a return that lies between two hits of one surface, few beams apart.
template <typename Visit>
void for_lost_returns(const RangeScan& scan, double noise, const Beams& beams, Visit visit) {
  const std::size_t n = beams.all.size();
  const auto lost = [&](std::size_t i) { return static_cast<double>(scan.ranges[i]) >= scan.range_max; };
  std::size_t before = beams.whole_turn ? n - 1 : n;  // the last beam that was not lost; n: there is none
  std::size_t count = 0;                              // of those since then
  for (std::size_t i = 0; i < n; ++i) {
    if (lost(i)) {
      ++count;
      continue;
    }
    const bool between = before < n && beams.all[before].hit && beams.all[i].hit && count > 0 && count <= kSilentBeams;
    if (between && same_surface(beams, before, i, count + 1, noise)) {
      for (std::size_t k = 1; k <= count; ++k) visit((i + n - k) % n);
    }
    before = i;
    count = 0;
  }
}

// A laser that loses returns. Of another one few beams are so: between legs, through cracks.
void forget_lost_returns(const RangeScan& scan, double noise, Beams& beams) {
  std::size_t lost = 0;
  for_lost_returns(scan, noise, beams, [&lost](std::size_t) { ++lost; });
  if (static_cast<double>(lost) < kLostShare * static_cast<double>(beams.all.size())) return;
  for_lost_returns(scan, noise, beams, [&beams](std::size_t i) { beams.all[i].length = 0.0; });
}

}  // namespace

bool same_surface(const Beams& beams, std::size_t a, std::size_t b, std::size_t steps, double noise) {
  const Beam& one = beams.all[a];
  const Beam& other = beams.all[b];
  const double spacing = std::min(one.length, other.length) * beams.increment * static_cast<double>(steps);
  const double limit = std::min(kStep + 3.0 * noise + kStepsPerSpacing * spacing, kWidestStep + 3.0 * noise);
  return (one.tip() - other.tip()).norm() <= limit;
}

void to_beams(const RangeScan& scan, const TrackerSettings& settings, Beams& out) {
  const std::size_t n = scan.ranges.size();
  out.all.resize(n);
  out.stamp = scan.stamp;
  out.time_increment = scan.time_increment;
  out.increment = std::abs(scan.angle_increment);
  out.end = scan.end();
  out.whole_turn = n > 2 && out.increment * static_cast<double>(n) > 2.0 * M_PI - 0.5 * out.increment;
  const Pose2 middle = pose_between(scan.sensor, scan.sensor_end, 0.5);
  out.centre = Point(middle.x, middle.y);
  for (std::size_t i = 0; i < n; ++i) {
    const double share = n > 1 ? static_cast<double>(i) / static_cast<double>(n - 1) : 0.0;
    const Pose2 sensor = pose_between(scan.sensor, scan.sensor_end, share);
    Beam& beam = out.all[i];
    beam = Beam();
    beam.origin = Point(sensor.x, sensor.y);
    beam.bearing = sensor.theta + scan.angle_min + scan.angle_increment * static_cast<double>(i);
    beam.direction = Point(std::cos(beam.bearing), std::sin(beam.bearing));
    set_length(scan.ranges[i], scan, settings, beam);
  }
  forget_lost_returns(scan, settings.range_noise, out);
}

bool seen_through(const Beams& beams, const Point& place, double beyond) {
  // Bearings grow or fall from beam to beam, but the sensor may turn while it scans: the nearest on each side are
  // sought.
  struct Nearest {
    double angle = M_PI;
    const Beam* beam = nullptr;
  };
  Nearest left, right;
  for (const Beam& beam : beams.all) {
    const Point to = place - beam.origin;
    const double along = to.dot(beam.direction);
    if (along <= 0.0) continue;
    const double across = beam.direction.x() * to.y() - beam.direction.y() * to.x();
    const double angle = std::abs(across) / along;
    Nearest& nearest = across >= 0.0 ? right : left;
    if (angle < nearest.angle) nearest = {angle, &beam};
  }
  const double limit = std::tan(std::min(1.5 * beams.increment, 0.2));
  const auto passes = [&](const Nearest& nearest) {
    return nearest.beam != nullptr && nearest.angle <= limit &&
           nearest.beam->length > (place - nearest.beam->origin).norm() + beyond;
  };
  return passes(left) && passes(right);
}

}  // namespace tracking
}  // namespace hidwa_local_planner
