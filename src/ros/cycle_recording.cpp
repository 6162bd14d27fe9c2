// SPDX-License-Identifier: BSD-3-Clause
#include "hidwa_local_planner/ros/cycle_recording.hpp"

#include <utility>

#include "hidwa_local_planner/core/parameter_text.hpp"

namespace hidwa_local_planner {
void CycleRecording::take(const ParameterSet& set) {
  critics_ = foreign_content(set);
  demand_key();
}

void CycleRecording::begin(double now, bool wanted) {
  if (!wanted) demand_key();  // one is left out
  wanted_ = wanted;
  now_ = now;
  before_.state.clear();
}

void CycleRecording::heard(const OperatorIntent& intent, bool host_stops) {
  if (!wanted_) return;
  intent_ = intent;
  host_stops_ = host_stops;
  if (before_.revision != recorded_revision_) demand_key();
  recorded_revision_ = before_.revision;
}

void CycleRecording::open(const Planner& planner, const Polygon& outline) {
  if (recorder_.begin(now_)) {
    record::Setup setup;
    setup.version = HIDWA_VERSION;
    setup.parameters = to_lines(planner.parameters());
    setup.operator_parameters = to_lines(before_.parameters);
    if (setup.operator_parameters == setup.parameters) setup.operator_parameters.clear();
    setup.critics = critics_;
    setup.outline = outline;
    recorder_.setup(std::move(setup));
  }
  recorder_.operator_state() = before_.state;
  recorder_.intent(intent_, host_stops_);
}

void CycleRecording::plans(const Planner& planner, const Polygon& outline, const Situation& situation,
                           const GridView& grid, const Sampling& sampling) {
  if (!wanted_) return;
  open(planner, outline);
  recorder_.plans(planner, situation, grid, sampling);
}

void CycleRecording::brakes(const Planner& planner, const Polygon& outline, const FaultBrake& brake,
                            const record::BrakeInput& input) {
  if (!wanted_) return;
  open(planner, outline);
  recorder_.brakes(brake, input);
}

const Bytes& CycleRecording::finish(const CycleResult& result, const Planner& planner) {
  if (!wanted_) return nothing_;
  if (result.decision != nullptr) return recorder_.finish(record::verdict_of(*result.decision, planner.totals()));
  return recorder_.finish(record::verdict_of(result.outcome, result.command));
}

}  // namespace hidwa_local_planner
