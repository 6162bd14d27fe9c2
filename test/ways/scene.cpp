// SPDX-License-Identifier: BSD-3-Clause
#include "ways/scene.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <stdexcept>
#include <utility>

#include "floor.hpp"
#include "ways/barn_field.hpp"
#include "ways/floor_map.hpp"
#include "ways/grid_plan.hpp"
#include "ways/rooms.hpp"

namespace hidwa_ways {
namespace {

using hidwa_attack::deepest;
using hidwa_attack::LocalMap;
using hidwa_attack::Placed;

constexpr double kNear = 3.0, kFarAway = 8.0;  // how far a goal is along the plan [m]
constexpr double kPassing = 0.4;               // A plan this near to the site's place passes it [m]

bool stands_free(const World& world, const Shape& shape, const Pose2& pose, double margin) {
  const double gap = margin + 0.004;  // a little more than the search takes
  return deepest(world, Placed(hidwa_attack::padded(shape, gap), pose), 0.01) <= 0.0;
}

// How far it is free around a pose, up to 0.5 m.
double clearance(const World& world, const Shape& shape, const Pose2& pose) {
  return -deepest(world, Placed(shape, pose), 0.5);
}

// Half of the starts are the tightest of a dozen: facing a wall, deep in a pocket.
std::optional<Pose2> find_start(const Site& site, const Shape& shape, Random& random) {
  // A few stand nearer to something than ways need.
  const double margin = random.chance(0.95) ? 0.5 * site.world.resolution() : 0.0;
  const int wanted = random.chance(0.5) ? 12 : 1;
  std::optional<Pose2> best;
  for (int attempt = 0, found = 0; attempt < 400 && found < wanted; ++attempt) {
    const double far = site.around * std::sqrt(random.in(0.0, 1.0)), angle = random.in(-M_PI, M_PI);
    const Pose2 pose{site.at.x + far * std::cos(angle), site.at.y + far * std::sin(angle), random.in(-M_PI, M_PI)};
    if (!stands_free(site.world, shape, pose, margin)) continue;
    ++found;
    if (!best || clearance(site.world, shape, pose) < clearance(site.world, shape, *best)) best = pose;
  }
  return best;
}

bool passes(const std::vector<Pose2>& plan, const Spot& at) {
  const std::size_t count = std::min<std::size_t>(plan.size(), 50);  // the first 2.5 m
  return std::any_of(plan.begin(), plan.begin() + static_cast<std::ptrdiff_t>(count),
                     [&](const Pose2& p) { return std::hypot(p.x - at.x, p.y - at.y) <= kPassing; });
}

std::optional<Spot> find_goal(const Site& site, const GridPlan& from_start, Random& random) {
  std::optional<Spot> any;
  int left = site.passed ? 40 : 1;
  for (int attempt = 0; attempt < 2000 && left > 0; ++attempt) {
    const double x = random.in(0.0, site.world.width());
    const Spot goal{x, random.in(0.0, site.world.height())};
    if (!from_start.reaches(goal) || from_start.length(goal) < kNear || from_start.length(goal) > kFarAway) continue;
    --left;
    any = goal;
    if (!site.passed) break;
    std::vector<Pose2> way = from_start.from(goal);
    std::reverse(way.begin(), way.end());
    if (passes(way, site.at)) break;
  }
  return any;
}

std::uint64_t hash_of(const std::string& name) {
  std::uint64_t hash = 1469598103934665603ULL;
  for (const char c : name) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211ULL;
  return hash;
}

// False where this site has no start or no goal.
bool settle(Scene& scene, Site site, Random& random) {
  const std::optional<Pose2> start = find_start(site, scene.body.shape, random);
  if (!start) return false;
  const double side = std::max(site.world.width(), site.world.height());
  LocalMap map(site.world, side, inscribed(scene.body.shape));
  const auto costs = map.around({0.5 * side, 0.5 * side, 0.0});
  const std::optional<Spot> goal = find_goal(site, GridPlan(costs, {start->x, start->y}), random);
  if (!goal) return false;
  const GridPlan to_goal(costs, *goal);
  if (!to_goal.reaches({start->x, start->y})) return false;
  scene.plan = to_goal.from({start->x, start->y});
  scene.start = *start;
  scene.world = std::move(site.world);
  return true;
}

}  // namespace

const std::vector<Kind>& drawn_kinds() {
  static const std::vector<Kind> kinds = {{"posts", posts, true, ""},       {"boxes", boxes, true, ""},
                                          {"dead_end", dead_end, true, ""}, {"doorway", doorway, true, ""},
                                          {"corridor", corridor, true, ""}, {"corner", corner, true, ""}};
  return kinds;
}

Kind barn_kind(const std::string& file) {
  namespace sim = hidwa_local_planner::sim;
  const auto worlds = std::make_shared<const std::vector<sim::BarnWorld>>(sim::load_barn_worlds(file));
  return {"barn", [worlds](const Measure& measure, Random& random) { return barn(*worlds, measure, random); }, true,
          "--barn " + file};
}

Kind map_kind(const std::string& yaml) {
  const auto map = std::make_shared<const World>(hidwa_attack::world_of(hidwa_local_planner::sim::load_map(yaml)));
  const std::size_t begin = yaml.rfind('/') + 1;
  std::string name = yaml.substr(begin, yaml.rfind('.') - begin);
  // bwi_common calls every map's file map.yaml: its folder has the name.
  if (name == "map" && begin > 1) {
    const std::size_t folder = yaml.rfind('/', begin - 2) + 1;
    name = yaml.substr(folder, begin - 1 - folder);
  }
  return {name, [map](const Measure&, Random& random) { return gap_of(*map, random); }, false, "--map " + yaml};
}

Region Scene::local_map() const {
  const double step = world.resolution();
  const double x = std::floor(start.x / step) * step, y = std::floor(start.y / step) * step;
  return {x - 0.5 * kLocalMap, y - 0.5 * kLocalMap, kLocalMap};
}

hidwa_local_planner::Parameters Scene::parameters() const {
  hidwa_local_planner::Parameters parameters;
  parameters.mode = hidwa_local_planner::OperatorMode::off;
  if (reverse) parameters.min_vel_x = -0.25;
  return parameters;
}

Pace Scene::pace() const {
  const hidwa_local_planner::Parameters p = parameters();
  return {p.max_vel_x, -p.min_vel_x, p.max_vel_theta};
}

double inscribed(const Shape& shape) { return hidwa_attack::innermost({hidwa_attack::told_corners(shape), 0.0}); }

Scene scene_of(const Kind& kind, std::uint64_t seed) {
  Random random(hash_of(kind.name) ^ (seed * 0x9e3779b97f4a7c15ULL));
  const Body& body = all_bodies()[seed % kBodies];
  Scene scene{&kind, seed, body, seed / kBodies % 2 == 1, random.chance(0.7), random.chance(0.33), World(1.0, 1.0, 0.1),
              {},    {}};
  const double resolution =
      kind.any_resolution ? random.of({0.05, 0.05, 0.05, 0.05, 0.05, 0.05, 0.05, 0.025, 0.1, 0.1}) : 0.05;
  for (int attempt = 0; attempt < 300; ++attempt) {
    if (settle(scene, kind.make({half_width(body.shape), resolution}, random), random)) return scene;
  }
  throw std::logic_error("no scene " + kind.name + " of seed " + std::to_string(seed));
}

}  // namespace hidwa_ways
