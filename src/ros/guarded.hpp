// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <exception>
#include <utility>

#include <ros/console.h>

namespace hidwa_local_planner {

/// Runs `call` of the plugin `who`. If it throws, logs that and returns `otherwise`, since no host expects exceptions.
template <typename Answer, typename Call>
Answer guarded(const char* who, const char* what, Answer otherwise, Call call) {
  try {
    return call();
  } catch (const std::exception& error) {
    ROS_ERROR_THROTTLE(1.0, "%s: %s failed: %s", who, what, error.what());
  } catch (...) {
    ROS_ERROR_THROTTLE(1.0, "%s: %s failed", who, what);
  }
  return otherwise;
}

}  // namespace hidwa_local_planner
