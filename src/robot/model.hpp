// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Geometry>

namespace hidwa_local_planner::robot {

/// One collision or visual geometry, in the base frame at zero joint positions.
struct Shape {
  enum class Kind { box, cylinder, sphere, mesh };
  Kind kind = Kind::mesh;
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();  // [m]; a cylinder lies along its z
  Eigen::Vector3d size = Eigen::Vector3d::Zero();          // of a box: its edges [m]
  double radius = 0.0;                                     // of a cylinder or a sphere [m]
  double length = 0.0;                                     // of a cylinder [m]
};

struct Link {
  std::string name;
  std::vector<Shape> collisions;
  std::vector<Shape> visuals;
};

enum class Turning { freely, within_bounds, not_at_all };

/// A joint, in the base frame at zero joint positions.
struct Joint {
  std::string name;
  std::size_t child = 0;  // the index of the link that it moves
  Turning turning = Turning::not_at_all;
  bool fixed_to_base = false;                          // only fixed joints lie between it and the root
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  // [m]
  Eigen::Vector3d axis = Eigen::Vector3d::Zero();      // of length 1, zero where none is given
  std::optional<double> max_velocity;                  // [rad/s]; nothing where it has no limit
};

/// What a URDF says of a robot, as far as the planner needs it.
struct Model {
  std::string base;  // the link whose frame everything is in
  std::vector<Link> links;
  std::vector<Joint> joints;
};

}  // namespace hidwa_local_planner::robot
