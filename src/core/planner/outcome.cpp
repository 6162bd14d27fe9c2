// SPDX-License-Identifier: BSD-3-Clause
#include "hidwa_local_planner/core/decision.hpp"

namespace hidwa_local_planner {

const char* to_string(Outcome outcome) {
  switch (outcome) {
    case Outcome::drive:
      return "DRIVE";
    case Outcome::brake:
      return "BRAKE";
    case Outcome::fail:
      return "FAIL";
    case Outcome::hold:
      return "HOLD";
  }
  return "UNKNOWN";
}

}  // namespace hidwa_local_planner
