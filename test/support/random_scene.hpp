// SPDX-License-Identifier: BSD-3-Clause
// Random scenes from a seed. Resolution 1/16 m and poses at multiples of 1/1024 m, at least 1/256 m away from
// every cell border: cells, and so every whole number in the planner, are the same in a turned, mirrored or
// moved scene.
#pragma once

#include <algorithm>
#include <cmath>

#include "support/naive_collision.hpp"
#include "support/naive_inflation.hpp"
#include "support/random.hpp"
#include "support/round_outline.hpp"
#include "support/scene.hpp"

namespace hidwa_local_planner::test {

constexpr double kSceneResolution = 1.0 / 16.0;  // [m]

/// The nearest coordinate that is a multiple of 1/1024 m at least 1/256 m inside its cell.
inline double inside_cell(double value) {
  const double cell = std::floor(value / kSceneResolution);
  const double offset = std::round((value - cell * kSceneResolution) * 1024.0);  // in [0, 64]
  return cell * kSceneResolution + std::min(std::max(offset, 4.0), 60.0) / 1024.0;
}

/// Corners on an ellipse: convex. The origin lies well inside.
inline Polygon random_convex_outline(Random& random) {
  const int n = random.integer(3, 8);
  const double a = random.uniform(0.15, 0.35), b = random.uniform(0.12, 0.3);
  const double shift = random.uniform(-0.05, 0.05);
  Polygon corners;
  for (int i = 0; i < n; ++i) {
    const double angle = 2.0 * M_PI * (i + random.uniform(0.05, 0.6)) / n;
    corners.emplace_back(shift + a * std::cos(angle), b * std::sin(angle));
  }
  return corners;
}

/// Corners at random distances in every direction: simple, seldom convex.
inline Polygon random_star_outline(Random& random) {
  const int n = random.integer(5, 9);
  Polygon corners;
  for (int i = 0; i < n; ++i) {
    const double angle = 2.0 * M_PI * (i + random.uniform(0.0, 0.6)) / n;
    const double radius = random.uniform(0.12, 0.35);
    corners.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  return corners;
}

inline Polygon random_outline(Random& random) {
  const double kind = random.uniform(0.0, 1.0);
  if (kind < 0.35) return round_outline(random.uniform(0.12, 0.3));
  return kind < 0.7 ? random_convex_outline(random) : random_star_outline(random);
}

inline void add_obstacles(Random& random, Scene& scene, int blocks, double keep_free) {
  const Pose2 robot = scene.situation.pose;
  for (int k = 0; k < blocks; ++k) {
    const int i0 = random.integer(0, scene.size_x - 1), j0 = random.integer(0, scene.size_y - 1);
    const int width = random.integer(1, 5), height = random.integer(1, 5);
    const std::uint8_t value = random.chance(0.1) ? cost::kUnknown : cost::kLethal;
    for (int j = j0; j < std::min(j0 + height, scene.size_y); ++j) {
      for (int i = i0; i < std::min(i0 + width, scene.size_x); ++i) {
        const Point c = scene.grid().centre({i, j});
        if (std::hypot(c.x() - robot.x, c.y() - robot.y) > keep_free) scene.at({i, j}) = value;
      }
    }
  }
}

/// A winding plan that passes the robot, less than a cell from pose to pose: no pose has to be put in
/// between.
inline void add_plan(Random& random, Scene& scene) {
  const Pose2 robot = scene.situation.pose;
  double heading = robot.theta + random.uniform(-1.2, 1.2);
  double x = robot.x + random.uniform(-0.3, 0.3) - 0.3 * std::cos(heading);
  double y = robot.y + random.uniform(-0.3, 0.3) - 0.3 * std::sin(heading);
  const int poses = random.integer(10, 60);
  const double curvature = random.uniform(-0.08, 0.08);
  for (int k = 0; k < poses; ++k) {
    scene.situation.plan.push_back({inside_cell(x), inside_cell(y), heading});
    heading += curvature + random.uniform(-0.1, 0.1);
    x += 0.055 * std::cos(heading);
    y += 0.055 * std::sin(heading);
  }
  if (random.chance(0.04)) {  // the plan lies off the map
    for (Pose2& pose : scene.situation.plan) pose.x += kSceneResolution * 100.0;
  }
  const double beyond = random.chance(0.5) ? 0.0 : random.uniform(0.5, 3.0);
  scene.situation.goal = {inside_cell(x + beyond * std::cos(heading)), inside_cell(y + beyond * std::sin(heading)),
                          heading};
}

inline void randomise_robot(Random& random, Parameters& p) {
  p.max_vel_x = random.uniform(0.2, 1.0);
  p.min_vel_x = random.chance(0.3) ? -random.uniform(0.05, 0.3) : 0.0;
  p.max_vel_theta = random.uniform(0.5, 2.0);
  p.acc_lim_x = random.uniform(0.4, 3.0);
  p.acc_lim_theta = random.uniform(0.6, 4.0);
  p.decel_lim_x = random.chance(0.5) ? 0.0 : random.uniform(-3.0, -0.5);
  p.decel_lim_theta = random.chance(0.5) ? 0.0 : random.uniform(0.8, 4.0);
  if (random.chance(0.3)) {
    p.wheel_separation = random.uniform(0.2, 0.5);
    p.max_wheel_speed = random.uniform(0.8, 1.5) * p.max_vel_x;
  }
  p.footprint_padding = random.chance(0.3) ? random.uniform(0.005, 0.03) : 0.0;
  if (random.chance(0.15)) {
    p.min_in_place_vel_theta = random.uniform(0.1, 0.4);
  }
}

inline void randomise_search(Random& random, Parameters& p) {
  p.generator = random.chance(0.5) ? Generator::standard : Generator::dwa;
  p.method = random.chance(0.3) ? Method::paper : Method::hidwa;
  p.sim_time = random.uniform(0.8, 2.0);
  p.vx_samples = random.integer(2, 6);
  p.vth_samples = random.integer(3, 9);
  if (random.chance(0.1)) p.vx_samples = p.vth_samples = 20;
  p.linear_granularity = random.uniform(0.04, 0.1);
  p.angular_granularity = random.uniform(0.025, 0.1);
  p.control_latency = random.chance(0.3) ? 0.0 : random.uniform(0.02, 0.3);
  p.unknown_is_obstacle = random.chance(0.7);
}

inline void randomise_costs(Random& random, Parameters& p) {
  p.critics = random.pick<const char*>(
      {"RotateToGoal, Oscillation, BaseObstacle, GoalAlign, PathAlign, PathDist, GoalDist",
       "PathDist, GoalDist, Twirling, BaseObstacle", "ObstacleFootprint, PathAlign, GoalAlign, PathDist, GoalDist",
       "RotateToGoal, Oscillation, ObstacleFootprint, GoalAlign, PathAlign, PathDist, GoalDist, "
       "PreferForward, Twirling"});
  for (double* scale : {&p.PathAlign_scale, &p.PathDist_scale, &p.GoalAlign_scale, &p.GoalDist_scale}) {
    *scale = random.uniform(5.0, 40.0);
  }
  p.forward_point_distance = random.uniform(0.05, 0.4);
  p.BaseObstacle_scale = random.uniform(0.01, 0.1);
  p.Twirling_scale = random.uniform(0.1, 5.0);
  p.PreferForward_penalty = random.uniform(0.1, 2.0);
  p.xy_goal_tolerance = random.uniform(0.1, 0.4);
  p.s_v = random.uniform(20.0, 500.0);
  p.s_omega = random.uniform(20.0, 900.0);
}

/// A velocity that the robot can have: within its limits and those of its wheels.
inline Twist2 random_velocity(Random& random, const Parameters& p) {
  Twist2 u{random.uniform(p.min_vel_x, p.max_vel_x), random.uniform(-p.max_vel_theta, p.max_vel_theta)};
  if (p.has_wheel_limit()) {
    const double wheel = std::abs(u.v) + std::abs(u.omega) * p.wheel_separation / 2.0;
    const double scale = std::min(1.0, p.max_wheel_speed / wheel);
    u = {u.v * scale, u.omega * scale};
  }
  return u;
}

inline void randomise_motion(Random& random, Scene& scene) {
  const Parameters& p = scene.parameters;
  Situation& s = scene.situation;
  s.period = random.pick({0.04, 0.05, 0.1});
  s.last_command = random.chance(0.15) ? Twist2{} : random_velocity(random, p);
  s.velocity = s.last_command;
  s.velocity.v += random.uniform(-0.05, 0.05);
  s.velocity.omega += random.uniform(-0.1, 0.1);
  if (p.method == Method::paper) s.velocity = random_velocity(random, p);
  s.time = random.uniform(0.0, 100.0);
  if (random.chance(0.75)) {
    scene.steer({random.chance(0.7) ? p.max_vel_x : random.uniform(-0.2, 1.2), random.uniform(-2.0, 2.0)});
    if (random.chance(0.2)) scene.intent.u_h.omega = 0.0;
    if (random.chance(0.1)) scene.intent.influence = Influence::direct;
  }
}

/// The goal is where the robot is, at the heading drawn: then critics reject nothing for autonomy's sake.
inline void arrive(Scene& scene) {
  scene.situation.goal.x = scene.situation.pose.x + kSceneResolution;
  scene.situation.goal.y = scene.situation.pose.y;
  scene.situation.goal_latched = true;
}

/// The default parameters, with as few samples as were drawn, for time's sake, and the drawn padding.
inline void take_default_profile(Parameters& p) {
  const Parameters drawn = p;
  p = Parameters();
  p.vx_samples = drawn.vx_samples;
  p.vth_samples = drawn.vth_samples;
  p.footprint_padding = drawn.footprint_padding;
}

inline Scene random_scene(std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  scene.resolution = kSceneResolution;
  scene.size_x = random.integer(36, 60);
  scene.size_y = random.integer(36, 60);
  scene.origin_x = kSceneResolution * random.integer(-200, 200);
  scene.origin_y = kSceneResolution * random.integer(-200, 200);
  scene.costs.assign(static_cast<std::size_t>(scene.size_x * scene.size_y), cost::kFree);
  randomise_robot(random, scene.parameters);
  randomise_search(random, scene.parameters);
  randomise_costs(random, scene.parameters);
  scene.outline = random_outline(random);
  const double middle_x = scene.origin_x + 0.5 * scene.size_x * scene.resolution;
  const double middle_y = scene.origin_y + 0.5 * scene.size_y * scene.resolution;
  const double heading = random.chance(0.1) ? 0.5 * M_PI * random.integer(-1, 2) : random.uniform(-M_PI, M_PI);
  scene.situation.pose = {inside_cell(middle_x + random.uniform(-0.4, 0.4)),
                          inside_cell(middle_y + random.uniform(-0.4, 0.4)), heading};
  randomise_motion(random, scene);
  add_plan(random, scene);
  const double outer = naive_outer_radius({scene.outline, 0.0}) + scene.parameters.footprint_padding;
  const double keep_free = random.chance(0.9) ? outer + 0.1 : 0.0;
  add_obstacles(random, scene, random.integer(0, 25), keep_free);
  const double inscribed = random.uniform(0.1, 0.25), scaling = random.uniform(2.0, 10.0);
  inflate(scene, inscribed, inscribed + random.uniform(0.1, 0.4), scaling);
  scene.parameters.comfort_acc_lim_theta = random.chance(0.3) ? 0.0 : random.uniform(0.2, 3.0);
  scene.parameters.comfort_turn_time = random.chance(0.3) ? 0.0 : random.uniform(0.1, 1.5);
  Parameters& p = scene.parameters;
  if (random.chance(0.15)) p.min_vel_x = random.uniform(0.02, 0.5) * p.max_vel_x;
  return scene;
}

}  // namespace hidwa_local_planner::test
