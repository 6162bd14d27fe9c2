// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "control/control_loop.hpp"
#include "input/operator_state_machine.hpp"
#include "record/cycle_record.hpp"

namespace hidwa_local_planner {
namespace record {

/// NAME=VALUE, a parameter as people write it.
using ParameterChange = std::pair<std::string, std::string>;

/// A cycle repeated from its record.
struct ReplayedCycle {
  DecisionRecord decision;
  OperatorIntent intent;
  bool identical = false;  // to what was recorded, intent and decision
};

/// Repeats recorded cycles, each from its recorded state, by the control loop that drove the robot. With changed
/// parameters it shows what each cycle would have decided then. The robot's way, and what was remembered before the
/// cycle, stay those recorded (open loop). So do the samples in force, but vx_samples and vth_samples count where they
/// are changed.
class CycleReplay {
 public:
  /// Finds other packages' critics' parameters in a Setup's `critics`.
  using SourcesOf = std::function<Planner::SourceFor(const std::string& critics)>;

  /// `changes` count in every cycle.
  explicit CycleReplay(CriticRegistry registry, SourcesOf sources_of = {}, std::vector<ParameterChange> changes = {});
  CycleReplay(const CycleReplay&) = delete;
  CycleReplay& operator=(const CycleReplay&) = delete;

  enum class Reading { ready, waits_for_key, damaged };
  /// Takes the next record; `bytes` as encode() made them. Records between a gap and the next key record wait for it.
  Reading take(const Bytes& bytes);
  /// Why the last record was damaged, or could not be set up.
  const std::string& fault() const { return fault_; }

  /// The record taken, its costmap, and the parameters it is replayed with.
  const CycleRecord& record() const { return record_; }
  const StoredGrid& grid() const { return grid_; }
  const Parameters& parameters() const { return loop_.parameters(); }
  const Setup& setup() const { return setup_; }

  /// Repeats the record taken. `explain`: repeats it once more with Report::full, for planner().candidates().
  ReplayedCycle run(bool explain = false);
  /// What the last run() left. Null where an input was missing, so that nothing was planned.
  const Planner& planner() const { return loop_.planner(); }
  const Decision* decision() const { return decision_; }
  const Situation* situation() const { return decision_ != nullptr ? &loop_.situation() : nullptr; }

 private:
  std::string set_up(const Setup& setup);
  std::string follow();
  bool load();

  SourcesOf sources_of_;
  std::vector<ParameterChange> changes_;
  input::OperatorStateMachine machine_;
  control::ControlLoop loop_;
  std::vector<Pose2> plan_;  // that was followed before the cycle, in its own frame
  StoredGrid grid_;
  Setup setup_;
  Parameters recorded_, changed_;
  CycleRecord record_;
  std::string fault_;
  bool following_ = false;  // since a key record nothing was missing
  std::uint32_t sequence_ = 0;
  const Decision* decision_ = nullptr;
};

}  // namespace record
}  // namespace hidwa_local_planner
