// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

#include "study/plan.hpp"

namespace hidwa_local_planner {
namespace study {

/// A seed that depends on the study's, on whose it is and on what for, and on nothing else: a participant is
/// the same whoever else takes part, and in whatever order or on whatever machine the runs are made.
std::uint64_t seed_for(std::uint64_t study_seed, int participant, const std::string& purpose);

/// Of a run: of its world, which is the same in all conditions and settings and fits 2^53, so that every reader of CSV
/// takes it for the same number; and of its person, who has another luck in each condition.
struct Seeds {
  std::uint64_t world = 0, person = 0;
};
Seeds seeds_of(std::uint64_t study_seed, const Run& run);

}  // namespace study
}  // namespace hidwa_local_planner
