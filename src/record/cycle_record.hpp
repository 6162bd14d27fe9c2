// One control cycle as bytes: the arguments of ControlLoop::step(), all that it depends on besides, and what it came
// to. Replay gives the same to the same function.
//
// The bytes are the format's number and the members of CycleRecord, one behind the other (archive.hpp).
//
// The whole plan takes less than its window in each cycle: it comes about once a second, and a window is a tenth of it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "control/control_loop.hpp"
#include "hidwa_local_planner/core/operator_intent.hpp"
#include "hidwa_local_planner/core/planner.hpp"
#include "hidwa_local_planner/core/types.hpp"
#include "hidwa_local_planner/core/util/archive.hpp"
#include "record/recorded_grid.hpp"

namespace hidwa_local_planner {
namespace record {

/// Of the layout of all that CycleRecord holds. Whoever changes that layout changes this number. The planner's state in
/// `loop_state` has a number of its own besides, kLayout in planner.cpp.
constexpr std::uint16_t kFormat = 7;

/// What stays the same over many cycles.
struct Setup {
  std::string version;     // of the package that recorded
  std::string parameters;  // of planner and operator, see to_lines()
  std::string critics;     // the parameters of other packages' critics, as XML-RPC; empty where there are none
  Polygon outline;         // without padding, robot frame [m]

  template <typename Self, typename Archive>
  static void archive(Self& self, Archive& io) {
    io(self.version, self.parameters, self.critics, self.outline);
  }
};

/// What a cycle came to, in so far as two are compared.
struct DecisionRecord {
  Outcome outcome = Outcome::fail;
  Twist2 command;      // sent; zero on failure [m/s, rad/s]
  Twist2 sample;       // chosen [m/s, rad/s]
  Twist2 reference;    // [m/s, rad/s]
  double total = 0.0;  // J
  double agreement = 1.0;
  std::uint32_t candidates = 0;
  std::uint32_t legal = 0;
  /// A hash (64 bit FNV-1a) of the totals of all candidates, the chosen trajectory, the terms, the rejections and
  /// the kind of problem. Not of the words: they may become better from one release to the next.
  std::uint64_t digest = 0;

  template <typename Self, typename Archive>
  static void archive(Self& self, Archive& io) {
    io(self.outcome, self.command, self.sample, self.reference, self.total, self.agreement, self.candidates, self.legal,
       self.digest);
  }
};

/// Of the cycle that `planner` has just decided; where an input was missing, of the fault brake.
DecisionRecord decision_record(const control::Result& result, const Planner& planner);
/// Of a cycle that planned; `totals`: see Planner::totals().
DecisionRecord decision_record(const Decision& decision, const std::vector<double>& totals);
/// The same to the bit.
bool identical(const DecisionRecord& a, const DecisionRecord& b);
bool identical(const OperatorIntent& a, const OperatorIntent& b);

/// One control cycle: all that it was decided from, and what was decided.
struct CycleRecord {
  std::uint32_t sequence = 0;              // one more than that of the record before, or it is a key record
  std::optional<Setup> setup;              // a key record has it, and a plan
  std::optional<std::vector<Pose2>> plan;  // where it changed; in its own frame; empty: there is none to follow
  control::Observation observation;        // without its costmap
  std::optional<RecordedGrid> costmap;     // none where an input was missing, for then nothing reads it
  Sampling sampling;
  Bytes loop_state;      // before the cycle, see ControlLoop::save()
  Bytes operator_state;  // before the cycle, see OperatorStateMachine::save()
  OperatorIntent intent;
  DecisionRecord decision;

  template <typename Self, typename Archive>
  static void archive(Self& self, Archive& io) {
    io(self.sequence, self.setup, self.plan, self.observation, self.costmap);
    io(self.sampling.vx_samples, self.sampling.vth_samples, self.sampling.search_poses, self.sampling.report);
    io(self.loop_state, self.operator_state, self.intent, self.decision);
  }
  double time() const { return observation.timing.now; }  // [s]
};

/// As bytes.
void encode(const CycleRecord& record, Bytes& bytes);
/// The fault in words, empty when the record was read. A record without a fault can be given to a ControlLoop.
std::string decode(const Bytes& bytes, CycleRecord& record);

}  // namespace record
}  // namespace hidwa_local_planner
