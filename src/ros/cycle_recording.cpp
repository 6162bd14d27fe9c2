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
  before_.clear();
}

void CycleRecording::heard(const OperatorIntent& intent, bool host_stops) {
  intent_ = intent;
  host_stops_ = host_stops;
}

void CycleRecording::open(const Planner& planner) {
  if (recorder_.begin(now_)) {
    record::Setup setup;
    setup.version = HIDWA_VERSION;
    setup.parameters = to_lines(planner.parameters());
    setup.critics = critics_;
    setup.outline = planner.outline();
    recorder_.setup(std::move(setup));
  }
  recorder_.operator_state() = before_;
  recorder_.intent(intent_, host_stops_);
}

void CycleRecording::plans(const Planner& planner, const Situation& situation, const GridView& costmap,
                           const Sampling& sampling) {
  if (!wanted_) return;
  open(planner);
  recorder_.plans(planner, situation, costmap, sampling);
}

void CycleRecording::brakes(const Planner& planner, const FaultBrake& brake, const control::BrakeSituation& situation) {
  if (!wanted_) return;
  open(planner);
  recorder_.brakes(brake, {{}, situation.velocity, situation.last_command, situation.period, situation.fault});
}

const Bytes& CycleRecording::finish(const CycleResult& result, const Planner& planner) {
  if (!wanted_) return nothing_;
  if (result.decision != nullptr) return recorder_.finish(record::verdict_of(*result.decision, planner.totals()));
  return recorder_.finish(record::verdict_of(result.outcome, result.command));
}

}  // namespace hidwa_local_planner
