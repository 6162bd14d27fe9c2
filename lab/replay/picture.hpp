// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace hidwa_local_planner {
namespace replay {

/// Has replay_picture draw `data` (its `kind`: cycle or changes) into `png`. Returns what went wrong, in words; empty
/// where nothing did.
std::string draw(const std::string& kind, const std::string& data, const std::string& png);

}  // namespace replay
}  // namespace hidwa_local_planner
