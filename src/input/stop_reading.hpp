// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "input/operator_message.hpp"

namespace hidwa_local_planner::input {

/// What a message says about stopping, in so far as it can be read, whatever else is wrong with it.
struct StopReading {
  bool button = false;         // the stop button is pressed
  std::optional<double> back;  // the stick is pulled back so far, about [-1, 1]; none where that means no stop
  DeviceShape shape;
};

}  // namespace hidwa_local_planner::input
