// SPDX-License-Identifier: BSD-3-Clause
#include "study/crowd_drive.hpp"

#include <algorithm>
#include <exception>

#include "sim/crowd.hpp"
#include "study/bystander.hpp"
#include "study/error.hpp"

namespace hidwa_local_planner {
namespace study {
namespace {

constexpr std::size_t kPlaces = 16;
constexpr double kWayClearance = 0.35;  // [m], of people's ways from walls

}  // namespace

std::shared_ptr<const sim::FloorWays> ways_of_people(const Scene& scene, std::uint64_t seed) {
  const Eigen::Vector2d start(scene.start.x, scene.start.y);
  const sim::OccupancyMap& map = *scene.ground->map();
  try {
    return std::make_shared<sim::FloorWays>(
        map, sim::choose_places(map, start, scene.route->from(start), kPlaces, kWayClearance, seed), kWayClearance);
  } catch (const std::exception& e) {
    throw UsageError(std::string("people cannot walk here: ") + e.what());
  }
}

drive::DriveResult drive_among(const Scene& scene, const std::shared_ptr<const sim::FloorWays>& ways,
                               const Subject& subject, const Passers& passers, const std::string& mode,
                               std::uint64_t world_seed, std::uint64_t person_seed) {
  drive::DriveSetup setup = drive_setup(scene, subject, world_seed);
  setup.tracking = passers.tracking;
  sim::CrowdSetup crowd;
  crowd.ways = ways;
  crowd.people = passers.count;
  crowd.yielding = passers.yielding;
  crowd.seed = world_seed + 2;
  crowd.robot.position = {scene.start.x, scene.start.y};
  crowd.robot.radius = sim::circumscribed_radius(setup.footprint);
  setup.people = std::make_shared<sim::Crowd>(crowd);
  const Room walls = [ways](const Eigen::Vector2d& point, double /*ahead*/, double /*at_most*/) {
    return ways->wall_distance(point);
  };
  setup.person = person_among(mode, setup.parameters, room_among(setup.people, walls), person_seed);
  return drive::drive(setup);
}

}  // namespace study
}  // namespace hidwa_local_planner
