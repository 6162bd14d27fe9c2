// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace hidwa_local_planner::input {

/// One message of a stick, as plain values.
struct StickMessage {
  std::vector<float> axes;   // in [-1, 1]
  std::vector<int> buttons;  // 0 or 1
  double stamp = 0.0;        // header stamp [s]; 0 where the sender leaves it empty
  double received = 0.0;     // when it arrived [s]
  std::string sender = {};   // who sent it, where known: another sender is a new device
};

}  // namespace hidwa_local_planner::input
