// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include <costmap_2d/costmap_2d_ros.h>
#include <ros/node_handle.h>

#include "hidwa_local_planner/core/parameters.hpp"
#include "robot/outline.hpp"
#include "robot/wheel_limits.hpp"
#include "robot/wheels.hpp"

namespace hidwa_local_planner {

/// What the robot's URDF on the parameter server says of its limits and its outline. Its faults are logged once, and
/// the parameters' own limits hold. Not thread-safe.
class RobotDescription {
 public:
  /// `handle`: the planner's namespace, from which the URDF is searched upwards. `base_frame`: the costmap's
  /// robot_base_frame.
  RobotDescription(const ros::NodeHandle& handle, const std::string& base_frame);

  /// The parameters with the tighter limit of both, the URDF's wheels and their own. Reads the URDF when one
  /// of the parameters that name it or its joints has changed.
  Parameters limited(const Parameters& wanted);

  /// Where neither footprint nor robot_radius was set for the costmap, or its footprint is empty: gives it the
  /// outline of the URDF's collision geometry if that is `wanted`, else says that it could. An outline that
  /// leaves out meshes may be too small and is not given.
  void give_outline(costmap_2d::Costmap2DROS& costmap, bool wanted) const;

 private:
  using Names = std::array<std::string, 3>;  // of the parameter and of both joints

  void read(const Names& names);
  std::optional<std::string> text(const std::string& parameter) const;
  void find_wheels(const robot::Model& model, const Names& names);
  void complain(const std::string& fault) const;
  void say(const std::vector<robot::Remark>& remarks);

  const ros::NodeHandle handle_;
  const std::string base_frame_;
  std::optional<Names> names_;  // read last
  std::optional<robot::Wheels> wheels_;
  std::optional<robot::Outline> outline_;
  std::vector<std::string> said_;  // subjects of the last remarks
};

}  // namespace hidwa_local_planner
