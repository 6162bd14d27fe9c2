// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "robot/model.hpp"

namespace hidwa_local_planner::robot {

struct UrdfReading {
  std::optional<Model> model;
  std::string fault;    // why there is no model, and the remedy
  std::string warning;  // `base_frame` is none of its links: the root link was taken for it
};

/// Reads the text of a URDF. `base_frame`: the link that lies where the planner takes the robot to be; a
/// slash or a prefix before it does not matter. Never throws.
UrdfReading read_urdf(const std::string& text, const std::string& base_frame);

}  // namespace hidwa_local_planner::robot
