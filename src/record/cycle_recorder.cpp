// SPDX-License-Identifier: BSD-3-Clause
#include "hidwa_local_planner/record/cycle_recorder.hpp"

namespace hidwa_local_planner {
namespace record {

bool CycleRecorder::begin(double time) {
  const bool key = cycles_since_key_ >= kKeyEvery;
  cycles_since_key_ = key ? 1 : cycles_since_key_ + 1;
  if (key) grids_.clear();
  record_.sequence = ++sequence_;
  record_.setup.reset();
  record_.time = time;
  record_.operator_state.clear();
  record_.planned.reset();
  record_.braked.reset();
  return key;
}

void CycleRecorder::plans(const Planner& planner, const Situation& situation, const GridView& grid,
                          const Sampling& sampling) {
  PlannerInput& input = record_.planned.emplace();
  planner.save(input.state);
  input.situation = situation;
  input.sampling = sampling;
  input.grid = grids_.advance_to(grid, grids_.present().costs.empty());
}

void CycleRecorder::brakes(const FaultBrake& brake, const BrakeInput& input) {
  record_.braked = input;
  ArchiveWriter write(record_.braked->state);
  write(brake);
}

const Bytes& CycleRecorder::finish(const Verdict& verdict) {
  record_.verdict = verdict;
  encode(record_, bytes_);
  return bytes_;
}

}  // namespace record
}  // namespace hidwa_local_planner
