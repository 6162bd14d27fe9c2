// SPDX-License-Identifier: BSD-3-Clause
// A world of walls, posts and walkers, and what a laser on a robot sees of it: each beam against each shape, by
// formula.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <vector>

#include "hidwa_local_planner/core/types.hpp"
#include "support/random.hpp"
#include "tracking/range_scan.hpp"

namespace hidwa_local_planner::test {

struct Wall {
  Point a, b;  // [m]
};

struct Post {
  Point centre;   // [m]
  double radius;  // [m]
};

/// Somebody who walks, or a cylinder that moves. `at` says where its middle is at a time [s].
struct Walker {
  std::function<Point(double)> at;
  double radius = 0.25;  // of the body [m]
  bool legs = false;     // the laser sees two legs instead of the body
  double stride = 0.3;   // from foot to foot at most, along the way [m]
  double steps = 0.9;    // pairs of steps a second [Hz]

  Point velocity(double time) const { return (at(time + 1e-4) - at(time - 1e-4)) / 2e-4; }

  /// What the laser sees of it.
  std::vector<Post> shapes(double time) const {
    const Point p = at(time);
    if (!legs) return {{p, radius}};
    const Point v = velocity(time);
    const Point ahead = v.norm() > 0.05 ? Point(v.normalized()) : Point(1.0, 0.0);
    const Point left(-ahead.y(), ahead.x());
    const double swing = v.norm() > 0.05 ? 0.5 * stride * std::sin(2.0 * M_PI * steps * time) : 0.0;
    return {{p + 0.1 * left + swing * ahead, 0.065}, {p - 0.1 * left - swing * ahead, 0.065}};
  }
};

struct LaserModel {
  int beams = 720;
  double view = 1.5 * M_PI;  // [rad]
  double range_max = 10.0;   // [m]
  double noise = 0.01;       // standard deviation [m]
  double rate = 20.0;        // [Hz]
};

/// Standard normal (Box and Muller).
inline double normal(Random& random) {
  const double u = 1.0 - random.uniform(0.0, 1.0);
  return std::sqrt(-2.0 * std::log(u)) * std::cos(2.0 * M_PI * random.uniform(0.0, 1.0));
}

/// Distance along a beam to a wall; infinite: it does not meet it.
inline double range_to(const Wall& wall, const Point& from, const Point& beam) {
  const Point d = wall.b - wall.a;
  const double cross = beam.x() * d.y() - beam.y() * d.x();
  if (std::abs(cross) < 1e-12) return std::numeric_limits<double>::infinity();
  const Point to = wall.a - from;
  const double along = (to.x() * d.y() - to.y() * d.x()) / cross;
  const double share = (to.x() * beam.y() - to.y() * beam.x()) / cross;
  return along > 0.0 && share >= 0.0 && share <= 1.0 ? along : std::numeric_limits<double>::infinity();
}

inline double range_to(const Post& post, const Point& from, const Point& beam) {
  const Point to = post.centre - from;
  const double along = to.dot(beam);
  const double inside = post.radius * post.radius - (to.squaredNorm() - along * along);
  if (along <= 0.0 || inside < 0.0) return std::numeric_limits<double>::infinity();
  return along - std::sqrt(inside);
}

struct ScanWorld {
  std::vector<Wall> walls;
  std::vector<Post> posts;
  std::vector<Walker> walkers;
  LaserModel laser;

  void add_box(double x0, double y0, double x1, double y1) {
    const Point a(x0, y0), b(x1, y0), c(x1, y1), d(x0, y1);
    for (const Wall& wall : {Wall{a, b}, Wall{b, c}, Wall{c, d}, Wall{d, a}}) walls.push_back(wall);
  }

  /// How many beams meet half of a walker at this distance from the laser [m] where nothing hides him.
  double half_of(const Walker& walker, double distance) const {
    const double width = walker.legs ? 0.26 : 2.0 * walker.radius;
    return 0.5 * width / distance / (laser.view / (laser.beams - 1));
  }
  double bearing_of(int beam) const { return -0.5 * laser.view + laser.view * beam / (laser.beams - 1); }

  /// What the laser sees at `time` [s] from its true pose. `seen` counts the beams that meet each walker. The scan
  /// holds `odometry` as the sensor's pose.
  RangeScan scan(double time, const Pose2& truth, const Pose2& odometry, Random& random, std::vector<int>& seen) const {
    RangeScan out;
    out.stamp = time;
    out.angle_min = bearing_of(0);
    out.angle_increment = laser.view / (laser.beams - 1);
    out.range_min = 0.05;
    out.range_max = laser.range_max;
    out.sensor = out.sensor_end = odometry;
    seen.assign(walkers.size(), 0);
    std::vector<std::vector<Post>> bodies;
    for (const Walker& walker : walkers) bodies.push_back(walker.shapes(time));
    const Point from(truth.x, truth.y);
    for (int i = 0; i < laser.beams; ++i) {
      const double bearing = truth.theta + bearing_of(i);
      const Point beam(std::cos(bearing), std::sin(bearing));
      double nearest = std::numeric_limits<double>::infinity();
      for (const Wall& wall : walls) nearest = std::min(nearest, range_to(wall, from, beam));
      for (const Post& post : posts) nearest = std::min(nearest, range_to(post, from, beam));
      std::size_t whose = walkers.size();
      for (std::size_t w = 0; w < walkers.size(); ++w) {
        for (const Post& post : bodies[w]) {
          const double range = range_to(post, from, beam);
          if (range < nearest) {
            nearest = range;
            whose = w;
          }
        }
      }
      if (whose < walkers.size()) ++seen[whose];
      nearest += laser.noise * normal(random);
      out.ranges.push_back(nearest < laser.range_max ? static_cast<float>(nearest)
                                                     : std::numeric_limits<float>::infinity());
    }
    return out;
  }
};

/// A robot that turns on the spot towards each way point, drives there, and begins anew after the last. Its odometry
/// errs.
class ScanRobot {
 public:
  ScanRobot(std::vector<Point> way, double speed, double turn_rate)
      : way_(std::move(way)), speed_(speed), turn_rate_(turn_rate) {
    truth_ = {way_[0].x(), way_[0].y(), 0.0};
    odometry_ = truth_;
  }

  double slip_x = 0.0;      // odometry's error, as a share of what was driven
  double slip_theta = 0.0;  // and turned

  void advance(double dt) {
    const Point to = way_[next_] - Point(truth_.x, truth_.y);
    const double off = wrap_angle(std::atan2(to.y(), to.x()) - truth_.theta);
    double v = 0.0;
    double omega = 0.0;
    if (to.norm() < speed_ * dt) {
      next_ = (next_ + 1) % way_.size();
    } else if (std::abs(off) > turn_rate_ * dt) {
      omega = off > 0.0 ? turn_rate_ : -turn_rate_;
    } else {
      v = speed_;
      omega = off / dt;
    }
    move(truth_, v * dt, omega * dt);
    move(odometry_, v * (1.0 + slip_x) * dt, omega * (1.0 + slip_theta) * dt);
  }

  const Pose2& truth() const { return truth_; }
  const Pose2& odometry() const { return odometry_; }

  /// A place of the world, and a direction, in the odometry's frame.
  Point in_odometry(const Point& place) const {
    return Point(odometry_.x, odometry_.y) + turned(place - Point(truth_.x, truth_.y));
  }
  Point turned(const Point& d) const {
    const double a = odometry_.theta - truth_.theta;
    return {std::cos(a) * d.x() - std::sin(a) * d.y(), std::sin(a) * d.x() + std::cos(a) * d.y()};
  }

 private:
  static void move(Pose2& pose, double forward, double turn) {
    pose.theta = wrap_angle(pose.theta + 0.5 * turn);
    pose.x += forward * std::cos(pose.theta);
    pose.y += forward * std::sin(pose.theta);
    pose.theta = wrap_angle(pose.theta + 0.5 * turn);
  }

  std::vector<Point> way_;
  double speed_;      // [m/s]
  double turn_rate_;  // [rad/s]
  std::size_t next_ = 1;
  Pose2 truth_;
  Pose2 odometry_;
};

/// To and fro between two places at a constant speed, without a stop.
inline std::function<Point(double)> to_and_fro(const Point& a, const Point& b, double speed, double start = 0.0) {
  return [=](double time) -> Point {
    const double length = (b - a).norm();
    const double way = std::fmod(speed * (time + start), 2.0 * length);
    return a + (b - a) / length * (way < length ? way : 2.0 * length - way);
  };
}

}  // namespace hidwa_local_planner::test
