// SPDX-License-Identifier: BSD-3-Clause
// The slow way to say how fast a robot moves to where nobody sees: the twin of BlindMotion.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "support/naive_collision.hpp"
#include "support/random.hpp"
#include "support/scene.hpp"

namespace hidwa_local_planner::test {

/// A place of the outline, and the direction from the robot to the outside.
struct NaivePlace {
  Point at, outwards;
};

/// All places of the outline that are looked at: not more than 0.02 m apart along each side, 180 of a circle, and the
/// directions of each corner.
inline std::vector<NaivePlace> naive_places(const NaiveBody& body) {
  std::vector<NaivePlace> places;
  if (body.radius > 0.0) {
    for (int i = 0; i < 180; ++i) {
      const Point to(std::cos(2.0 * M_PI * i / 180), std::sin(2.0 * M_PI * i / 180));
      places.push_back({body.radius * to, to});
    }
    return places;
  }
  const double left_round = naive_twice_area(body.corners) < 0.0 ? -1.0 : 1.0;
  for (std::size_t i = 0; i < body.corners.size(); ++i) {
    const Point from = body.corners[i], to = body.corners[(i + 1) % body.corners.size()], way = to - from;
    const int steps = static_cast<int>(std::ceil(way.norm() / 0.02));
    for (int k = 0; k <= steps; ++k) {
      places.push_back({from + way * (1.0 * k / steps), left_round * Point(way.y(), -way.x()) / way.norm()});
    }
    // Between this side's direction and the next one's, where the corner is no dent: not more than 5 degrees apart.
    const Point next = body.corners[(i + 2) % body.corners.size()] - to;
    const double turn = std::atan2(way.x() * next.y() - way.y() * next.x(), way.dot(next)) * left_round;
    const int turns = static_cast<int>(std::ceil(turn / (M_PI / 36)));
    const double direction = std::atan2(places.back().outwards.y(), places.back().outwards.x());
    for (int k = 1; k < turns; ++k) {
      const double angle = direction + left_round * turn * k / turns;
      places.push_back({to, Point(std::cos(angle), std::sin(angle))});
    }
  }
  return places;
}

class NaiveBlind {
 public:
  NaiveBlind(const Scene& scene, const NaiveBody& body) : p_(scene.parameters) {
    for (const NaivePlace& place : naive_places(body)) {
      if (!scene.situation.sensor_sectors.empty() && !watched(scene.situation.sensor_sectors, place)) {
        blind_.push_back(place);
      }
    }
  }
  bool too_fast(const Twist2& u) const {
    return std::any_of(blind_.begin(), blind_.end(), [&](const NaivePlace& place) {
      const Point velocity(u.v - u.omega * place.at.y(), u.omega * place.at.x());
      return velocity.dot(place.outwards) > p_.blind_speed + 2e-9;
    });
  }
  /// At any time until the robot rests.
  bool too_fast_while_braking(const Twist2& u) const {
    const double until = std::max(std::abs(u.v) / p_.braking_x(), std::abs(u.omega) / p_.braking_theta());
    for (int k = 0; k <= 500; ++k) {
      const double time = until * k / 500;
      const auto left = [time](double speed, double braking) {
        return std::copysign(std::max(0.0, std::abs(speed) - braking * time), speed);
      };
      if (too_fast({left(u.v, p_.braking_x()), left(u.omega, p_.braking_theta())})) return true;
    }
    return false;
  }
  /// The slowest and the fastest that it may drive straight on.
  void narrow(Parameters& p) const {
    for (const NaivePlace& place : blind_) {
      const double along = place.outwards.x(), most = (p.blind_speed + 1e-9) / along;
      if (along > 1e-9) p.max_vel_x = std::min(p.max_vel_x, most);
      if (along < -1e-9) p.min_vel_x = std::max(p.min_vel_x, most);
    }
  }

 private:
  static bool in_view(const SensorSector& s, const Point& p) {
    const double dx = p.x() - s.pose.x, dy = p.y() - s.pose.y;
    // The angle to the middle of the view, by the scalar product.
    const double cosine = (dx * std::cos(s.pose.theta) + dy * std::sin(s.pose.theta)) / std::hypot(dx, dy);
    return std::hypot(dx, dy) <= s.range && std::acos(std::clamp(cosine, -1.0, 1.0)) <= 0.5 * s.width;
  }
  // Whoever may stand there, 0.2 m from the middle to the outline, is in view of a sensor.
  bool watched(const SensorSectors& sectors, const NaivePlace& place) const {
    const double v = std::max(p_.max_vel_x, -p_.min_vel_x), omega = p_.max_vel_theta;
    const double fastest = std::abs(place.outwards.x()) * v +
                           std::abs(place.outwards.y() * place.at.x() - place.outwards.x() * place.at.y()) * omega;
    const double rest = std::max(v / p_.braking_x(), omega / p_.braking_theta());
    const double reach = fastest * (p_.control_latency + 0.1 + rest / 2.0);
    for (double away = 0.0; true; away += 0.02) {
      const Point middle = place.at + (0.2 + std::min(away, reach)) * place.outwards;
      const auto sees = [&](const SensorSector& s) { return in_view(s, middle); };
      if (std::none_of(sectors.begin(), sectors.end(), sees)) return false;
      if (away >= reach) return true;
    }
  }

  Parameters p_;
  std::vector<NaivePlace> blind_;
};

/// One sensor or two, and a robot that drives backwards.
inline void add_sectors(Random& random, Scene& scene) {
  scene.parameters.min_vel_x = -random.uniform(0.1, 0.5);
  scene.parameters.blind_speed = random.chance(0.2) ? 0.0 : random.uniform(0.02, 0.2);
  for (int count = random.integer(1, 2); count > 0; --count) {
    scene.situation.sensor_sectors.push_back(
        {{random.uniform(-0.2, 0.2), random.uniform(-0.1, 0.1), random.uniform(-1.0, 1.0)},
         random.uniform(2.0, 6.2),
         random.uniform(0.6, 5.0)});
  }
}

}  // namespace hidwa_local_planner::test
