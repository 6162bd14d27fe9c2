// SPDX-License-Identifier: BSD-3-Clause
#include "core/planner/decision_memory.hpp"

#include <algorithm>
#include <utility>

namespace hidwa_local_planner {
namespace {

// More than any problem has characters.
constexpr std::size_t kLongestProblem = 120;

}  // namespace

void reserve(Decision& decision, const CriticSet& critics) {
  decision.terms.reserve(critics.size() + 1);
  decision.refusals.reserve(critics.size() + kFirstCritic);
  decision.problem.reserve(kLongestProblem);
  for (const CriticSet::Entry& entry : critics) {
    decision.operator_refused_by.reserve(std::max(kLongestProblem, entry.name.size()));
  }
}

void clear(Decision& decision) {
  Decision empty;
  std::swap(empty.trajectory, decision.trajectory);
  std::swap(empty.terms, decision.terms);
  std::swap(empty.refusals, decision.refusals);
  std::swap(empty.operator_refused_by, decision.operator_refused_by);
  std::swap(empty.problem, decision.problem);
  empty.trajectory.clear();
  empty.terms.clear();
  empty.refusals.clear();
  empty.operator_refused_by.clear();
  empty.problem.clear();
  decision = std::move(empty);
}

}  // namespace hidwa_local_planner
