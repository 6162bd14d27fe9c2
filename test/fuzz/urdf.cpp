// SPDX-License-Identifier: BSD-3-Clause
// A URDF: it is refused in words, or what is read of it are finite limits and a finite outline.
#include <algorithm>
#include <cstdint>
#include <string>

#include "fuzz/input.hpp"
#include "fuzz/require.hpp"
#include "hidwa_local_planner/core/footprint.hpp"
#include "robot/outline.hpp"
#include "robot/urdf_reading.hpp"
#include "robot/wheel_limits.hpp"

namespace hidwa_local_planner::fuzz {
namespace {

// tinyxml2 and urdfdom go down the tree by calling themselves: a text of so many elements is left to them.
constexpr std::ptrdiff_t kMostElements = 2000;

void require_limits(const robot::Wheels& wheels) {
  const Parameters wanted;
  const robot::LimitedParameters limited = robot::limited(wanted, wheels);
  for (const robot::Remark& remark : limited.remarks) require(!remark.text.empty(), "a remark without words");
  const Parameters& p = limited.parameters;
  require(validate(p).empty(), "the URDF makes valid parameters invalid");
  require(p.max_vel_x <= wanted.max_vel_x && p.max_vel_theta <= wanted.max_vel_theta, "the URDF loosens a limit");
}

void read(const std::string& text) {
  const robot::UrdfReading reading = robot::read_urdf(text, "base_link");
  require(reading.model.has_value() != !reading.fault.empty(), "neither a model nor a fault, or both");
  if (!reading.model) return;
  const robot::Outline outline = robot::outline_of(*reading.model);
  require(outline.corners.empty() != outline.fault.empty(), "neither an outline nor a fault, or both");
  for (const Point& corner : outline.corners) require(corner.allFinite(), "a corner is not a number");
  Footprint::from_outline(outline.corners, 0.01).fault();
  const robot::WheelSearch search = robot::find_wheels(*reading.model, "", "");
  require(search.wheels.has_value() != !search.fault.empty(), "neither wheels nor a fault, or both");
  if (search.wheels) require_limits(*search.wheels);
  for (const robot::Joint& joint : reading.model->joints) {
    const robot::WheelSearch named = robot::find_wheels(*reading.model, joint.name, joint.name);
    require(named.wheels.has_value() != !named.fault.empty(), "neither wheels nor a fault, or both");
  }
}

}  // namespace
}  // namespace hidwa_local_planner::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace hidwa_local_planner::fuzz;
  const std::string text = Input(data, size).rest();
  if (std::count(text.begin(), text.end(), '<') > kMostElements) return 0;
  read(text);
  return 0;
}
