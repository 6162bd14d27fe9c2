// SPDX-License-Identifier: BSD-3-Clause
#include "core/planner/decision_memory.hpp"

#include <algorithm>
#include <utility>

namespace hidwa_local_planner {
namespace {

// More than any problem has characters.
constexpr std::size_t kLongestProblem = 200;

}  // namespace

void reserve(Decision& decision, const CriticSet& critics) {
  decision.terms.reserve(critics.size() + 1);
  decision.rejections.reserve(critics.size() + kFirstCritic);
  decision.problem.reserve(kLongestProblem);
  for (const CriticSet::Entry& entry : critics) {
    decision.operator_rejected_by.reserve(std::max(kLongestProblem, entry.name.size()));
  }
}

void clear(Decision& decision) {
  Decision empty;
  std::swap(empty.trajectory, decision.trajectory);
  std::swap(empty.terms, decision.terms);
  std::swap(empty.rejections, decision.rejections);
  std::swap(empty.operator_rejected_by, decision.operator_rejected_by);
  std::swap(empty.problem, decision.problem);
  empty.trajectory.clear();
  empty.terms.clear();
  empty.rejections.clear();
  empty.operator_rejected_by.clear();
  empty.problem.clear();
  decision = std::move(empty);
}

void write(const CycleStart& start, const Conclusion& conclusion, Decision& decision) {
  decision.outcome = conclusion.outcome;
  decision.command = conclusion.command;
  decision.sample = conclusion.sample;
  decision.problem_kind = conclusion.problem_kind;
  decision.problem = conclusion.problem;
  decision.reference = start.reference;
  decision.pose = start.pose;
  decision.velocity = start.velocity;
  decision.odometry_doubted = start.odometry_doubted;
  decision.odometry_fast = start.odometry_fast;
}

}  // namespace hidwa_local_planner
