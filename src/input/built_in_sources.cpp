// SPDX-License-Identifier: BSD-3-Clause
#include "hidwa_local_planner/input/gesture_source.hpp"
#include "hidwa_local_planner/input/source_list.hpp"
#include "hidwa_local_planner/input/stick_source.hpp"
#include "hidwa_local_planner/input/twist_source.hpp"

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
