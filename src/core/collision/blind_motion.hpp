// SPDX-License-Identifier: BSD-3-Clause
// Where nobody sees beside the robot, its outline moves slowly.
//
// Somebody may stand at a place of the outline, or as far from it as the place moves until the robot rests. Where his
// middle would be in no sensor's field of view, the place may move outwards, along the normal n of its side, by no more
// than blind_speed; a corner so along each direction between the normals of its two sides. A place (x, y) moves with (v
// - omega y, omega x). So the bound
//
//   n_x v + (n_y x - n_x y) omega <= blind_speed
//
// is a half-plane of velocities, as the wheels' limit is, and rest lies in it. It holds for a command and for all
// velocities of the braking after it: between two corners of that they lie on a line.
//
// What was seen a moment ago does not count: from the edge of the field of view somebody at 1.8 m/s reaches a place
// 0.3 m behind it within 0.17 s, which is about the time until the robot rests.
#pragma once

#include <vector>

#include "core/motion/velocity_limits.hpp"
#include "hidwa_local_planner/core/footprint.hpp"
#include "hidwa_local_planner/core/parameters.hpp"
#include "hidwa_local_planner/core/sensor_sector.hpp"
#include "hidwa_local_planner/core/types.hpp"

namespace hidwa_local_planner {

class BlindMotion {
 public:
  /// Once a cycle. Without sectors nothing is bounded.
  void prepare(const Parameters& parameters, const Footprint& footprint, const VelocityLimits& limits,
               const SensorSectors& sectors);
  /// The parameters or the footprint are others now.
  void forget() { known_ = false; }

  /// Some velocities are not allowed.
  bool bounds() const { return !bounds_.empty(); }
  /// The speeds that are allowed at a rate of turn [rad/s], [m/s]. None where lo > hi.
  Interval speeds(double omega) const;
  bool allows(const Twist2& velocity) const;
  /// It, and all velocities of the braking after it.
  bool allows_braking_from(const Twist2& command) const;
  /// The same way, slowly enough.
  Twist2 slowed(const Twist2& velocity) const;
  /// The limits as they are while the robot drives straight on.
  VelocityLimits narrowed(VelocityLimits limits) const;

 private:
  // along_v * v + along_omega * omega <= blind_speed_
  struct Bound {
    double along_v = 0.0;
    double along_omega = 0.0;  // [m]
  };
  void add_polygon(const Polygon& outline);
  void add_corner(const Point& corner, const Point& before, const Point& after);
  void add_side(const Point& from, const Point& to, const Point& normal);
  void add_circle(double radius);
  static Bound bound_of(const Point& place, const Point& normal) {
    return {normal.x(), normal.y() * place.x() - normal.x() * place.y()};
  }
  bool sees_beside(const Point& place, const Point& normal) const;

  std::vector<Bound> bounds_;
  SensorSectors sectors_;
  VelocityLimits limits_;
  double blind_speed_ = 0.0;  // [m/s]
  double latency_ = 0.0;      // [s]
  bool known_ = false;        // the bounds are those of sectors_
};

}  // namespace hidwa_local_planner
