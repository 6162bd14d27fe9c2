// SPDX-License-Identifier: BSD-3-Clause
#include "hidwa_local_planner/record/cycle_replay.hpp"

#include <exception>

#include "core/util/words.hpp"
#include "hidwa_local_planner/core/parameter_text.hpp"

namespace hidwa_local_planner {
namespace record {
namespace {

std::vector<std::string> make_changes(Parameters& parameters, const std::vector<ParameterChange>& changes) {
  std::vector<std::string> faults;
  for (const auto& [name, value] : changes) {
    const std::string fault = set_parameter_text(parameters, name, value);
    if (!fault.empty()) faults.push_back(fault);
  }
  return faults;
}

bool changes_samples(const std::vector<ParameterChange>& changes, const char* axis) {
  for (const ParameterChange& change : changes) {
    if (change.first == axis) return true;
  }
  return false;
}

}  // namespace

CycleReplay::CycleReplay(CriticRegistry registry, SourcesOf sources_of)
    : sources_of_(std::move(sources_of)), planner_(std::move(registry)) {}

// Parameters that this release does not know are a fault: without them a cycle would not be the same.
std::string CycleReplay::set_up(const Setup& setup) {
  Parameters parameters;
  std::vector<std::string> faults = set_lines(parameters, setup.parameters);
  recorded_operator_ = parameters;
  if (!setup.operator_parameters.empty()) set_lines(recorded_operator_, setup.operator_parameters);
  changed_operator_ = recorded_operator_;
  make_changes(changed_operator_, changes_);
  for (const std::string& fault : make_changes(parameters, changes_)) faults.push_back(fault);
  if (faults.empty()) {
    const Planner::SourceFor sources = sources_of_ ? sources_of_(setup.critics) : Planner::SourceFor();
    try {
      faults = planner_.configure(parameters, sources);
    } catch (const std::exception& error) {
      faults = {std::string("critics: one of them does not take its parameters: ") + error.what()};
    }
  }
  planner_.set_footprint(setup.outline);
  setup_ = setup;
  return joined(faults);
}

CycleReplay::Reading CycleReplay::take(const Bytes& bytes) {
  const auto give_up = [this](Reading reading) {
    following_ = false;
    return reading;
  };
  fault_ = decode(bytes, record_);
  if (!fault_.empty()) return give_up(Reading::damaged);
  if (record_.setup) {
    grids_.clear();
    fault_ = set_up(*record_.setup);
    if (!fault_.empty()) return give_up(Reading::damaged);
    following_ = true;
  } else if (!following_ || record_.sequence != sequence_ + 1) {
    return give_up(Reading::waits_for_key);
  }
  sequence_ = record_.sequence;
  if (record_.planned && !grids_.advance_by(record_.planned->grid)) {
    fault_ = "the costmap in the record is damaged";
    return give_up(Reading::damaged);
  }
  return Reading::ready;
}

ReplayedCycle CycleReplay::run(bool explain) {
  decision_ = nullptr;
  machine_.configure(recorded_operator_);
  ArchiveReader state(record_.operator_state);
  machine_.load(state);
  if (!changes_.empty()) machine_.configure(changed_operator_);
  ReplayedCycle cycle;
  cycle.intent = machine_.update(record_.time);
  OperatorIntent intent = cycle.intent;
  if (record_.host_stops) intent.influence = Influence::stop;
  if (record_.planned) {
    const PlannerInput& input = *record_.planned;
    Sampling sampling = input.sampling;
    if (changes_samples(changes_, "vx_samples")) sampling.vx_samples = 0;
    if (changes_samples(changes_, "vth_samples")) sampling.vth_samples = 0;
    const auto plan = [&](Report report) -> const Decision& {
      sampling.report = report;
      planner_.load(input.state);
      return planner_.plan(input.situation, grids_.present().view(), intent, sampling);
    };
    decision_ = &plan(input.sampling.report);
    cycle.verdict = verdict_of(*decision_, planner_.totals());
    // Not at once: more is known of who rejects what, and so the digest is another.
    if (explain) decision_ = &plan(Report::full);
  } else if (record_.braked) {
    const BrakeInput& input = *record_.braked;
    ArchiveReader read(input.state);
    read(fault_brake_);
    const FaultBrake::Answer answer =
        fault_brake_.answer(record_.time, input.velocity, input.last_command, planner_.parameters(), input.period);
    cycle.verdict = verdict_of(outcome_of(answer, intent), answer.command);
  }
  cycle.identical = hidwa_local_planner::record::identical(cycle.intent, record_.intent) &&
                    hidwa_local_planner::record::identical(cycle.verdict, record_.verdict);
  return cycle;
}

}  // namespace record
}  // namespace hidwa_local_planner
