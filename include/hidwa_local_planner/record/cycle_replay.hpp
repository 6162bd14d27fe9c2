// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "hidwa_local_planner/control/fault_brake.hpp"
#include "hidwa_local_planner/core/planner.hpp"
#include "hidwa_local_planner/input/operator_state_machine.hpp"
#include "hidwa_local_planner/record/cycle_record.hpp"

namespace hidwa_local_planner {
namespace record {

/// NAME=VALUE, a parameter as people write it.
using ParameterChange = std::pair<std::string, std::string>;

/// A cycle repeated from its record.
struct ReplayedCycle {
  Verdict verdict;
  OperatorIntent intent;
  bool identical = false;  // to what was recorded, intent and verdict
};

/// Repeats recorded cycles, each from its recorded state: the operator machine says what the person wants, the planner
/// decides. With changed parameters it shows what each cycle would have decided then; the robot's way, its latches, the
/// window of the plan and the samples stay those recorded (open loop), but vx_samples and vth_samples count where they
/// are changed.
class CycleReplay {
 public:
  /// Finds other packages' critics' parameters in a Setup's `critics`.
  using SourcesOf = std::function<Planner::SourceFor(const std::string& critics)>;

  explicit CycleReplay(CriticRegistry registry, SourcesOf sources_of = {});
  /// In force from the next key record on.
  void change(std::vector<ParameterChange> changes) { changes_ = std::move(changes); }

  enum class Reading { ready, waits_for_key, damaged };
  /// Takes the next record; `bytes` as encode() made them. Records between a gap and the next key record wait for it.
  Reading take(const Bytes& bytes);
  /// Why the last record was damaged, or could not be set up.
  const std::string& fault() const { return fault_; }

  /// The record taken, its costmap, and the parameters it is replayed with.
  const CycleRecord& record() const { return record_; }
  const StoredGrid& grid() const { return grids_.present(); }
  const Parameters& parameters() const { return planner_.parameters(); }
  const Setup& setup() const { return setup_; }

  /// Repeats the record taken.
  ReplayedCycle run();
  /// With what the last run() left in it.
  Planner& planner() { return planner_; }
  const Decision* decision() const { return decision_; }

 private:
  std::string set_up(const Setup& setup);

  SourcesOf sources_of_;
  std::vector<ParameterChange> changes_;
  Planner planner_;
  input::OperatorStateMachine machine_;
  FaultBrake fault_brake_;
  GridChain grids_;
  Setup setup_;
  Parameters recorded_operator_, changed_operator_;  // the machine's, before and after changes
  CycleRecord record_;
  std::string fault_;
  bool following_ = false;  // since a key record nothing was missing
  std::uint32_t sequence_ = 0;
  const Decision* decision_ = nullptr;
};

}  // namespace record
}  // namespace hidwa_local_planner
