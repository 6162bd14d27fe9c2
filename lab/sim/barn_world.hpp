// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "sim/polygon.hpp"

namespace hidwa_local_planner {
namespace sim {

/// A dense field of upright cylinders (Perille et al. 2020, "Benchmarking metric ground navigation").
struct BarnWorld {
  int index = 0;
  std::vector<Eigen::Vector2d> cylinders;  // centres [m]
  std::vector<Eigen::Vector2d> path;       // the reference path through the field [m]
};

constexpr double kBarnCylinder = 0.075;  // [m], radius
Pose barn_start();                       // of every world
Pose barn_goal();

/// Length of start, reference path and goal joined [m], as BARN's own report takes it.
double reference_length(const BarnWorld& world);

/// Reads one world a line, `index | cells a:b ... | path cells col:row ...`; lines with # are comments.
/// Throws std::runtime_error naming file, line, fault and remedy.
std::vector<BarnWorld> load_barn_worlds(const std::string& file);

}  // namespace sim
}  // namespace hidwa_local_planner
