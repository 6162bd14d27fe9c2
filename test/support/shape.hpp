// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <ros/serialization.h>
#include <topic_tools/shape_shifter.h>

namespace hidwa_local_planner::test {

/// What a subscription to any type hands over: these bytes, said to be of this type with this sum.
inline topic_tools::ShapeShifter shape_of(std::vector<std::uint8_t> bytes, const std::string& type,
                                          const std::string& sum, const std::string& definition = "") {
  topic_tools::ShapeShifter shape;
  shape.morph(sum, type, definition, "");
  if (bytes.empty()) return shape;  // to read none, it would copy from null
  ros::serialization::IStream stream(bytes.data(), static_cast<std::uint32_t>(bytes.size()));
  shape.read(stream);
  return shape;
}

}  // namespace hidwa_local_planner::test
