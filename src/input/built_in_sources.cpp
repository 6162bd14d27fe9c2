// SPDX-License-Identifier: BSD-3-Clause
#include "input/gesture_source.hpp"
#include "input/source_list.hpp"
#include "input/stick_source.hpp"
#include "input/twist_source.hpp"

namespace hidwa_local_planner::input {

// The last one that can steer does. The stick comes first: it always can.
Sources built_in_sources() {
  Sources sources;
  sources.push_back(std::make_unique<StickSource>());
  sources.push_back(std::make_unique<TwistSource>());
  sources.push_back(std::make_unique<GestureSource>());
  return sources;
}

}  // namespace hidwa_local_planner::input
