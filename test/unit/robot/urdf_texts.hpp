// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace hidwa_local_planner::robot {

/// A <joint> at `origin` ("x y z") turned by `rpy`, with anything more inside it.
inline std::string joint_text(const std::string& name, const std::string& type, const std::string& parent,
                              const std::string& child, const std::string& origin, const std::string& rpy = "0 0 0",
                              const std::string& inside = "") {
  return "<joint name='" + name + "' type='" + type + "'><parent link='" + parent + "'/><child link='" + child +
         "'/><origin xyz='" + origin + "' rpy='" + rpy + "'/>" + inside + "</joint>";
}

/// A <link> with one collision geometry.
inline std::string link_text(const std::string& name, const std::string& geometry, const std::string& rpy = "0 0 0",
                             const std::string& xyz = "0 0 0") {
  return "<link name='" + name + "'><collision><origin xyz='" + xyz + "' rpy='" + rpy + "'/><geometry>" + geometry +
         "</geometry></collision></link>";
}

inline const std::string kAxisY = "<axis xyz='0 1 0'/>";
inline const std::string kAcross = "1.5707963268 0 0";  // turns a cylinder's z into y

inline std::string limit_text(const std::string& velocity) { return "<limit effort='6' velocity='" + velocity + "'/>"; }

/// A wheel on a continuous joint about y at (x, y, 0.0985), below `parent`.
inline std::string wheel_text(const std::string& side, const std::string& x, const std::string& y,
                              const std::string& limit, const std::string& geometry,
                              const std::string& parent = "base_link") {
  return joint_text(side + "_joint", "continuous", parent, side, x + " " + y + " 0.0985", "0 0 0", kAxisY + limit) +
         link_text(side, geometry, kAcross);
}

inline std::string tyre(const std::string& radius) { return "<cylinder radius='" + radius + "' length='0.04'/>"; }

/// Two wheels with the published numbers of PMB-2, unless told otherwise, and whatever else there is.
inline std::string base_text(const std::string& limit = limit_text("10.152"), const std::string& wheel = tyre("0.0985"),
                             const std::string& more = "") {
  return "<?xml version='1.0'?><robot name='base'><link name='base_link'/>" +
         wheel_text("wheel_left", "0", "0.2022", limit, wheel) +
         wheel_text("wheel_right", "0", "-0.2022", limit, wheel) + more + "</robot>";
}

}  // namespace hidwa_local_planner::robot
