// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "hidwa_local_planner/core/operator_intent.hpp"
#include "hidwa_local_planner/core/planner.hpp"
#include "hidwa_local_planner/core/types.hpp"
#include "hidwa_local_planner/core/util/archive.hpp"
#include "hidwa_local_planner/record/grid_chain.hpp"

namespace hidwa_local_planner {
namespace record {

/// Changes whenever older readers would misread a record.
constexpr std::uint16_t kFormat = 3;

/// What stays the same over many cycles; part of every key record.
struct Setup {
  std::string version;     // of the package that recorded
  std::string parameters;  // of the planner, see to_lines()
  /// The operator machine's, where they are not the planner's: in older recordings it had new ones a cycle earlier.
  std::string operator_parameters;
  std::string critics;  // the parameters of other packages' critics, as XML-RPC; empty where there are none
  Polygon outline;      // without padding, robot frame [m]

  template <typename Self, typename Archive>
  static void archive(Self& self, Archive& io) {
    io(self.version, self.parameters, self.operator_parameters, self.critics, self.outline);
  }
};

/// The input of a cycle that planned.
struct PlannerInput {
  Bytes state;  // of the planner before the cycle, see Planner::save()
  Situation situation;
  Sampling sampling;
  GridPatch grid;

  template <typename Self, typename Archive>
  static void archive(Self& self, Archive& io) {
    io(self.state, self.situation.pose, self.situation.velocity, self.situation.last_command, self.situation.plan,
       self.situation.goal, self.situation.goal_latched, self.situation.period, self.situation.longest_period,
       self.situation.pose_age, self.situation.resumed, self.situation.time, self.sampling.vx_samples,
       self.sampling.vth_samples, self.sampling.report, self.grid);
  }
};

/// The input of a cycle that could only brake, since something was missing.
struct BrakeInput {
  Bytes state;                     // of the FaultBrake before the cycle
  std::optional<Twist2> velocity;  // measured, where odometry was at hand [m/s, rad/s]
  Twist2 last_command;             // [m/s, rad/s]
  double period = 0.0;             // [s]
  std::string fault;               // what was missing

  template <typename Self, typename Archive>
  static void archive(Self& self, Archive& io) {
    io(self.state, self.velocity, self.last_command, self.period, self.fault);
  }
};

/// What a cycle came to, in so far as two are compared.
struct Verdict {
  Outcome outcome = Outcome::fail;
  Twist2 command;      // sent; zero on failure [m/s, rad/s]
  Twist2 sample;       // chosen [m/s, rad/s]
  Twist2 reference;    // [m/s, rad/s]
  double total = 0.0;  // J
  double agreement = 1.0;
  std::uint32_t candidates = 0;
  std::uint32_t legal = 0;
  /// A hash (64 bit FNV-1a) of the totals of all candidates, the chosen trajectory, the terms, the refusals and the
  /// words.
  std::uint64_t digest = 0;

  template <typename Self, typename Archive>
  static void archive(Self& self, Archive& io) {
    io(self.outcome, self.command, self.sample, self.reference, self.total, self.agreement, self.candidates, self.legal,
       self.digest);
  }
};

/// Of a cycle that planned; `totals`: see Planner::totals().
Verdict verdict_of(const Decision& decision, const std::vector<double>& totals);
/// Of a cycle that could only brake.
Verdict verdict_of(Outcome outcome, const Twist2& command);
/// The same to the bit.
bool identical(const Verdict& a, const Verdict& b);
bool identical(const OperatorIntent& a, const OperatorIntent& b);

/// One control cycle: all that it was decided from, and what was decided.
struct CycleRecord {
  std::uint32_t sequence = 0;  // one more than that of the record before, or it is a key record
  std::optional<Setup> setup;  // a key record has it, and a whole grid
  double time = 0.0;           // [s]
  Bytes operator_state;        // of the operator machine before the cycle
  OperatorIntent intent;       // what the machine said
  bool host_stops = false;     // the host stopped the robot whatever that was, as when it is cancelled
  std::optional<PlannerInput> planned;
  std::optional<BrakeInput> braked;  // this or that
  Verdict verdict;

  template <typename Self, typename Archive>
  static void archive(Self& self, Archive& io) {
    io(self.sequence, self.setup, self.time, self.operator_state, self.intent, self.host_stops, self.planned,
       self.braked, self.verdict);
  }
};

/// As bytes: the format's number, then the record.
void encode(const CycleRecord& record, Bytes& bytes);
/// The fault in words, empty when the record was read.
std::string decode(const Bytes& bytes, CycleRecord& record);

}  // namespace record
}  // namespace hidwa_local_planner
