// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "hidwa_local_planner/core/parameters.hpp"
#include "sim/mover.hpp"
#include "sim/operator.hpp"
#include "study/barn_person.hpp"

namespace hidwa_local_planner {
namespace study {

/// Room among people who walk on as they do now, and among the obstacles that `walls` knows, which may be empty.
Room room_among(std::shared_ptr<const sim::People> people, Room walls);

/// Who steers in a mode: AUTONOMY nobody (null), HELPFUL, HOSTILE, AFTERMATH: HOSTILE for 20 s.
std::shared_ptr<sim::Operator> person_among(const std::string& mode, const Parameters& parameters, Room room,
                                            std::uint64_t seed);

}  // namespace study
}  // namespace hidwa_local_planner
