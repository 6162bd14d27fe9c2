// SPDX-License-Identifier: BSD-3-Clause
#include "study/barn_drive.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <memory>

#include <yaml-cpp/yaml.h>

#include "study/bystander.hpp"
#include "study/error.hpp"
#include "study/jackal.hpp"
#include "study/table.hpp"

namespace hidwa_local_planner {
namespace study {
namespace {

// BARN's rules (Daffan/the-barn-challenge: run.py, report_test.py).
constexpr double kGoalRadius = 1.0;    // [m]
constexpr double kTimeLimit = 100.0;   // [s]
constexpr double kOptimalSpeed = 2.0;  // [m/s]

// The field, its start and its goal, with some room around: what the global plan may use.
sim::OccupancyMap field(double resolution) {
  constexpr double kLeft = -5.0, kBottom = -0.5, kWidth = 5.5, kHeight = 15.0;  // [m]
  return sim::make_map(static_cast<int>(std::lround(kWidth / resolution)),
                       static_cast<int>(std::lround(kHeight / resolution)), resolution, kLeft, kBottom);
}

struct Entry {
  std::function<double&(BarnSubject&)> member;
  double least, greatest;
};

// What of the costmaps may be set, as it is called in barn.yaml and by --set.
const std::map<std::string, Entry>& entries() {
  static const std::map<std::string, Entry> all{
      {"costmap.width", {[](BarnSubject& s) -> double& { return s.costmap.width; }, 1.0, 50.0}},
      {"costmap.resolution", {[](BarnSubject& s) -> double& { return s.costmap.resolution; }, 0.01, 0.2}},
      {"costmap.footprint_padding", {[](BarnSubject& s) -> double& { return s.padding; }, 0.0, 0.5}},
      {"costmap.inflation_radius",
       {[](BarnSubject& s) -> double& { return s.costmap.inflation.inflation_radius; }, 0.0, 5.0}},
      {"costmap.cost_scaling_factor",
       {[](BarnSubject& s) -> double& { return s.costmap.inflation.cost_scaling_factor; }, 0.1, 100.0}},
      {"plan.resolution", {[](BarnSubject& s) -> double& { return s.plan_resolution; }, 0.01, 0.2}},
      {"plan.robot_radius", {[](BarnSubject& s) -> double& { return s.plan_radius; }, 0.0, 1.0}},
  };
  return all;
}

bool is_entry(const std::string& name) {
  return name.compare(0, 8, "costmap.") == 0 || name.compare(0, 5, "plan.") == 0;
}

void assign_entry(BarnSubject& subject, const std::string& name, const std::string& text) {
  const auto found = entries().find(name);
  if (found == entries().end()) {
    std::string known;
    for (const auto& entry : entries()) known += " " + entry.first;
    throw UsageError("there is no " + name + ": there are" + known);
  }
  const auto& [member, least, greatest] = found->second;
  member(subject) = number_within(name, text, least, greatest);
}

}  // namespace

const std::vector<std::string>& barn_modes() {
  static const std::vector<std::string> modes{"AUTONOMY", "HELPFUL", "HOSTILE", "AFTERMATH"};
  return modes;
}

std::vector<std::string> usual_barn_modes() { return {"AUTONOMY", "HELPFUL", "HOSTILE"}; }

BarnSubject barn_subject(const std::string& jackal_file, const std::string& barn_file) {
  BarnSubject subject;
  assign_file(subject.subject.parameters, jackal_file);
  assign_file(subject.subject.parameters, barn_file);
  try {
    const YAML::Node file = YAML::LoadFile(barn_file);
    for (const std::string section : {"costmap", "plan"}) {
      for (const auto& entry : file[section]) {
        assign_entry(subject, section + "." + entry.first.as<std::string>(), entry.second.as<std::string>());
      }
    }
  } catch (const YAML::Exception& e) {
    throw UsageError("'" + barn_file + "' cannot be read: " + e.what());
  }
  return subject;
}

void assign_barn(BarnSubject& subject, const Assignment& assignment) {
  const std::string& name = assignment.name;
  if (name == "mode") throw UsageError("mode is what --mode says: AUTONOMY, HELPFUL, HOSTILE, AFTERMATH");
  if (name.compare(0, 12, "participant.") == 0)
    throw UsageError(name + " is for run, pilot and sweep: barn has no participants");
  if (is_entry(name)) {
    assign_entry(subject, name, assignment.value);
  } else {
    assign(subject.subject, assignment);
  }
}

drive::DriveResult drive_barn(const sim::BarnWorld& world, const BarnSubject& subject, const std::string& mode,
                              std::uint64_t world_seed, std::uint64_t person_seed) {
  const auto discs = std::make_shared<sim::DiscField>(world.cylinders, sim::kBarnCylinder);
  drive::DriveSetup setup = jackal(subject);
  setup.ground =
      std::make_shared<drive::Ground>(std::make_shared<sim::OccupancyMap>(field(subject.plan_resolution)), discs);
  setup.start = sim::barn_start();
  setup.goal = sim::barn_goal();
  setup.explore = true;
  const Room room = [discs](const Eigen::Vector2d& point, double /*ahead*/, double at_most) {
    return discs->distance(point, at_most);
  };
  setup.person = person_among(mode, setup.parameters, room, person_seed);
  setup.odometry_seed = world_seed;
  setup.laser_seed = world_seed + 1;
  setup.goal_radius = kGoalRadius;
  setup.end_at_contact = true;
  setup.patience = setup.time_limit = kTimeLimit;
  return drive::drive(setup);
}

BarnScore score_barn(const sim::BarnWorld& world, const drive::DriveResult& result) {
  BarnScore score;
  score.success = result.arrived && result.contacts == 0;
  score.optimal_time = sim::reference_length(world) / kOptimalSpeed;
  if (score.success) {
    score.metric = score.optimal_time / std::clamp(result.duration, 2.0 * score.optimal_time, 8.0 * score.optimal_time);
  }
  const sim::DiscField discs(world.cylinders, sim::kBarnCylinder);
  constexpr double kFar = 5.0;  // [m]
  for (const Eigen::Vector2d& point : world.path) {
    score.path_clearance += discs.distance(point, kFar) / static_cast<double>(world.path.size());
  }
  return score;
}

}  // namespace study
}  // namespace hidwa_local_planner
