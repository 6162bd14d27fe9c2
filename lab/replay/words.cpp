// SPDX-License-Identifier: BSD-3-Clause
#include "words.hpp"

namespace hidwa_local_planner {
namespace replay {

std::string in_words(const Twist2& u) { return format("(%.4f m/s, %.4f rad/s)", u.v, u.omega); }

std::string in_words(const record::DecisionRecord& decision) {
  return format("%-5s %s", to_string(decision.outcome), in_words(decision.command).c_str());
}

}  // namespace replay
}  // namespace hidwa_local_planner
