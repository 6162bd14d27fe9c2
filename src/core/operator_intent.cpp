// SPDX-License-Identifier: BSD-3-Clause
#include "hidwa_local_planner/core/operator_intent.hpp"

namespace hidwa_local_planner {

const char* to_string(OperatorStateId state) {
  switch (state) {
    case OperatorStateId::autonomy:
      return "AUTONOMY";
    case OperatorStateId::shared:
      return "SHARED";
    case OperatorStateId::hold:
      return "HOLD";
    case OperatorStateId::manual:
      return "MANUAL";
    case OperatorStateId::stopped:
      return "STOPPED";
    case OperatorStateId::lost:
      return "LOST";
    case OperatorStateId::blocked:
      return "BLOCKED";
  }
  return "UNKNOWN";
}

}  // namespace hidwa_local_planner
