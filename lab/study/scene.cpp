// SPDX-License-Identifier: BSD-3-Clause
#include "study/scene.hpp"

#include <exception>

#include "drive/outline.hpp"
#include "sim/avoiding_operator.hpp"
#include "sim/contact.hpp"
#include "study/error.hpp"
#include "study/takeover_person.hpp"

namespace hidwa_local_planner {
namespace study {
namespace {

// Of urdf/telepresence_base.urdf and launch/params.
constexpr double kRadius = 0.30;             // [m], what planner and costmap take it for
constexpr double kPadding = 0.01;            // [m]
constexpr double kWheelSeparation = 0.4044;  // [m]
constexpr double kWheelSpeed = 0.788;        // [m/s], a radius of 0.0985 m x 8 rad/s
constexpr double kLatency = 0.05;            // [s], of the base
constexpr double kLaserNoise = 0.01;         // [m]
constexpr double kSlip = 0.01;               // of the odometry

drive::DriveSetup telepresence_base() {
  drive::DriveSetup robot;
  robot.footprint = drive::telepresence_footprint();
  robot.outline = drive::circle_outline(kRadius, kPadding);
  robot.limits.wheel_separation = kWheelSeparation;
  robot.limits.max_wheel_speed = kWheelSpeed;
  robot.limits.latency = kLatency;
  robot.laser.noise = kLaserNoise;
  robot.odometry_noise.slip_x = robot.odometry_noise.slip_theta = kSlip;
  robot.keep_samples = true;
  return robot;
}

sim::RobotHabits learnt_habits(const Subject& subject) {
  const Parameters& p = subject.parameters;
  sim::RobotHabits habits;
  habits.max_vel_x = p.max_vel_x;
  habits.max_vel_theta = p.max_vel_theta;
  habits.acc_lim_theta = p.acc_lim_theta;
  habits.radius = sim::circumscribed_radius(drive::telepresence_footprint());
  habits.dead_zone = p.dead_zone;
  habits.refusal_time = p.sim_time;
  // After a release it goes straight on: for delta, or in SW until control is given back.
  const Participant& person = subject.participant;
  habits.hold_time = p.mode == OperatorMode::switching ? person.give_back_pause + person.button_time : p.delta;
  return habits;
}

sim::OperatorTraits steering_traits(const Subject& subject) {
  const Participant& person = subject.participant;
  sim::OperatorTraits traits;
  traits.reaction_time = person.reaction_time;
  traits.decision_period = person.decision_period;
  traits.look_ahead = person.look_ahead;
  traits.region_margin = person.region_margin;
  traits.release_margin = person.release_margin;
  traits.stick_noise = person.stick_noise;
  if (subject.parameters.mode == OperatorMode::gesture) {
    traits.stick_noise = person.hand_noise / subject.parameters.gesture_range;
  }
  return traits;
}

void check_place(const Scene& scene, const sim::Pose& pose, const char* name) {
  const sim::OccupancyMap& map = *scene.ground->map();
  const bool inside = map.inside(map.column(pose.x), map.row(pose.y));
  if (!inside || sim::overlaps_occupied(map, sim::transformed(drive::telepresence_footprint(), pose))) {
    throw UsageError(std::string("the robot does not fit at its ") + name + ": choose another by --" + name +
                     " x,y,yaw");
  }
}

}  // namespace

Scene load_scene(const std::string& map, const std::string& regions, const std::optional<sim::Pose>& start,
                 const std::optional<sim::Pose>& goal) {
  Scene scene;
  sim::RegionsFile file;
  try {
    scene.ground = std::make_shared<drive::Ground>(std::make_shared<sim::OccupancyMap>(sim::load_map(map)));
    if (regions != "none") file = sim::load_regions(regions);
  } catch (const std::exception& e) {
    throw UsageError(e.what());
  }
  if (!start && !file.start) throw UsageError("there is no start: give --start x,y,yaw, or in the regions file");
  if (!goal && !file.goal) throw UsageError("there is no goal: give --goal x,y,yaw, or in the regions file");
  scene.start = start ? *start : *file.start;
  scene.goal = goal ? *goal : *file.goal;
  scene.regions = file.regions;
  check_place(scene, scene.start, "start");
  check_place(scene, scene.goal, "goal");
  scene.robot = telepresence_base();
  drive::DriveSetup way = scene.robot;
  way.ground = scene.ground;
  way.goal = scene.goal;
  scene.route = drive::make_route(way);
  if (scene.route->from({scene.start.x, scene.start.y}).empty()) {
    throw UsageError("there is no way from the start to the goal: choose others by --start and --goal");
  }
  return scene;
}

drive::DriveSetup drive_setup(const Scene& scene, const Subject& subject, std::uint64_t world_seed) {
  drive::DriveSetup setup = scene.robot;
  setup.ground = scene.ground;
  setup.route = scene.route;
  setup.start = scene.start;
  setup.goal = scene.goal;
  setup.parameters = subject.parameters;
  setup.link_delay = subject.link_delay;
  setup.odometry_seed = world_seed;
  setup.laser_seed = world_seed + 1;
  return setup;
}

Driven drive_once(const Scene& scene, const Subject& subject, std::uint64_t world_seed, std::uint64_t person_seed) {
  drive::DriveSetup setup = drive_setup(scene, subject, world_seed);
  setup.regions = scene.regions;
  setup.person = std::make_shared<sim::AvoidingOperator>(steering_traits(subject), learnt_habits(subject),
                                                         *scene.ground->map(), scene.regions, person_seed);
  std::shared_ptr<TakeoverPerson> takeover;
  if (subject.parameters.mode == OperatorMode::switching) {
    takeover = std::make_shared<TakeoverPerson>(subject.participant, person_seed + 1);
    setup.device = takeover;
  } else {
    const bool by_hand = subject.parameters.mode == OperatorMode::gesture;
    setup.device = sim::make_operator_device(by_hand ? "gesture" : "joystick", subject.parameters.gesture_range);
  }
  Driven driven;
  driven.result = drive::drive(setup);
  if (takeover) driven.errors = takeover->errors();
  return driven;
}

}  // namespace study
}  // namespace hidwa_local_planner
