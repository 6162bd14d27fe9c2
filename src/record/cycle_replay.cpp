// SPDX-License-Identifier: BSD-3-Clause
#include "record/cycle_replay.hpp"

#include <utility>

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

CycleReplay::CycleReplay(CriticRegistry registry, SourcesOf sources_of, std::vector<ParameterChange> changes)
    : sources_of_(std::move(sources_of)), changes_(std::move(changes)), loop_(std::move(registry)) {}

// Parameters that this release does not know are a fault: without them a cycle would not be the same.
std::string CycleReplay::set_up(const Setup& setup) {
  recorded_ = Parameters();
  std::vector<std::string> faults = set_lines(recorded_, setup.parameters);
  changed_ = recorded_;
  for (const std::string& fault : make_changes(changed_, changes_)) faults.push_back(fault);
  if (faults.empty()) {
    const Planner::SourceFor sources = sources_of_ ? sources_of_(setup.critics) : Planner::SourceFor();
    faults = loop_.configure(changed_, sources);
  }
  loop_.set_footprint(setup.outline);
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
    fault_ = set_up(*record_.setup);
    grid_ = StoredGrid();
  } else if (!following_ || record_.sequence != sequence_ + 1) {
    return give_up(Reading::waits_for_key);
  }
  if (fault_.empty()) fault_ = follow();
  if (!fault_.empty()) return give_up(Reading::damaged);
  following_ = true;
  sequence_ = record_.sequence;
  return Reading::ready;
}

// Goes from the record before to this one.
std::string CycleReplay::follow() {
  if (record_.plan) plan_ = *record_.plan;
  if (record_.costmap && !unpack(*record_.costmap, grid_)) return "the costmap in the record is damaged";
  if (!load()) return "the state before the cycle cannot be read: replay it with release " + setup_.version;
  return "";
}

// With changed parameters the operator takes them as in a drive: another mode, say, begins afresh.
bool CycleReplay::load() {
  machine_.configure(recorded_);
  ArchiveReader state(record_.operator_state);
  machine_.load(state);
  if (!changes_.empty()) machine_.configure(changed_);
  loop_.restore_plan(plan_);
  return loop_.load(record_.loop_state) && state.complete();
}

ReplayedCycle CycleReplay::run(bool explain) {
  load();
  control::Observation observation = record_.observation;
  observation.costmap = grid_.view();
  Sampling sampling = record_.sampling;
  if (changes_samples(changes_, "vx_samples")) sampling.vx_samples = 0;
  if (changes_samples(changes_, "vth_samples")) sampling.vth_samples = 0;
  const OperatorIntent intent = machine_.update(observation.timing.now);
  control::Result result = loop_.step(observation, intent, sampling);
  ReplayedCycle cycle{decision_record(result, loop_.planner()), result.intent, false};
  if (explain) {
    // Not at once: more is known of who rejects what then, and so the digest is another.
    sampling.report = Report::full;
    load();
    result = loop_.step(observation, intent, sampling);
  }
  decision_ = result.decision;
  cycle.identical = hidwa_local_planner::record::identical(cycle.intent, record_.intent) &&
                    hidwa_local_planner::record::identical(cycle.decision, record_.decision);
  return cycle;
}

}  // namespace record
}  // namespace hidwa_local_planner
