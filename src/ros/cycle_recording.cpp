// SPDX-License-Identifier: BSD-3-Clause
#include "hidwa_local_planner/ros/cycle_recording.hpp"

namespace hidwa_local_planner {

Bytes* CycleRecording::begin(bool wanted) {
  wanted_ = wanted;
  if (wanted) return &recorder_.operator_state();
  demand_key();  // a cycle is left out
  return nullptr;
}

}  // namespace hidwa_local_planner
