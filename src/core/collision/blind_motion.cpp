// SPDX-License-Identifier: BSD-3-Clause
#include "core/collision/blind_motion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/util/outline.hpp"
#include "hidwa_local_planner/core/rest.hpp"

namespace hidwa_local_planner {
namespace {

// Between two places of the outline, and two of somebody beside it [m].
constexpr double kSpacing = 0.02;
// Between two places of a circle: less than kSpacing up to a radius of 0.6 m.
constexpr int kPlacesOnCircle = 180;
// Between two directions of a corner [rad]: 5 degrees.
constexpr double kTurnOfNormal = M_PI / 36.0;
// Until a robot that sees somebody begins to brake: two control periods of 20 Hz, besides the latency [s].
constexpr double kReaction = 0.1;

}  // namespace

void BlindMotion::prepare(const Parameters& parameters, const Footprint& footprint, const VelocityLimits& limits,
                          const SensorSectors& sectors) {
  if (known_ && sectors == sectors_) return;
  known_ = true;
  sectors_ = sectors;
  limits_ = limits;
  blind_speed_ = parameters.blind_speed;
  latency_ = parameters.control_latency;
  bounds_.clear();
  if (sectors.empty() || footprint.empty() || footprint.fault() != nullptr) return;
  if (footprint.is_circle()) return add_circle(footprint.radius());
  add_polygon(without_repeats(footprint.outline()));
}

void BlindMotion::add_polygon(const Polygon& outline) {
  const double around = signed_area(outline) > 0.0 ? 1.0 : -1.0;
  const std::size_t n = outline.size();
  const auto normal_after = [&](std::size_t i) {
    const Point way = outline[(i + 1) % n] - outline[i % n];
    return Point(around * Point(way.y(), -way.x()).normalized());
  };
  for (std::size_t i = 0; i < n; ++i) {
    const Point normal = normal_after(i);
    add_side(outline[i], outline[(i + 1) % n], normal);
    add_corner(outline[(i + 1) % n], around > 0.0 ? normal : normal_after(i + 1),
               around > 0.0 ? normal_after(i + 1) : normal);
  }
}

// `before`, `after`: the normals of its sides, the outline going round to the left. A dent has no more than these.
void BlindMotion::add_corner(const Point& corner, const Point& before, const Point& after) {
  const double from = std::atan2(before.y(), before.x());
  const double turn = wrap_angle(std::atan2(after.y(), after.x()) - from);
  const auto steps = static_cast<int>(std::ceil(turn / kTurnOfNormal));
  for (int i = 1; i < steps; ++i) {
    const double angle = from + turn * i / steps;
    const Point normal(std::cos(angle), std::sin(angle));
    if (!sees_beside(corner, normal)) bounds_.push_back(bound_of(corner, normal));
  }
}

// The bound of a place is linear along a side, so of all blind ones the outermost two are enough.
void BlindMotion::add_side(const Point& from, const Point& to, const Point& normal) {
  const auto steps = std::max(1, static_cast<int>(std::ceil((to - from).norm() / kSpacing)));
  bool any = false;
  Bound first, last;
  for (int i = 0; i <= steps; ++i) {
    const Point place = from + (to - from) * (static_cast<double>(i) / steps);
    if (sees_beside(place, normal)) continue;
    const Bound bound = bound_of(place, normal);
    if (!any) first = bound;
    last = bound;
    any = true;
  }
  if (!any) return;
  bounds_.push_back(first);
  bounds_.push_back(last);
}

// However it turns, a circle stays where it is: only its speed counts.
void BlindMotion::add_circle(double radius) {
  Bound ahead, back;
  for (int i = 0; i < kPlacesOnCircle; ++i) {
    const double angle = 2.0 * M_PI * i / kPlacesOnCircle;
    const Point normal(std::cos(angle), std::sin(angle));
    if (sees_beside(radius * normal, normal)) continue;
    const Bound bound{normal.x(), 0.0};
    if (bound.along_v > ahead.along_v) ahead = bound;
    if (bound.along_v < back.along_v) back = bound;
  }
  if (ahead.along_v > 0.0) bounds_.push_back(ahead);
  if (back.along_v < 0.0) bounds_.push_back(back);
}

// Wherever somebody may stand whom the place would come to before the robot rests.
bool BlindMotion::sees_beside(const Point& place, const Point& normal) const {
  const Bound motion = bound_of(place, normal);
  const double fastest =
      std::abs(motion.along_v) * limits_.x.fastest() + std::abs(motion.along_omega) * limits_.theta.fastest();
  const double rest =
      std::max(limits_.x.time_to_rest(limits_.x.fastest()), limits_.theta.time_to_rest(limits_.theta.fastest()));
  const double reach = fastest * (latency_ + kReaction + 0.5 * rest);
  const auto steps = static_cast<int>(std::ceil(reach / kSpacing));
  for (int i = 0; i <= steps; ++i) {
    const Point middle = place + (kBodyRadius + std::min(reach, i * kSpacing)) * normal;
    const auto sees = [&](const SensorSector& sector) { return sector.contains(middle); };
    if (std::none_of(sectors_.begin(), sectors_.end(), sees)) return false;
  }
  return true;
}

Interval BlindMotion::speeds(double omega) const {
  constexpr double kAny = std::numeric_limits<double>::infinity();
  constexpr double kNone = 1e-9;  // part of a normal along the heading
  Interval allowed{-kAny, kAny};
  for (const Bound& bound : bounds_) {
    const double left = blind_speed_ + kCommandRounding - bound.along_omega * omega;
    if (bound.along_v > kNone) {
      allowed.hi = std::min(allowed.hi, left / bound.along_v);
    } else if (bound.along_v < -kNone) {
      allowed.lo = std::max(allowed.lo, left / bound.along_v);
    } else if (left < 0.0) {
      return {kAny, -kAny};
    }
  }
  return allowed;
}

bool BlindMotion::allows(const Twist2& velocity) const {
  const Interval allowed = speeds(velocity.omega);
  return velocity.v >= allowed.lo && velocity.v <= allowed.hi;
}

// One axis comes to rest first.
bool BlindMotion::allows_braking_from(const Twist2& command) const {
  const double until_v = limits_.x.time_to_rest(command.v), until_omega = limits_.theta.time_to_rest(command.omega);
  Twist2 corner;
  if (until_v < until_omega) corner.omega = command.omega * (1.0 - until_v / until_omega);
  if (until_omega < until_v) corner.v = command.v * (1.0 - until_omega / until_v);
  return allows(command) && allows(corner);
}

Twist2 BlindMotion::slowed(const Twist2& velocity) const {
  double share = 1.0;
  for (const Bound& bound : bounds_) {
    const double fast = bound.along_v * velocity.v + bound.along_omega * velocity.omega;
    if (fast > blind_speed_) share = std::min(share, blind_speed_ / fast);
  }
  return {share * velocity.v, share * velocity.omega};
}

VelocityLimits BlindMotion::narrowed(VelocityLimits limits) const {
  const Interval straight = speeds(0.0);
  limits.x.min = std::min(limits.x.max, std::max(limits.x.min, straight.lo));
  limits.x.max = std::max(limits.x.min, std::min(limits.x.max, straight.hi));
  return limits;
}

}  // namespace hidwa_local_planner
