// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <iosfwd>

#include "hidwa_local_planner/core/operator_intent.hpp"
#include "hidwa_local_planner/core/planner.hpp"
#include "result.hpp"
#include "spec.hpp"

namespace hidwa_attack {

using hidwa_local_planner::OperatorStateId;
using hidwa_local_planner::Outcome;

/// A cycle of a drive, as who looks on sees it.
struct CycleSeen {
  int now = 0;         // [ms]
  double spent = 0.0;  // computing time of the planner's thread [s]
  OperatorStateId state = OperatorStateId::autonomy;
  Outcome outcome = Outcome::fail;
};
using Onlooker = std::function<void(const CycleSeen&)>;

/// Drives one drive; the same spec and seed give the same result. A drive ends a second after the first touch. With
/// `trace` a CSV line every 10 ms.
DriveResult drive(const Spec& spec, std::uint64_t seed, std::ostream* trace = nullptr, const Onlooker& onlooker = {});

}  // namespace hidwa_attack
