// SPDX-License-Identifier: BSD-3-Clause
#include "ros/cycle_result.hpp"

namespace hidwa_local_planner {

const char* const kEscapes = "the robot is in collision: it only moves out of it";

std::string rejections_in_words(const Decision& decision) {
  std::string text = decision.problem;
  if (decision.candidates > 0) text += " (of " + std::to_string(decision.candidates) + " candidates";
  for (const RejectionCount& rejection : decision.rejections) {
    if (rejection.count == 0) continue;
    text += ", ";
    text += rejection.name;
    text += " rejects " + std::to_string(rejection.count);
  }
  if (decision.candidates > 0) text += ")";
  return text;
}

std::string in_words(const CycleResult& result) {
  if (result.decision == nullptr) return result.fault;
  if (!result.decision->problem.empty()) return rejections_in_words(*result.decision);
  return result.decision->escaping ? kEscapes : "";
}

}  // namespace hidwa_local_planner
