// SPDX-License-Identifier: BSD-3-Clause
#include "benchmark/situations.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <string>
#include <tuple>

#include "benchmark/course.hpp"
#include "hidwa_local_planner/core/footprint.hpp"
#include "support/naive_inflation.hpp"
#include "support/naive_manoeuvre.hpp"
#include "support/naive_planner.hpp"
#include "support/random.hpp"
#include "support/round_outline.hpp"

namespace hidwa_local_planner::test {
namespace {

constexpr std::size_t kSituations = 64;
constexpr double kResolution = 0.05;      // [m]
constexpr double kInflationRadius = 0.5;  // [m]
constexpr double kCostScaling = 10.0;     // [1/m]
constexpr double kBehind = 1.0;           // of the plan [m]
constexpr double kAhead = 3.0;            // [m]

Polygon outline_of(Body body) {
  if (body == Body::polygon) return {{0.21, 0.165}, {-0.21, 0.165}, {-0.21, -0.165}, {0.21, -0.165}};
  return round_outline(0.3);
}

// The map's corner: a window centred on the robot that moves by whole cells.
double origin_around(double centre, int cells) { return (std::floor(centre / kResolution) - cells / 2) * kResolution; }

void mark(Scene& scene, const std::vector<Point>& obstacles) {
  scene.costs.assign(scene.grid().cell_count(), cost::kFree);
  for (const Point& p : obstacles) {
    const Cell cell = scene.grid().cell_at(p.x(), p.y());
    if (scene.grid().contains(cell)) scene.at(cell) = cost::kLethal;
  }
}

Scene place(const Course& course, std::size_t at, const Setting& setting) {
  Scene scene;
  scene.outline = outline_of(setting.body);
  scene.resolution = kResolution;
  scene.size_x = scene.size_y = setting.cells;
  scene.situation.pose = course.path[at];
  scene.origin_x = origin_around(course.path[at].x, setting.cells);
  scene.origin_y = origin_around(course.path[at].y, setting.cells);
  const auto poses = [](double length) { return static_cast<std::size_t>(length / Course::kSpacing); };
  const auto begin = course.path.begin() + static_cast<std::ptrdiff_t>(at - std::min(at, poses(kBehind)));
  const auto end =
      course.path.begin() + static_cast<std::ptrdiff_t>(std::min(at + poses(kAhead) + 1, course.path.size()));
  scene.situation.plan.assign(begin, end);
  scene.situation.goal = course.path.back();
  mark(scene, course.obstacles);
  return scene;
}

void set_in_motion(Random& random, Scene& scene) {
  const Parameters& p = scene.parameters;
  scene.situation.last_command = {random.uniform(0.05, p.max_vel_x), random.uniform(-0.4, 0.4)};
  scene.situation.velocity = scene.situation.last_command;
  scene.situation.velocity.v += random.uniform(-0.02, 0.02);
  scene.steer({p.max_vel_x, random.uniform(-p.max_vel_theta, p.max_vel_theta)});
}

// Within 0.6 m of an obstacle: elsewhere on its path a field is not tight.
bool is_tight(const Scene& scene) {
  constexpr int kReach = 12;  // [cells]
  const Cell robot = scene.grid().cell_at(scene.situation.pose.x, scene.situation.pose.y);
  for (int dj = -kReach; dj <= kReach; ++dj) {
    for (int di = -kReach; di <= kReach; ++di) {
      const bool near = di * di + dj * dj <= kReach * kReach;
      if (near && scene.grid().at({robot.i + di, robot.j + dj}) == cost::kLethal) return true;
    }
  }
  return false;
}

// A robot that got here by admissible commands can stop.
bool could_stop(const Scene& scene) {
  const NaiveBody body = naive_body(scene);
  const Twist2 now = scene.situation.last_command;
  const Twist2 braking = naive_command(scene.parameters, now, {}, scene.situation.period);
  const NaiveEffects steady(scene.parameters, scene.situation.period, now);
  const NaiveManoeuvre stop =
      naive_manoeuvre(scene.parameters, scene.situation.pose, steady, braking, scene.situation.period);
  const std::vector<Pose2> poses = naive_poses(stop, naive_outer_radius(body), 0.25 * scene.resolution);
  return std::none_of(poses.begin(), poses.end(), [&](const Pose2& q) {
    return naive_overlap(scene.grid(), body, q, true) > 0.0 || naive_centre_inscribed(scene.grid(), body, q);
  });
}

// $HIDWA_DATA/barn/worlds.txt, or the same beside the source tree.
std::string barn_worlds_file() {
  const char* folder = std::getenv("HIDWA_DATA");
  return std::string(folder != nullptr ? folder : HIDWA_DATA_DEFAULT) + "/barn/worlds.txt";
}

Course pick_course(Random& random, Ground ground) {
  if (ground == Ground::open) return open_corridor(random);
  static const std::vector<sim::BarnWorld> worlds = sim::load_barn_worlds(barn_worlds_file());
  return barn_course(worlds[static_cast<std::size_t>(random.integer(0, static_cast<int>(worlds.size()) - 1))]);
}

std::vector<Scene> make(const Setting& setting) {
  const double inscribed = Footprint::from_outline(outline_of(setting.body), 0.0).inscribed_radius();
  std::vector<Scene> scenes;
  for (std::uint64_t seed = 1; scenes.size() < kSituations; ++seed) {
    Random random(seed);
    const Course course = pick_course(random, setting.ground);
    const int at = random.integer(static_cast<int>(course.first), static_cast<int>(course.last));
    Scene scene = place(course, static_cast<std::size_t>(at), setting);
    set_in_motion(random, scene);
    if ((setting.ground == Ground::tight && !is_tight(scene)) || !could_stop(scene)) continue;
    inflate(scene, inscribed, kInflationRadius, kCostScaling);
    if (!could_stop(scene)) continue;  // a disc's centre may stand in inscribed cells
    scene.situation.time = scene.situation.period * static_cast<double>(scenes.size());
    scenes.push_back(std::move(scene));
  }
  return scenes;
}

}  // namespace

const char* to_string(Body body) { return body == Body::circle ? "circle" : "polygon"; }
const char* to_string(Ground ground) { return ground == Ground::open ? "open" : "tight"; }

const std::vector<Scene>& situations(const Setting& setting) {
  static std::map<std::tuple<int, Body, Ground>, std::vector<Scene>> made;
  std::vector<Scene>& scenes = made[{setting.cells, setting.body, setting.ground}];
  if (scenes.empty()) scenes = make(setting);
  return scenes;
}

}  // namespace hidwa_local_planner::test
