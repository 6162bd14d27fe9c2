// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

namespace hidwa_local_planner {
namespace study {

/// A seed that depends on the study's, on whose it is and on what for, and on nothing else: a participant is
/// the same whoever else takes part, and in whatever order or on whatever machine the runs are made.
std::uint64_t seed_for(std::uint64_t study_seed, int participant, const std::string& purpose);

}  // namespace study
}  // namespace hidwa_local_planner
