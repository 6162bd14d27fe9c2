// SPDX-License-Identifier: BSD-3-Clause
// A base that people run into, and where they touch it. It shares no code with the planner that drives it.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <deque>
#include <optional>
#include <utility>

#include "hidwa_local_planner/core/types.hpp"
#include "support/round_outline.hpp"

namespace hidwa_local_planner::test {

class AttackedBase {
 public:
  static constexpr double kTick = 0.005, kPeriod = 0.05, kLatency = 0.1;  // [s]

  Polygon corners;      // of its outline, robot frame, going left round [m]
  double radius = 0.0;  // above 0: it is a circle instead [m]
  double acc = 2.5;     // [m/s^2]
  double turn_acc = 3.2;
  Point at{0.0, 0.0};    // [m]
  double heading = 0.0;  // [rad]
  Twist2 u;              // as it moves [m/s, rad/s]
  Twist2 last;           // as it was told
  double driven = 0.0;   // [m]

  Point in_robot(const Point& p) const {
    const Point d = p - at;
    return {std::cos(heading) * d.x() + std::sin(heading) * d.y(),
            std::cos(heading) * d.y() - std::sin(heading) * d.x()};
  }

  /// A sensor `ahead` of its middle [m] that looks ahead, `view` [rad] wide, looks at a place; 2 pi: all round.
  bool in_view(const Point& place, double ahead, double view) const {
    const Point seen = in_robot(place) - Point(ahead, 0.0);
    return view > 6.28 || std::abs(std::atan2(seen.y(), seen.x())) < 0.5 * view;
  }

  void take(double now, const Twist2& command) {
    last = command;
    sent_.push_back({now + kLatency, command});
  }

  /// One tick. A command is reached evenly over a period, or as the limits allow.
  void move(double now) {
    while (!sent_.empty() && sent_.front().first <= now + 1e-9) {
      wanted_ = sent_.front().second;
      sent_.pop_front();
      rate_ = {std::min(acc, std::abs(wanted_.v - u.v) / kPeriod),
               std::min(turn_acc, std::abs(wanted_.omega - u.omega) / kPeriod)};
    }
    const auto towards = [](double from, double to, double most) { return from + std::clamp(to - from, -most, most); };
    u = {towards(u.v, wanted_.v, rate_.v * kTick), towards(u.omega, wanted_.omega, rate_.omega * kTick)};
    heading += u.omega * kTick;
    at += u.v * kTick * Point(std::cos(heading), std::sin(heading));
    driven += std::abs(u.v) * kTick;
  }

  /// How fast the place where a body of this radius touches it moves towards the body's middle [m/s], if it does.
  std::optional<double> touched(const Point& middle, double body) const {
    const Point he = in_robot(middle), place = nearest(he);
    if ((he - place).norm() > body) return std::nullopt;
    return Point(u.v - u.omega * place.y(), u.omega * place.x()).dot((he - place).normalized());
  }

 private:
  // The point of the outline that is nearest to a point outside of it; robot frame.
  Point nearest(const Point& to) const {
    if (radius > 0.0) return to * (radius / to.norm());
    Point best(0.0, 0.0);
    double least = 1e9;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Point a = corners[i], way = corners[(i + 1) % corners.size()] - a;
      const Point point = a + way * std::clamp((to - a).dot(way) / way.squaredNorm(), 0.0, 1.0);
      if ((to - point).norm() >= least) continue;
      least = (to - point).norm();
      best = point;
    }
    return best;
  }

  Twist2 wanted_, rate_;
  std::deque<std::pair<double, Twist2>> sent_;
};

}  // namespace hidwa_local_planner::test
