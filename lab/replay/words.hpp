// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "core/util/words.hpp"
#include "record/cycle_record.hpp"

namespace hidwa_local_planner {
namespace replay {

/// "DRIVE (0.500 m/s, -0.123 rad/s)"
std::string in_words(const record::DecisionRecord& decision);
/// "(0.500 m/s, -0.123 rad/s)"
std::string in_words(const Twist2& u);

}  // namespace replay
}  // namespace hidwa_local_planner
