// SPDX-License-Identifier: BSD-3-Clause
#include "study/dynabarn_drive.hpp"

#include "sim/random.hpp"
#include "study/bystander.hpp"
#include "study/jackal.hpp"

namespace hidwa_local_planner {
namespace study {
namespace {

constexpr double kNearGoal = 1.0;        // [m]
constexpr double kLongestDrive = 100.0;  // [s]
constexpr double kLatestRelease = 20.0;  // [s]

}  // namespace

// The global plan knows the court's walls, and nothing of the cylinders.
DynabarnCourt::DynabarnCourt(const BarnSubject& subject, drive::Tracking tracking, sim::KeyMotion motion)
    : setup_(jackal(subject)), motion_(motion) {
  setup_.ground = std::make_shared<drive::Ground>(
      std::make_shared<sim::OccupancyMap>(sim::dynabarn_court(subject.plan_resolution)));
  setup_.start = sim::dynabarn_start();
  setup_.goal = sim::dynabarn_goal();
  setup_.tracking = tracking;
  setup_.goal_radius = kNearGoal;
  setup_.end_at_contact = true;
  setup_.patience = setup_.time_limit = kLongestDrive;
  setup_.route = drive::make_route(setup_);
}

drive::DriveResult DynabarnCourt::drive(const sim::DynabarnWorld& world, const std::string& mode, double release,
                                        std::uint64_t world_seed, std::uint64_t person_seed) const {
  drive::DriveSetup setup = setup_;
  setup.people = sim::dynabarn_people(world, motion_, release);
  setup.person = person_among(mode, setup.parameters, room_among(setup.people, {}), person_seed);
  setup.odometry_seed = world_seed;
  setup.laser_seed = world_seed + 1;
  return drive::drive(setup);
}

double release_time(std::uint64_t world_seed) { return kLatestRelease * sim::Random(world_seed).uniform(); }

}  // namespace study
}  // namespace hidwa_local_planner
